//! What an axis shows: from where to where, and its ticks.

use core::ops::Range;

use super::{Axis, Scale};
use crate::error::FigureError;
use crate::number::{decimal, round_step};

#[derive(Debug)]
pub(super) struct Tick {
    pub(super) value: f64,
    pub(super) text: String,
}

/// What an axis shows.
#[derive(Debug)]
pub(super) struct Span {
    scale: Scale,
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) ticks: Vec<Tick>,
}

impl Span {
    /// As much of `axis` as `values` need; a logarithmic one that `clears` them begins below the lowest.
    pub(super) fn new(
        axis: &Axis,
        values: impl Iterator<Item = f64>,
        clears: bool,
    ) -> Result<Span, FigureError> {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for value in values {
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
        if low > high {
            return Err(FigureError::Chart {
                reason: format!(
                    "the axis '{}' has no values: a chart is at least one point",
                    axis.title
                ),
            });
        }
        let span = match axis.scale {
            Scale::Linear => Span::linear(low, high),
            Scale::Log => Span::log(low, high, clears),
        };
        span.ok_or_else(|| FigureError::Chart {
            reason: format!(
                "the values {low} to {high} on the axis '{}' are too far apart to show",
                axis.title
            ),
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
            })
            .collect();
        Some(Span {
            scale: Scale::Linear,
            low: first * step,
            high: last * step,
            ticks,
        })
    }

    /// Whole decades; where they are one or two, from 1, 2 or 5 times a power of ten to another. Its lower end lies
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
        let ticks = if last - first <= 2 {
            Span::parts_of_decades(first, last, least, high)?
        } else {
            Span::decades(first, last)?
        };
        Some(Span {
            scale: Scale::Log,
            low: ticks.first()?.value,
            high: ticks.last()?.value,
            ticks,
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

    /// Every power of ten, or every second, third … where they are many; the highest label is at the upper end, like
    /// the lowest at the lower.
    fn decades(first: i32, mut last: i32) -> Option<Vec<Tick>> {
        let every = (last - first + 7) / 8;
        last += (every - (last - first) % every) % every;
        (first..=last)
            .filter(|e| (e - first) % every == 0)
            .map(|exponent| Tick::new(1, exponent, is_plain(first, last)))
            .collect()
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
        Some(Tick { value, text })
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
