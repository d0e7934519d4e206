//! Many frames at once: the rule that all slices of frames share.

use std::error::Error;
use std::fmt;

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
        let block = done..times.len().min(done + crate::wide::BLOCK);
        for index in block {
            frames[index] = single(times[index]).map_err(|error| InvalidFrames::Time { index, error })?;
            done += 1;
        }
    }
    Ok(())
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
