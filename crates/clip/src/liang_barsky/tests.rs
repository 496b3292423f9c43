use super::*;
use crate::extremes::{check, lecture, segment};
use ombra_math::work::Work;

#[test]
fn degenerate() {
    check(clip_segment);
}

#[test]
fn only_what_is_left_is_intersected() {
    let count = |s| {
        let mut work = Work::default();
        let _ = counted::clip_segment(&lecture(), s, &mut work);
        [work.divisions, work.multiplications]
    };
    // Entry and exit are parallel sides, their t compared without a product; then sides at an angle.
    assert_eq!(count(segment((-5.0, 5.0), (15.0, 5.0))), [2, 0]);
    assert_eq!(count(segment((-5.0, 5.0), (5.0, 15.0))), [2, 2]);
    assert_eq!(count(segment((-6.0, 5.0), (5.0, 16.0))), [0, 2]);
}
