//! Many times at once, in the wide registers of the processor.
//!
//! The state of a motion in closed form is a few sines and exponentials, and sums of products of them. Written without
//! a branch, a table or a call it serves one time ([`Branchless::state`] with `ONE`, for `at`), and in a loop over a
//! block of times the compiler makes of the same lines instructions for two, four or eight times at once (for
//! `sample`). A block in which a time is out of reach is left to `at`, one by one.

/// The states at `times`: as many as `quick` says it has done at once, a block of those that it leaves alone one by
/// one, and so on. A state that is not known yet is `blank`.
pub(crate) fn sample<S: Copy, E>(
    times: &[f64],
    blank: S,
    quick: impl Fn(&[f64], &mut [S]) -> usize,
    at: impl Fn(f64) -> Result<S, E>,
) -> Result<Vec<S>, E> {
    let mut done = 0;
    let mut states = Vec::with_capacity(times.len());
    while done < times.len() {
        let end = times.len().min(done + CHUNK);
        states.resize(end, blank);
        while done < end {
            done += quick(&times[done..end], &mut states[done..end]);
            let one_by_one = end.min(done + BLOCK);
            while done < one_by_one {
                states[done] = at(times[done])?;
                done += 1;
            }
        }
    }
    Ok(states)
}

/// Runs a loop compiled for the widest registers that the processor has. The answer is the same on all of
/// them, to the last bit: nothing is fused or reordered.
#[inline(always)]
pub(crate) fn at_full_width<R>(work: impl FnOnce() -> R) -> R {
    pulp::Arch::new().dispatch(work)
}

/// The list grows by so many blocks, which the nearest memory holds until they are filled.
const CHUNK: usize = 8 * BLOCK;

/// States are computed in blocks of this many: enough for the widest registers, and small enough for the
/// nearest memory.
pub(crate) const BLOCK: usize = 32;

/// Does `work` block by block, as many states as there are times, and says so; leaves alone, and counts not,
/// the block in which a time is not `reached` or not a number or of which `work` says that it has not come
/// out, and what follows it.
#[inline(always)]
pub(crate) fn in_blocks<S>(
    times: &[f64],
    states: &mut [S],
    reached: impl Fn(f64) -> bool,
    mut work: impl FnMut(&[f64], &mut [S]) -> bool,
) -> usize {
    let mut done = 0;
    for (times, states) in times.chunks(BLOCK).zip(states.chunks_mut(BLOCK)) {
        if !times.iter().all(|&time| reached(time)) || !work(times, states) {
            break;
        }
        done += times.len();
    }
    done
}

/// Later times, of whatever unit, are no times of this world; what refuses them is asked one by one.
const LARGEST_TIME: f64 = 1e50;

/// The constants of a motion whose states are computed without a branch.
pub(crate) trait Branchless: Copy {
    /// What is computed.
    type State;

    /// The state at a time within reach; at any time for `ONE`, which costs a branch. To be marked
    /// `#[inline(always)]`: a call would not be compiled for wide registers.
    fn state<const ONE: bool>(&self, time: f64) -> Self::State;

    /// Whether a state is within the range of numbers, for a motion that can leave it.
    #[inline(always)]
    fn is_finite(_state: &Self::State) -> bool {
        true
    }
}

/// The states at `times`: several at once where all times of a block are within `reach`, else as `at` has them.
pub(crate) fn sample_branchless<C: Branchless<State: Copy>, E>(
    constants: C,
    reach: [f64; 2],
    times: &[f64],
    blank: C::State,
    at: impl Fn(f64) -> Result<C::State, E>,
) -> Result<Vec<C::State>, E> {
    let quick = |times: &[f64], states: &mut [_]| several_at_once(constants, reach, times, states);
    sample(times, blank, quick, at)
}

/// Fills states as [`in_blocks`], several with the same instructions. The constants come by value: for all
/// the compiler knows, a state that is written might change what is borrowed.
#[inline(always)]
fn several_at_once<C: Branchless>(
    constants: C,
    reach: [f64; 2],
    times: &[f64],
    states: &mut [C::State],
) -> usize {
    let [from, to] = [reach[0].max(-LARGEST_TIME), reach[1].min(LARGEST_TIME)];
    let reached = |time: f64| time >= from && time <= to;
    in_blocks(times, states, reached, |times, states| {
        at_full_width(
            #[inline(always)]
            || {
                for (&time, state) in times.iter().zip(states.iter_mut()) {
                    *state = constants.state::<false>(time);
                }
            },
        );
        states.iter().all(C::is_finite)
    })
}

#[cfg(test)]
mod tests {
    use super::{BLOCK, Branchless, sample, several_at_once};
    use crate::clock::Clock;
    use crate::elementary::exp;
    use crate::two_part::TwoPart;
    use std::cell::Cell;
    use std::convert::Infallible;

    /// A decaying oscillation.
    #[derive(Clone, Copy)]
    struct Decay(Clock);

    impl Branchless for Decay {
        type State = [f64; 2];

        #[inline(always)]
        fn state<const ONE: bool>(&self, time: f64) -> [f64; 2] {
            let (sin, cos) = self.0.sin_cos::<ONE>(time);
            [exp(-0.1 * time) * cos, exp(-0.1 * time) * sin]
        }
    }

    #[test]
    fn states_are_the_same_in_registers_of_any_width() {
        let decay = Decay(Clock::from_rate(TwoPart::from(1.3)));
        let times: Vec<f64> = (0..1000).map(|n| 0.37 * f64::from(n)).collect();
        let mut states = vec![[0.0; 2]; times.len()];
        assert_eq!(several_at_once(decay, [0.0, 1e9], &times, &mut states), 1000);
        for (state, &time) in states.iter().zip(&times) {
            assert_eq!(*state, decay.state::<true>(time));
        }
    }

    #[test]
    fn a_block_with_a_time_out_of_reach_is_left_alone() {
        let decay = Decay(Clock::from_rate(TwoPart::from(1.3)));
        for bad in [-1.0, 2e9, f64::NAN, f64::INFINITY] {
            let mut times = [1.0; 100];
            times[70] = bad;
            let mut states = [[7.0; 2]; 100];
            assert_eq!(several_at_once(decay, [0.0, 1e9], &times, &mut states), 64);
            assert!(states[63] == decay.state::<true>(1.0) && states[64] == [7.0; 2]);
        }
    }

    #[test]
    fn only_the_blocks_that_are_out_of_reach_are_filled_one_by_one() {
        let decay = Decay(Clock::from_rate(TwoPart::from(1.3)));
        let mut times: Vec<f64> = (0..10 * BLOCK).map(|n| 0.1 * n as f64).collect();
        (times[BLOCK + 3], times[5 * BLOCK]) = (-1.0, -2.0);
        let singles = Cell::new(0);
        let single = |time: f64| {
            singles.set(singles.get() + 1);
            Ok::<_, Infallible>(decay.state::<true>(time))
        };
        let quick =
            |times: &[f64], states: &mut [[f64; 2]]| several_at_once(decay, [0.0, 1e9], times, states);
        let states = sample(&times, [f64::NAN; 2], quick, single).unwrap();
        assert_eq!(singles.get(), 2 * BLOCK);
        for (state, &time) in states.iter().zip(&times) {
            assert_eq!(*state, decay.state::<true>(time));
        }
    }
}
