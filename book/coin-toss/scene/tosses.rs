//! Many tosses that differ by as much as a hand is unsure.

use live::prelude::*;
use mechanics::InvalidQuantity;

/// How many tosses are made, how many of them at once, and how long the others take, s of the reader.
pub(super) const TOSSES: u32 = 5000;
const AT_ONCE: u32 = 250;
const TOSSING: f64 = 5.0;
/// How unsure a hand, a steady hand and a machine are: of the moment of the catch, s, and of the spin, as a part of it.
const UNSURE: [[f64; 2]; 3] = [[0.05, 0.1], [0.004, 0.01], [0.0, 0.0]];
/// Bars of the histogram.
const BARS: usize = 36;

/// The tosses that were made after a press of the button: always the same ones for the same press.
#[derive(Default)]
pub(super) struct Tosses {
    pressed: f64,
    pub(super) is_sure: bool,
    /// The part of a precession at which each was caught, and whether heads showed.
    caught: Vec<(f64, bool)>,
}

impl Tosses {
    /// Tosses by one of the hands. `catch` says what is caught after a time.
    pub(super) fn new(
        (hand, pressed, duration): (usize, f64, f64),
        catch: impl Fn(f64) -> Result<(f64, bool), InvalidQuantity>,
    ) -> Result<Self, InvalidQuantity> {
        let [unsure_time, unsure_spin] = UNSURE[hand];
        let mut chance = Chance(pressed.to_bits());
        let mut caught = Vec::new();
        for _ in 0..TOSSES {
            // So much faster in all, it is where the mean toss is so much later.
            let spin = 1.0 + unsure_spin * chance.between_ends();
            caught.push(catch(spin * (duration + unsure_time * chance.between_ends()))?);
        }
        Ok(Self { pressed, is_sure: unsure_time == 0.0, caught })
    }

    /// How many have been made at a time of a scene with a pace; none if the button was never pressed.
    pub(super) fn made(&self, time: f64, pace: f64) -> usize {
        let since = (time - self.pressed) / (pace * TOSSING);
        // Those that begin again at the start, or look back, see all of them.
        let part = if since < -1e-9 { 1.0 } else { since.clamp(0.0, 1.0) };
        let made = f64::from(AT_ONCE) + part * f64::from(TOSSES - AT_ONCE);
        // A frame may fall on the very moment of a catch: it is made, however the last bits of the times round.
        self.caught.len().min((made + 1e-6) as usize)
    }

    /// The part of the first tosses that showed heads.
    pub(super) fn heads(&self, count: usize) -> f64 {
        self.caught[..count].iter().filter(|(_, heads)| *heads).count() as f64 / count as f64
    }

    /// How often each part of a precession was caught: bars that stand on −1.
    pub(super) fn draw(&self, graph: &mut Graph<'_>, made: usize) {
        let mut bars = [[0_u32; 2]; BARS];
        for &(part, heads) in &self.caught[..made] {
            bars[((part * BARS as f64) as usize).min(BARS - 1)][usize::from(heads)] += 1;
        }
        // As many in each bar as in all others would reach up to −0.4 when all are made; the highest stays inside.
        let highest = bars.iter().map(|[tails, heads]| tails + heads).max().unwrap_or(0).max(1);
        let unit = (0.6 * BARS as f64 / f64::from(TOSSES)).min(1.9 / f64::from(highest));
        for (bar, [tails, heads]) in bars.into_iter().enumerate() {
            let [left, right] = [bar, bar + 1].map(|edge| edge as f64 / BARS as f64);
            let mut foot = -1.0;
            for (count, hue) in [(tails, Hue::Muted), (heads, Hue::Blue)] {
                let top = foot + unit * f64::from(count);
                if count > 0 {
                    graph.area([(left, foot), (right, foot), (right, top), (left, top)], Fill::Face, hue);
                }
                foot = top;
            }
        }
    }
}

/// Numbers as good as random (splitmix64), the same from the same seed.
struct Chance(u64);

impl Chance {
    /// A number from −1 to 1.
    fn between_ends(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((bits ^ (bits >> 31)) >> 11) as f64 / 2_f64.powi(52) - 1.0
    }
}
