//! Counted work: what the lectures call expensive, as exact and repeatable numbers.
//!
//! A technique takes `&mut impl Count` and reports where the operation happens. [`Work`] keeps the numbers;
//! `()` keeps none and costs nothing, so the plain entry of a technique passes `&mut ()`.

use core::fmt;

/// Receives the counts of a technique.
pub trait Count {
    /// Adds `n` to the counter named `what`.
    fn add(&mut self, what: Counter, n: u64);
}

/// Counts nothing, at no cost.
impl Count for () {
    #[inline(always)]
    fn add(&mut self, _: Counter, _: u64) {}
}

impl<C: Count + ?Sized> Count for &mut C {
    #[inline(always)]
    fn add(&mut self, what: Counter, n: u64) {
        (**self).add(what, n);
    }
}

macro_rules! counters {
    ($($(#[$doc:meta])* $field:ident $variant:ident $name:literal;)*) => {
        /// The name of a counter of [`Work`].
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[non_exhaustive]
        pub enum Counter {
            $($(#[$doc])* $variant,)*
        }

        impl Counter {
            /// All counters, in the order of [`Work`]'s fields.
            pub const ALL: &[Counter] = &[$(Counter::$variant),*];

            /// The counter's name in tables: `depth tests`.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self { $(Counter::$variant => $name),* }
            }
        }

        /// How often each operation happened.
        ///
        /// # Examples
        ///
        /// ```
        /// use ombra_math::work::{Count, Counter, Work};
        ///
        /// fn halve(values: &mut [f64], work: &mut impl Count) {
        ///     for v in values {
        ///         *v *= 0.5;
        ///         work.add(Counter::Multiplications, 1);
        ///     }
        /// }
        ///
        /// let mut work = Work::default();
        /// halve(&mut [1.0, 2.0, 3.0], &mut work);
        /// assert_eq!(work.multiplications, 3);
        /// assert_eq!(work.to_string(), "3 multiplications");
        /// halve(&mut [1.0], &mut ()); // nobody asked: nothing is counted
        /// ```
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub struct Work {
            $($(#[$doc])* pub $field: u64,)*
        }

        impl Work {
            /// The value of the counter named `what`.
            #[must_use]
            pub const fn get(&self, what: Counter) -> u64 {
                match what { $(Counter::$variant => self.$field),* }
            }
        }

        impl Count for Work {
            #[inline]
            fn add(&mut self, what: Counter, n: u64) {
                let counter = match what { $(Counter::$variant => &mut self.$field),* };
                *counter = counter.saturating_add(n);
            }
        }
    };
}

counters! {
    /// Fragments made by a rasterizer.
    fragments Fragments "fragments";
    /// Comparisons with a depth buffer.
    depth_tests DepthTests "depth tests";
    /// Operations on a stencil buffer.
    stencil_ops StencilOps "stencil operations";
    /// Pairs of primitives compared with each other.
    pairs Pairs "pairs";
    /// Rays cast.
    rays Rays "rays";
    /// Intersections of a ray with the plane of a primitive.
    intersections Intersections "intersections";
    /// Samples a filter reads.
    taps Taps "filter taps";
    /// Texels read.
    texels Texels "texels";
    /// Vertices transformed, cast or clipped.
    vertices Vertices "vertices";
    /// Edge records written or found.
    edge_records EdgeRecords "edge records";
    /// Multiplications.
    multiplications Multiplications "multiplications";
    /// Additions and subtractions.
    additions Additions "additions";
    /// Divisions.
    divisions Divisions "divisions";
    /// Roundings of a number to an integer.
    roundings Roundings "roundings";
    /// Comparisons of numbers.
    comparisons Comparisons "comparisons";
    /// Decisions or results that needed exact arithmetic.
    exact_fallbacks ExactFallbacks "exact fallbacks";
}

/// The counters that are not zero, separated by commas.
impl fmt::Display for Work {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut separator = "";
        for &what in Counter::ALL {
            let n = self.get(what);
            if n > 0 {
                write!(f, "{separator}{n} {}", what.name())?;
                separator = ", ";
            }
        }
        if separator.is_empty() {
            f.write_str("no work")
        } else {
            Ok(())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_counter_reaches_its_own_field() {
        let mut work = Work::default();
        for (i, &what) in Counter::ALL.iter().enumerate() {
            work.add(what, i as u64 + 1);
        }
        for (i, &what) in Counter::ALL.iter().enumerate() {
            assert_eq!(work.get(what), i as u64 + 1, "{}", what.name());
        }
        assert_eq!(
            (work.fragments, work.depth_tests, work.exact_fallbacks),
            (1, 2, 16)
        );
    }

    #[test]
    fn a_full_counter_stays_full() {
        let mut work = Work {
            rays: u64::MAX,
            ..Work::default()
        };
        work.add(Counter::Rays, 1);
        assert_eq!(work.rays, u64::MAX);
    }

    #[test]
    fn no_work_says_so() {
        assert_eq!(Work::default().to_string(), "no work");
    }
}
