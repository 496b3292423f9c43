//! Who takes which of the places that each label could have.

use super::Place;

/// Times that all labels are looked at again; three or four are enough in practice.
const ROUNDS: usize = 12;
/// Labels that get the chance to begin.
pub(super) const STARTS: usize = 12;
/// What a label without a place costs: more than any place.
const UNPLACED: f64 = 1e5;

/// The places to choose from, and the choice.
pub(super) struct Board {
    pub(super) candidates: Vec<Vec<(f64, Place)>>,
    chosen: Vec<Option<usize>>,
}

impl Board {
    /// Labels take places in turn, `first` at first, then better ones.
    pub(super) fn start(candidates: Vec<Vec<(f64, Place)>>, first: usize) -> Board {
        let count = candidates.len();
        let mut board = Board {
            candidates,
            chosen: vec![None; count],
        };
        let turn = |i: usize| (first + i) % count.max(1);
        for i in 0..count {
            let free = board.best_free(turn(i));
            board.set(turn(i), free);
        }
        for _ in 0..ROUNDS {
            // Every label gets its turn, so no short-circuit.
            let improved = (0..count).filter(|&i| board.improve(turn(i))).count();
            if improved == 0 {
                break;
            }
        }
        board
    }

    pub(super) fn total(&self) -> f64 {
        (0..self.chosen.len()).map(|label| self.cost(label)).sum()
    }

    fn candidate(&self, label: usize, choice: usize) -> Option<&(f64, Place)> {
        self.candidates.get(label)?.get(choice)
    }

    pub(super) fn place(&self, label: usize) -> Option<&(f64, Place)> {
        self.candidate(label, (*self.chosen.get(label)?)?)
    }

    fn set(&mut self, label: usize, choice: Option<usize>) {
        if let Some(slot) = self.chosen.get_mut(label) {
            *slot = choice;
        }
    }

    fn cost(&self, label: usize) -> f64 {
        self.place(label).map_or(UNPLACED, |(cost, _)| *cost)
    }

    /// The labels whose places meet `place`.
    fn met_by(&self, label: usize, place: &Place) -> Vec<usize> {
        let meets = |&other: &usize| {
            other != label
                && self
                    .place(other)
                    .is_some_and(|(_, chosen)| !place.is_free_of(chosen))
        };
        (0..self.chosen.len()).filter(meets).collect()
    }

    /// The best choice of `label` that meets no other label's place.
    fn best_free(&self, label: usize) -> Option<usize> {
        let list = self.candidates.get(label)?;
        list.iter()
            .position(|(_, place)| self.met_by(label, place).is_empty())
    }

    /// Gives `label` a better place if that, with another place for whom it drives out, makes the whole cheaper.
    fn improve(&mut self, label: usize) -> bool {
        let now = self.cost(label);
        for choice in 0..self.candidates.get(label).map_or(0, Vec::len) {
            let Some((cost, place)) = self.candidate(label, choice).copied() else {
                break;
            };
            if cost >= now {
                break;
            }
            let before = self.chosen.clone();
            let driven_out = self.met_by(label, &place);
            let was = now
                + driven_out
                    .iter()
                    .map(|&other| self.cost(other))
                    .sum::<f64>();
            for &other in &driven_out {
                self.set(other, None);
            }
            self.set(label, Some(choice));
            for &other in &driven_out {
                let free = self.best_free(other);
                self.set(other, free);
            }
            let is = cost
                + driven_out
                    .iter()
                    .map(|&other| self.cost(other))
                    .sum::<f64>();
            // Less by more than rounding, so that no two states take turns.
            if is < was - 1e-6 {
                return true;
            }
            self.chosen = before;
        }
        false
    }
}
