//! Step budgets: a loop that never ends is stopped and told so.

/// A number of steps that an algorithm may take.
///
/// A callback that the student's loop must call, a pixel plotted or a node visited, takes one step each.
#[derive(Clone, Debug)]
pub struct Steps {
    limit: usize,
    taken: usize,
}

impl Steps {
    /// A budget of `limit` steps.
    #[must_use]
    pub fn new(limit: usize) -> Self {
        Self { limit, taken: 0 }
    }

    /// Takes one step.
    ///
    /// # Panics
    ///
    /// When the budget is used up.
    #[track_caller]
    pub fn take(&mut self, what: &str) {
        assert!(
            self.taken < self.limit,
            "{what}: {} steps were enough and the loop still runs: when does it end?",
            self.limit,
        );
        self.taken += 1;
    }

    /// How many steps were taken.
    #[must_use]
    pub fn taken(&self) -> usize {
        self.taken
    }
}

/// Collects what an iterator gives, at most `limit` items.
///
/// # Panics
///
/// When it gives more.
#[track_caller]
pub fn collect_within<T>(what: &str, limit: usize, items: impl IntoIterator<Item = T>) -> Vec<T> {
    let mut steps = Steps::new(limit);
    let mut collected = Vec::new();
    for item in items {
        steps.take(what);
        collected.push(item);
    }
    collected
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_budget_allows_its_limit() {
        assert_eq!(collect_within("counting", 3, 0..3), [0, 1, 2]);
        assert!(collect_within("counting", 0, 0..0).is_empty());
        let mut steps = Steps::new(2);
        steps.take("walking");
        assert_eq!(steps.taken(), 1);
    }

    #[test]
    #[should_panic(
        expected = "counting: 9 steps were enough and the loop still runs: when does it end?"
    )]
    fn a_loop_without_an_end_is_stopped() {
        collect_within("counting", 9, std::iter::repeat(()));
    }
}
