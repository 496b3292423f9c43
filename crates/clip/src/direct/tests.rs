use super::*;
use crate::extremes::{check, lecture, segment};
use ombra_math::work::Work;

#[test]
fn degenerate() {
    check(clip_segment);
}

#[test]
fn parallel_sides_are_not_intersected() {
    let count = |s| {
        let mut work = Work::default();
        let _ = counted::clip_segment(&lecture(), s, &mut work);
        work.divisions
    };
    assert_eq!(count(segment((-5.0, 5.0), (15.0, 5.0))), 2);
    assert_eq!(count(segment((-5.0, 15.0), (15.0, -6.0))), 4);
    assert_eq!(count(segment((1.0, 1.0), (1.0, 1.0))), 0);
}
