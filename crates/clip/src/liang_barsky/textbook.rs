//! The method in plain doubles.

use ombra_math::work::{Count, Counter};

use crate::segment::Segment;
use crate::window::Window;

/// [`clip_segment`](super::clip_segment) as a textbook has it, in plain doubles, counting its [work](crate#counted-work).
///
/// # Formula
///
/// ```text
/// t_k = q_k / p_k rounded, and the points a + t (b − a)
/// ```
///
/// # Properties
///
/// - Error: unbounded: some ε of the ends' coordinates in both coordinates, across the side too.
/// - Any input has an answer. With ends that are not finite it means nothing.
///
/// # Pitfalls
///
/// - Far ends cost digits. What is left of (−3·10¹², 3 − 10¹²) → (3·10¹², 3 + 10¹²) in the lecture's window ends at
///   (10, 6.33333); here at (10, 6.33337).
/// - Rounded t's decide: (−0.1, 9.5) → (0.225, 11.125) passes beside the corner (0, 10) and is kept.
///
/// # Examples
///
/// ```
/// use ombra_clip::{Segment, Window, liang_barsky};
/// use ombra_math::glam::DVec2;
///
/// let window = Window::new(DVec2::ZERO, DVec2::splat(10.0))?;
/// let beside = Segment::new(DVec2::new(-0.1, 9.5), DVec2::new(0.225, 11.125));
/// assert_eq!(liang_barsky::clip_segment(&window, beside), None);
/// assert!(liang_barsky::textbook(&window, beside, &mut ()).is_some());
/// # Ok::<(), ombra_clip::WindowError>(())
/// ```
///
/// # References
///
/// As for [`clip_segment`](super::clip_segment).
#[must_use]
pub fn textbook(window: &Window, segment: Segment, work: &mut impl Count) -> Option<Segment> {
    let Segment { a, b } = segment;
    let d = b - a;
    work.add(Counter::Additions, 2);
    let (mut t_in, mut t_out) = (0.0_f64, 1.0_f64);
    for (p, q) in [
        (-d.x, a.x - window.min.x),
        (d.x, window.max.x - a.x),
        (-d.y, a.y - window.min.y),
        (d.y, window.max.y - a.y),
    ] {
        work.add(Counter::Additions, 1);
        work.add(Counter::Comparisons, 1);
        // Parallel to the side: beyond it everywhere, or nowhere.
        if p == 0.0 {
            if q < 0.0 {
                return None;
            }
            continue;
        }
        // The latest entry, the earliest exit.
        work.add(Counter::Divisions, 1);
        work.add(Counter::Comparisons, 2);
        let t = q / p;
        if p < 0.0 {
            t_in = t_in.max(t);
        } else {
            t_out = t_out.min(t);
        }
        if t_in > t_out {
            return None;
        }
    }
    // An end that is not cut stays as it is.
    let mut at = |t: f64| {
        work.add(Counter::Multiplications, 2);
        work.add(Counter::Additions, 2);
        a + t * d
    };
    Some(Segment {
        a: if t_in > 0.0 { at(t_in) } else { a },
        b: if t_out < 1.0 { at(t_out) } else { b },
    })
}
