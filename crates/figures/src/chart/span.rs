//! What an axis shows: from where to where, and its ticks.

use core::ops::Range;

use super::{Axis, Scale};
use crate::error::FigureError;
use crate::number::{decimal, round_step};

#[derive(Debug)]
pub(super) struct Tick {
    pub(super) value: f64,
    pub(super) text: String,
    /// A power of ten, or a tick of a linear axis: the ones that keep their labels where room is short.
    pub(super) is_whole: bool,
}

/// What an axis shows.
#[derive(Debug)]
pub(super) struct Span {
    scale: Scale,
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) ticks: Vec<Tick>,
    /// Whether there are values in the band of zeros.
    pub(super) zeros: bool,
}

impl Span {
    /// As much of `axis` as `values` need; a logarithmic one that `clears` them begins below the lowest.
    pub(super) fn new(
        axis: &Axis,
        values: impl Iterator<Item = f64>,
        clears: bool,
    ) -> Result<Span, FigureError> {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        let mut zeros = false;
        for value in values {
            if axis.is_zero(value) {
                zeros = true;
                continue;
            }
            let shown =
                value.is_finite() && (axis.scale == Scale::Linear || value >= f64::MIN_POSITIVE);
            if !shown {
                let allowed = match axis.scale {
                    Scale::Linear => "finite numbers",
                    Scale::Log => "finite numbers above 0",
                };
                return Err(FigureError::Chart {
                    reason: format!(
                        "{value} cannot be shown on the axis '{}': it takes {allowed}",
                        axis.title
                    ),
                });
            }
            (low, high) = (low.min(value), high.max(value));
        }
        if low > high && zeros {
            // Nothing but zeros: a decade without ticks above their band.
            return Ok(Span {
                scale: Scale::Log,
                low: 1.0,
                high: 10.0,
                ticks: Vec::new(),
                zeros,
            });
        }
        if low > high {
            return Err(FigureError::Chart {
                reason: format!(
                    "the axis '{}' has no values: a chart is at least one point",
                    axis.title
                ),
            });
        }
        let span = match axis.scale {
            Scale::Linear if !axis.at.is_empty() => Span::at(&axis.at, low, high),
            Scale::Linear => Span::linear(low, high),
            Scale::Log => Span::log(low, high, clears),
        };
        let span = span.map(|span| Span { zeros, ..span });
        span.ok_or_else(|| FigureError::Chart {
            reason: format!(
                "the values {low} to {high} on the axis '{}' are too far apart to show",
                axis.title
            ),
        })
    }

    /// Ticks at given values, and no farther than they and the values reach.
    fn at(ticks: &[f64], low: f64, high: f64) -> Option<Span> {
        let all = || ticks.iter().copied().filter(|tick| tick.is_finite());
        let (low, high) = (all().fold(low, f64::min), all().fold(high, f64::max));
        let mut ticks: Vec<f64> = all().collect();
        ticks.sort_by(f64::total_cmp);
        let tick = |value| Tick {
            value,
            text: decimal(value),
            is_whole: true,
        };
        (low < high && (high - low).is_finite()).then(|| Span {
            scale: Scale::Linear,
            low,
            high,
            ticks: ticks.into_iter().map(tick).collect(),
            zeros: false,
        })
    }

    /// Whole steps of 1, 2 or 5 times a power of ten.
    fn linear(low: f64, high: f64) -> Option<Span> {
        let widened = if low == high {
            0.5 * low.abs().max(1.0)
        } else {
            0.0
        };
        let (low, high) = (low - widened, high + widened);
        let step = round_step((high - low) / 6.0);
        if step == 0.0 {
            return None;
        }
        let (first, last) = ((low / step).floor(), (high / step).ceil());
        if last - first > 20.0 {
            return None;
        }
        let ticks = (0..=(last - first) as u32)
            .map(|i| (first + f64::from(i)) * step)
            .map(|value| Tick {
                value,
                text: decimal(value),
                is_whole: true,
            })
            .collect();
        Some(Span {
            scale: Scale::Linear,
            low: first * step,
            high: last * step,
            ticks,
            zeros: false,
        })
    }

    /// Whole decades; where they are few, from 1, 2 or 5 times a power of ten to another, and where they are one or two, with
    /// ticks there. Its lower end lies
    /// [`CLEAR`] below every value if it `clears` them.
    fn log(low: f64, high: f64, clears: bool) -> Option<Span> {
        // At the end of the range of doubles there is no decade below.
        let below = Some(low / CLEAR).filter(|x| clears && power(1, decade(*x)).is_some());
        let least = below.unwrap_or(low);
        let (mut first, mut last) = (decade(least), decade(high));
        if power(1, last)? < high {
            last += 1;
        }
        if first == last {
            (first, last) = (first - 1, last + 1);
        }
        let few = last - first <= SHORT;
        // Where the decades are few, a part of one is a large part of the axis.
        let parts = if few {
            Span::parts_of_decades(first, last, least, high)?
        } else {
            Vec::new()
        };
        let ends = match (parts.first(), parts.last()) {
            (Some(first), Some(last)) => (first.value, last.value),
            _ => (power(1, first)?, power(1, last)?),
        };
        let mut ticks = if few && ends.1 / ends.0 <= DENSE {
            parts
        } else {
            Span::decades(first, last)?
        };
        ticks.retain(|tick| ends.0 <= tick.value && tick.value <= ends.1);
        Some(Span {
            scale: Scale::Log,
            low: ends.0,
            high: ends.1,
            ticks,
            zeros: false,
        })
    }

    /// 1, 2, 5 of every decade, from the last that is at most `low` to the first that is at least `high`.
    fn parts_of_decades(first: i32, last: i32, low: f64, high: f64) -> Option<Vec<Tick>> {
        let all = (first..last).flat_map(|exponent| [1, 2, 5].map(|digit| (digit, exponent)));
        let mut ticks = Vec::new();
        for (digit, exponent) in all.chain([(1, last)]) {
            ticks.push(Tick::new(digit, exponent, is_plain(first, last))?);
        }
        let below = ticks.iter().rposition(|tick| tick.value <= low);
        let above = ticks.iter().position(|tick| tick.value >= high);
        ticks.truncate(above.unwrap_or(ticks.len()).saturating_add(1));
        ticks.drain(..below.unwrap_or(0));
        Some(ticks)
    }

    /// Every power of ten, or every second, third … where they are many, from the lowest on.
    fn decades(first: i32, last: i32) -> Option<Vec<Tick>> {
        let every = (last - first + 7) / 8;
        (first..=last)
            .filter(|e| (e - first) % every == 0)
            .map(|exponent| Tick::new(1, exponent, is_plain(first, last)))
            .collect()
    }

    /// Which ticks have labels where each takes a share `sizes` of the axis' length, its gap included: all, or those of
    /// whole decades, or every second, third … from the lowest on.
    pub(super) fn labelled(&self, sizes: &[f64]) -> Vec<bool> {
        let (from, to) = (self.place(self.low), self.place(self.high));
        let shares: Vec<f64> = self
            .ticks
            .iter()
            .map(|tick| (self.place(tick.value) - from) / (to - from))
            .collect();
        let fits = |chosen: &[usize]| {
            let pairs = chosen.iter().zip(chosen.iter().skip(1));
            pairs.into_iter().all(|(&a, &b)| {
                let at = |i: usize| {
                    (
                        shares.get(i).copied().unwrap_or(0.0),
                        sizes.get(i).copied().unwrap_or(0.0),
                    )
                };
                let ((a, wide), (b, next)) = (at(a), at(b));
                b - a >= 0.5 * (wide + next)
            })
        };
        let all: Vec<usize> = (0..self.ticks.len()).collect();
        let is_whole = |i: &usize| self.ticks.get(*i).is_some_and(|tick| tick.is_whole);
        let whole: Vec<usize> = all.iter().copied().filter(is_whole).collect();
        let mut chosen = all;
        if !fits(&chosen) {
            // One label alone tells no scale.
            let from = if whole.len() > 1 { whole } else { chosen };
            let every =
                (1..=from.len()).map(|n| from.iter().copied().step_by(n).collect::<Vec<_>>());
            chosen = every
                .into_iter()
                .find(|chosen| fits(chosen))
                .unwrap_or_default();
        }
        (0..self.ticks.len()).map(|i| chosen.contains(&i)).collect()
    }

    /// Position along the axis in its own measure.
    pub(super) fn place(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear => value,
            Scale::Log => libm::log10(value),
        }
    }

    pub(super) fn range(&self) -> Range<f64> {
        self.place(self.low)..self.place(self.high)
    }
}

/// A factor above its axis' lower end, at least, for the lowest mark, lest it lie among the ticks: 0.15 decades.
const CLEAR: f64 = 1.412_537_544_622_754_3;

/// The most decades of an axis that begins and ends within one, not at its borders.
const SHORT: i32 = 4;

/// The greatest ratio of its ends for which an axis has ticks at 1, 2 and 5.
const DENSE: f64 = 200.0;

/// Near 1 as plain numbers, otherwise all as powers.
fn is_plain(first: i32, last: i32) -> bool {
    first >= -2 && last <= 4
}

impl Tick {
    fn new(digit: u32, exponent: i32, plain: bool) -> Option<Tick> {
        let value = power(digit, exponent)?;
        let sign = format!("{exponent}").replace('-', "−");
        let text = match digit {
            _ if plain => decimal(value),
            1 => format!("10^{{{sign}}}"),
            _ => format!("{digit}·10^{{{sign}}}"),
        };
        Some(Tick {
            value,
            text,
            is_whole: digit == 1,
        })
    }
}

/// The greatest k with 10ᵏ ≤ value, by the printed exponent, which is exact.
fn decade(value: f64) -> i32 {
    format!("{value:e}")
        .split_once('e')
        .and_then(|(_, e)| e.parse().ok())
        .unwrap_or(0)
}

/// digit · 10ᵏ, the nearest double; none where there is no normal one.
fn power(digit: u32, exponent: i32) -> Option<f64> {
    let value: f64 = format!("{digit}e{exponent}").parse().ok()?;
    value.is_normal().then_some(value)
}
