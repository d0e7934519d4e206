//! The Rust crates that solve ordinary differential equations.
//!
//! Each is given the same rates as the library, inlined, and the output at the times of the samples in the
//! way that its interface offers.

use crate::contest::{Cause, Entry, Note};
use crate::problems::{self, Problem};
use differential_equations::prelude::{ExplicitRungeKutta, IVP, ODE};
use diffsol::{MatrixCommon, NalgebraMat, OdeBuilder, OdeSolverMethod};
use ivp::prelude::{FirstOrderSystem, Ivp};
use ode_solvers::{SVector, System};
use std::rc::Rc;

/// No solver may take more steps than this.
const MOST_STEPS: usize = 3_000_000;

/// What fills the samples of a problem and counts.
type Solve<const N: usize> = Box<dyn Fn(&Problem<N>, &mut Vec<[f64; N]>) -> Result<Option<usize>, Cause>>;

/// Rates with the interface of every crate.
#[derive(Clone, Copy)]
struct Rates<R>(R);

impl<const N: usize, R: Fn(f64, &[f64; N]) -> [f64; N]> ODE<f64, [f64; N]> for Rates<R> {
    #[inline]
    fn diff(&self, t: f64, y: &[f64; N], rate: &mut [f64; N]) {
        *rate = (self.0)(t, y);
    }
}

/// Rates behind slices, with the number of variables.
#[derive(Clone, Copy)]
struct Sliced<R, const N: usize>(R);

impl<const N: usize, R: Fn(f64, &[f64; N]) -> [f64; N]> FirstOrderSystem for Sliced<R, N> {
    #[inline]
    fn derivative(&self, t: f64, y: &[f64], rate: &mut [f64]) {
        let state: [f64; N] = std::array::from_fn(|i| y[i]);
        rate.copy_from_slice(&(self.0)(t, &state));
    }
}

impl<const N: usize, R: Fn(f64, &[f64; N]) -> [f64; N]> System<f64, SVector<f64, N>> for Sliced<R, N> {
    #[inline]
    fn system(&self, t: f64, y: &SVector<f64, N>, rate: &mut SVector<f64, N>) {
        let state: [f64; N] = std::array::from_fn(|i| y[i]);
        *rate = SVector::from((self.0)(t, &state));
    }
}

/// Every entry of every crate, and what they cannot do.
pub fn entries() -> (Vec<Entry>, Vec<Note>) {
    let mut entries = Vec::new();
    solvers(&mut entries, problems::washer(), problems::washer_rates, true);
    clocked(&mut entries, problems::washer(), problems::washer_rates);
    solvers(&mut entries, problems::ramp(), problems::ramp_rates, true);
    clocked(&mut entries, problems::ramp(), problems::ramp_rates);
    solvers(&mut entries, problems::hoop(), problems::hoop_rates, false);
    solvers(&mut entries, problems::separatrix(), problems::hoop_rates, false);
    solvers(&mut entries, problems::disk(), problems::disk_rates, false);
    solvers(&mut entries, problems::rest(), problems::rest_rates, false);
    solvers(&mut entries, problems::toss(), problems::flat_rates, false);
    solvers(&mut entries, problems::station(), problems::flat_rates, false);
    solvers(&mut entries, problems::drag(), problems::drag_rates, false);
    solvers(&mut entries, problems::top(), problems::top_rates, false);
    let note = |problem, text| Note { problem, contestant: "ode_solvers", text };
    let clock = "the node of the last stage of its DOP853 is zero in this version, so rates that depend on the time are \
                 evaluated there at a wrong time; it is given the time as a fifth variable";
    let samples = "its output in equal steps is wrong where these are longer than the solver's; it is run from sample to sample";
    let notes = vec![note("washer", clock), note("ramp", clock), note("all", samples)];
    (entries, notes)
}

fn solvers<const N: usize>(
    entries: &mut Vec<Entry>,
    problem: Problem<N>,
    rates: impl Fn(f64, &[f64; N]) -> [f64; N] + Copy + 'static,
    timed: bool,
) {
    let problem = Rc::new(problem);
    for digits in 3..=14 {
        let tolerance = 10.0_f64.powi(-digits);
        let setting = format!("tolerance 1e-{digits}");
        let mut add = |names, solve: Solve<N>| {
            entries.push(Entry::new(&problem, names, setting.clone(), solve, |y| *y));
        };
        add(
            ["ivp", "DOP853"],
            Box::new(move |problem, samples| {
                let system = Sliced::<_, N>(rates);
                let solution = Ivp::first_order(&system, 0.0, problem.end(), &problem.start)
                    .method(ivp::Method::DOP853)
                    .rtol(tolerance)
                    .atol(tolerance)
                    .max_steps(MOST_STEPS)
                    .t_eval(problem.times.clone())
                    .solve()
                    .map_err(|error| format!("{error:?}"))?;
                samples.clear();
                samples.extend(solution.y.iter().map(|y| std::array::from_fn(|i| y[i])));
                Ok(Some(solution.nfev))
            }),
        );
        add(
            ["differential-equations", "Verner 9(8)"],
            Box::new(move |problem, samples| {
                let method =
                    ExplicitRungeKutta::rkv988e().rtol(tolerance).atol(tolerance).max_steps(MOST_STEPS);
                let solution = IVP::ode(&Rates(rates), 0.0, problem.end(), problem.start)
                    .t_eval(problem.times.clone())
                    .method(method)
                    .solve()
                    .map_err(|error| format!("{error:?}"))?;
                *samples = solution.y;
                Ok(Some(solution.evals.function))
            }),
        );
        if !timed {
            add(
                ["ode_solvers", "DOP853"],
                Box::new(move |problem, samples| {
                    let evaluations = ode_solvers_samples(
                        Sliced::<_, N>(rates),
                        problem,
                        problem.start,
                        tolerance,
                        samples,
                    )?;
                    Ok(Some(evaluations))
                }),
            );
        }
        if digits <= 12 {
            add(
                ["diffsol", "Tsitouras 5(4)"],
                Box::new(move |problem, samples| {
                    let start = problem.start;
                    let solver = OdeBuilder::<NalgebraMat<f64>>::new()
                        .rtol(tolerance)
                        .atol([tolerance])
                        .rhs(move |y, _p, t, rate| {
                            let state: [f64; N] = std::array::from_fn(|i| y[i]);
                            let found = rates(t, &state);
                            for (slot, value) in (0..N).zip(found) {
                                rate[slot] = value;
                            }
                        })
                        .init(move |_p, _t, y| (0..N).for_each(|i| y[i] = start[i]), N)
                        .build()?;
                    let (states, _) = solver.tsit45()?.solve_dense(&problem.times)?;
                    let states = states.inner();
                    samples.clear();
                    samples.extend(
                        (0..states.ncols()).map(|sample| std::array::from_fn(|i| states[(i, sample)])),
                    );
                    Ok(None)
                }),
            );
        }
    }
}

/// The crate `ode_solvers` with the time as one more variable.
fn clocked(
    entries: &mut Vec<Entry>,
    problem: Problem<4>,
    rates: impl Fn(f64, &[f64; 4]) -> [f64; 4] + Copy + 'static,
) {
    let problem = Rc::new(problem);
    let with_clock = move |_t: f64, &[x, y, vx, vy, t]: &[f64; 5]| -> [f64; 5] {
        let [x, y, vx, vy] = rates(t, &[x, y, vx, vy]);
        [x, y, vx, vy, 1.0]
    };
    for digits in 3..=14 {
        let tolerance = 10.0_f64.powi(-digits);
        let solve = move |problem: &Problem<4>, samples: &mut Vec<[f64; 5]>| {
            let [x, y, vx, vy] = problem.start;
            let start = [x, y, vx, vy, 0.0];
            let evaluations =
                ode_solvers_samples(Sliced::<_, 5>(with_clock), problem, start, tolerance, samples)?;
            Ok(Some(evaluations))
        };
        let setting = format!("tolerance 1e-{digits}");
        entries.push(Entry::new(
            &problem,
            ["ode_solvers", "DOP853"],
            setting,
            solve,
            |&[x, y, vx, vy, _]| [x, y, vx, vy],
        ));
    }
}

/// From sample to sample, each solver beginning with the longest step of the one before: the crate's own
/// output in equal steps is wrong where these are longer than the solver's.
fn ode_solvers_samples<const N: usize, const M: usize, R: Fn(f64, &[f64; M]) -> [f64; M] + Copy>(
    system: Sliced<R, M>,
    problem: &Problem<N>,
    start: [f64; M],
    tolerance: f64,
    samples: &mut Vec<[f64; M]>,
) -> Result<usize, Cause> {
    let (mut state, mut step, mut evaluations) = (SVector::from(start), 0.0, 0);
    samples.clear();
    samples.push(start);
    for pair in problem.times.windows(2) {
        let mut solver = ode_solvers::Dop853::from_param(
            system,
            pair[0],
            pair[1],
            0.0,
            state,
            tolerance,
            tolerance,
            0.9,
            0.0,
            0.333,
            6.0,
            pair[1] - pair[0],
            step,
            MOST_STEPS as u32,
            u32::MAX,
            ode_solvers::dop_shared::OutputType::Sparse,
        );
        let stats = solver.integrate().map_err(|error| error.to_string())?;
        evaluations += stats.num_eval as usize;
        let times = solver.x_out();
        step = times.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
        state = *solver.y_out().last().ok_or("no state")?;
        samples.push(std::array::from_fn(|i| state[i]));
    }
    Ok(evaluations)
}
