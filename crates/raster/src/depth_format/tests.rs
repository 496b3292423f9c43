use ombra_math::glam::DVec4;
use ombra_oracle::Exact;
use proptest::prelude::*;

use super::*;
use crate::buffers::DepthBuffer;

fn r(x: f64) -> Exact {
    Exact::new(x).unwrap()
}

fn share(x: u32, whole: u32) -> Exact {
    Exact::from(x).over(&Exact::from(whole)).unwrap()
}

fn is_within(found: f64, exact: &Exact, roundings: f64) -> bool {
    (r(found) - exact).abs() <= exact.abs() * r(roundings * f64::EPSILON / 2.0)
}

proptest! {
    /// Integers: no other is nearer. f32 is rounded by the processor.
    #[test]
    fn integers_are_the_nearest(value in 0.0..=1.0f64, i in 0..(1u32 << 24)) {
        fn check<F: DepthFormat>(value: f64, max: u32) -> Result<(), TestCaseError>
        where
            F::Stored: Into<u32>,
        {
            let found: u32 = F::encode(value).into();
            let error = (r(value) * Exact::from(max) - Exact::from(found)).abs();
            // Half a step, and the rounding of the product.
            prop_assert!(error <= r(0.5) + Exact::from(max) * r(f64::EPSILON));
            let decoded = F::decode(F::encode(value));
            prop_assert_eq!(F::encode(decoded).into(), found);
            prop_assert!(is_within(decoded, &share(found, max), 1.0));
            prop_assert!(is_within(F::spacing(value), &share(1, max), 1.0));
            Ok(())
        }
        check::<Depth16>(value, 65_535)?;
        check::<Depth24>(value, 16_777_215)?;
        check::<Depth16>((f64::from(i % 65_535) + 0.5) / 65_535.0, 65_535)?;
        check::<Depth24>((f64::from(i % 16_777_215) + 0.5) / 16_777_215.0, 16_777_215)?;
    }

    /// From a value in single precision to the next.
    #[test]
    fn the_spacing_is_to_the_next_single(bits in 0..1.0f32.to_bits()) {
        let [here, next] = [bits, bits + 1].map(|bits| f64::from(f32::from_bits(bits)));
        prop_assert_eq!(Depth32F::spacing(here), next - here);
        prop_assert_eq!(ReversedDepth32F::spacing(0.5 * here + 0.5 * next), next - here);
    }

    /// What a buffer says of a stored depth.
    #[test]
    fn stored_depths_are_read_within_a_rounding(bits in 0..=1.0f32.to_bits(), i in any::<u16>()) {
        let value = f32::from_bits(bits);
        let mut reversed: DepthBuffer<ReversedDepth32F> = DepthBuffer::new(2, 1).unwrap();
        *reversed.stored_mut(1, 0).unwrap() = value;
        let exact = Exact::from(1) - r(f64::from(value));
        prop_assert!(is_within(reversed.depth(1, 0).unwrap(), &exact, 1.0));
        let mut depth: DepthBuffer<Depth16> = DepthBuffer::new(2, 1).unwrap();
        depth.values_mut()[1] = i;
        prop_assert!(is_within(depth.depth(1, 0).unwrap(), &share(i.into(), 65_535), 1.0));
        prop_assert_eq!((depth.depth(0, 0), depth.depth(2, 0)), (Some(1.0), None));
    }

    /// (w ± z) / 2w, two roundings.
    #[test]
    fn the_value_is_within_two_roundings(share in -1.0..=1.0f64, e in -900..1023i32, last in 0..40i32) {
        let w = libm::scalbn(1.3, e);
        for z in [share * w, w * (1.0 - libm::scalbn(1.0, -13 - last)), -w] {
            let p = DVec4::new(0.0, 0.0, z, w);
            for (found, z) in [(Depth24::value(p), z), (ReversedDepth32F::value(p), -z)] {
                let right = (r(w) + r(z)).over(&r(w)).unwrap().scaled(-1);
                prop_assert!(is_within(found, &right, 2.0), "{} {}", z, w);
            }
        }
    }
}

#[test]
fn formats_at_their_ends() {
    assert_eq!([Depth16::encode(0.0), Depth16::encode(1.0)], [0, 65_535]);
    assert_eq!([Depth24::encode(0.0), Depth24::encode(1.0)], [0, 0xff_ffff]);
    assert_eq!([Depth32F::encode(0.0), Depth32F::encode(1.0)], [0.0, 1.0]);
    let (near, far) = (
        DVec4::new(3.0, 1.0, -2.0, 2.0),
        DVec4::new(3.0, 1.0, 2.0, 2.0),
    );
    assert_eq!([Depth24::value(near), Depth24::value(far)], [0.0, 1.0]);
    let reversed = [ReversedDepth32F::value(near), ReversedDepth32F::value(far)];
    assert_eq!(reversed, [1.0, 0.0]);
    // (w − z) / 2w with all its digits, where 1 − (w + z) / 2w has none but the first.
    let nearly_far = DVec4::new(0.0, 0.0, 3.0 - libm::scalbn(1.0, -49), 3.0);
    assert_eq!(
        ReversedDepth32F::value(nearly_far),
        libm::scalbn(1.0, -50) / 3.0
    );
    // Beyond half of the largest double.
    let huge = DVec4::new(0.0, 0.0, 0.0, f64::MAX);
    assert_eq!(Depth24::value(huge), 0.5);
    // What is outside the range is stored as something.
    for value in [f64::NAN, f64::INFINITY, -1.0, 1e300] {
        let _ = (
            Depth16::encode(value),
            Depth24::encode(value),
            Depth32F::encode(value),
        );
    }
    assert_eq!([Depth16::encode(-1.0), Depth16::encode(2.0)], [0, 65_535]);
}

/// What stands for "beyond the far plane" passes no test, not even against a cleared buffer.
#[test]
fn never_is_nearer_than_nothing() {
    fn check<F: DepthFormat>() {
        for held in [F::FAR, F::encode(0.0), F::encode(0.5), F::encode(1.0)] {
            assert!(!F::is_nearer(F::encode(F::NEVER), held), "{}", F::NAME);
        }
    }
    check::<Depth16>();
    check::<Depth24>();
    check::<Depth32F>();
    check::<ReversedDepth32F>();
}
