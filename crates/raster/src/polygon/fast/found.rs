//! Spans that have been found and not yet been given out.

use crate::span::Span;

/// A queue that is filled when it is empty; its memory is used again and again.
#[derive(Clone, Debug, Default)]
pub(super) struct Found {
    spans: Vec<Span>,
    /// How many of them there are.
    count: usize,
    given: usize,
}

impl Found {
    pub fn clear(&mut self) {
        (self.count, self.given) = (0, 0);
    }

    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Places for so many more.
    #[inline]
    pub fn room(&mut self, more: usize) -> &mut [Span] {
        let length = self.count + more;
        if self.spans.len() < length {
            self.spans.resize(length, Span::default());
        }
        self.spans.get_mut(self.count..length).unwrap_or_default()
    }

    /// Keeps the first of those places.
    #[inline]
    pub fn keep(&mut self, spans: usize) {
        self.count += spans;
    }

    #[inline(always)]
    pub fn take(&mut self) -> Option<Span> {
        if self.given >= self.count {
            return None;
        }
        let span = self.spans.get(self.given)?;
        self.given += 1;
        Some(span.clone())
    }
}
