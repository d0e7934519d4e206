//! Many frames at once: the rule that all slices of frames share.

use crate::branchless::at_full_width;
use std::error::Error;
use std::fmt;
use std::ops::RangeInclusive;

/// Why a list of frames cannot be filled; `E` is why a single time has no answer.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum InvalidFrames<E> {
    /// The list of times and the place for frames differ in length. Nothing has been written.
    Length {
        /// How many times there are.
        times: usize,
        /// How many frames there is room for.
        frames: usize,
    },
    /// A time has no answer. The frames before it have been written.
    Time {
        /// Its place in the list.
        index: usize,
        /// Why.
        error: E,
    },
}

/// Fills the frames at `times`: as many as `quick` says it has done at once, a block of those that it leaves alone one by one, and so on.
pub(crate) fn fill<F, E>(
    times: &[f64],
    frames: &mut [F],
    quick: impl Fn(&[f64], &mut [F]) -> usize,
    single: impl Fn(f64) -> Result<F, E>,
) -> Result<(), InvalidFrames<E>> {
    if times.len() != frames.len() {
        return Err(InvalidFrames::Length { times: times.len(), frames: frames.len() });
    }
    let mut done = 0;
    while done < times.len() {
        done += quick(&times[done..], &mut frames[done..]);
        let block = done..times.len().min(done + BLOCK);
        for index in block {
            frames[index] = single(times[index]).map_err(|error| InvalidFrames::Time { index, error })?;
            done += 1;
        }
    }
    Ok(())
}

/// Frames are computed in blocks of this many: enough for the widest registers, and small enough for the nearest memory.
pub(crate) const BLOCK: usize = 32;

/// Does `work` block by block, as many frames as there are times, and says so; leaves alone, and counts not, the block in which a
/// time is not `reached` or not a number or of which `work` says that it has not come out, and what follows it.
#[inline(always)]
pub(crate) fn in_blocks<F>(
    times: &[f64],
    frames: &mut [F],
    reached: impl Fn(f64) -> bool,
    mut work: impl FnMut(&[f64], &mut [F]) -> bool,
) -> usize {
    let mut done = 0;
    for (times, frames) in times.chunks(BLOCK).zip(frames.chunks_mut(BLOCK)) {
        if !times.iter().all(|&time| reached(time)) || !work(times, frames) {
            break;
        }
        done += times.len();
    }
    done
}

/// Later times, of whatever unit, are no times of this world; what refuses them is asked one by one.
const LARGEST_TIME: f64 = 1e50;

/// The constants of a motion whose frames are computed without a branch.
pub(crate) trait Branchless: Copy {
    /// What is computed.
    type Frame;

    /// The frame at a time. To be marked `#[inline(always)]`: a call would not be compiled for wide registers.
    fn at(&self, time: f64) -> Self::Frame;

    /// Whether a frame is within the range of numbers, for a motion that can leave it.
    #[inline(always)]
    fn is_finite(_frame: &Self::Frame) -> bool {
        true
    }
}

/// Fills frames as [`in_blocks`], several with the same instructions. The constants come by value: for all the compiler knows, a
/// frame that is written might change what is borrowed.
#[inline(always)]
pub(crate) fn several_at_once<C: Branchless>(
    constants: C,
    reach: RangeInclusive<f64>,
    times: &[f64],
    frames: &mut [C::Frame],
) -> usize {
    let reached = |time: f64| reach.contains(&time) && time.abs() <= LARGEST_TIME;
    in_blocks(times, frames, reached, |times, frames| {
        at_full_width(
            #[inline(always)]
            || {
                for (&time, frame) in times.iter().zip(frames.iter_mut()) {
                    *frame = constants.at(time);
                }
            },
        );
        frames.iter().all(C::is_finite)
    })
}

impl<E: fmt::Display> fmt::Display for InvalidFrames<E> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { times, frames } => {
                write!(
                    out,
                    "{times} times but room for {frames} frames; there must be one frame for each time"
                )
            }
            Self::Time { index, error } => write!(out, "time number {index}: {error}"),
        }
    }
}

impl<E: Error + 'static> Error for InvalidFrames<E> {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Length { .. } => None,
            Self::Time { error, .. } => Some(error),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{BLOCK, Branchless, fill, several_at_once};
    use crate::branchless::{Clock, exp, sin_cos_quarters};
    use crate::two_part::TwoPart;
    use std::cell::Cell;
    use std::convert::Infallible;

    /// A decaying oscillation.
    #[derive(Clone, Copy)]
    struct Decay(Clock);

    impl Branchless for Decay {
        type Frame = [f64; 2];

        #[inline(always)]
        fn at(&self, time: f64) -> [f64; 2] {
            let (high, low) = self.0.at(time);
            let (sin, cos) = sin_cos_quarters(high, low);
            [exp(-0.1 * time) * cos, exp(-0.1 * time) * sin]
        }
    }

    #[test]
    fn frames_are_the_same_in_registers_of_any_width() {
        let decay = Decay(Clock::from_rate(TwoPart::from(1.3)));
        let times: Vec<f64> = (0..1000).map(|n| 0.37 * f64::from(n)).collect();
        let mut frames = vec![[0.0; 2]; times.len()];
        assert_eq!(several_at_once(decay, 0.0..=1e9, &times, &mut frames), 1000);
        for (frame, &time) in frames.iter().zip(&times) {
            assert_eq!(*frame, decay.at(time));
        }
    }

    #[test]
    fn a_block_with_a_time_out_of_reach_is_left_alone() {
        let decay = Decay(Clock::from_rate(TwoPart::from(1.3)));
        for bad in [-1.0, 2e9, f64::NAN, f64::INFINITY] {
            let mut times = [1.0; 100];
            times[70] = bad;
            let mut frames = [[7.0; 2]; 100];
            assert_eq!(several_at_once(decay, 0.0..=1e9, &times, &mut frames), 64);
            assert!(frames[63] == decay.at(1.0) && frames[64] == [7.0; 2]);
        }
    }
    #[test]
    fn only_the_blocks_that_are_out_of_reach_are_filled_one_by_one() {
        let decay = Decay(Clock::from_rate(TwoPart::from(1.3)));
        let mut times: Vec<f64> = (0..10 * BLOCK).map(|n| 0.1 * n as f64).collect();
        (times[BLOCK + 3], times[5 * BLOCK]) = (-1.0, -2.0);
        let mut frames = vec![[0.0; 2]; times.len()];
        let singles = Cell::new(0);
        let single = |time: f64| {
            singles.set(singles.get() + 1);
            Ok::<_, Infallible>(decay.at(time))
        };
        let quick = |times: &[f64], frames: &mut [[f64; 2]]| several_at_once(decay, 0.0..=1e9, times, frames);
        fill(&times, &mut frames, quick, single).unwrap();
        assert_eq!(singles.get(), 2 * BLOCK);
        for (frame, &time) in frames.iter().zip(&times) {
            assert_eq!(*frame, decay.at(time));
        }
    }
}
