//! A million periods of the pinned hoop: what is left of the quaternion's length, of the energy and of the attitude.

use crate::contest::Cause;
use crate::ours::turning;
use crate::problems;
use mechanics::attitude::rotation_between;
use mechanics::euler::{self, Turning};
use mechanics::free_rotation::FreeTop;
use mechanics::geometric::Splitting;
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::{Dop853, rk4};
use nalgebra::{Quaternion, Vector3};
use std::fmt;

/// After how many periods of the angular velocity one looks.
pub(crate) const PERIODS: [u32; 4] = [1_000, 10_000, 100_000, 1_000_000];

/// One line of `long-run.csv`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Row {
    /// The method.
    pub method: &'static str,
    /// Its tolerance or step.
    pub setting: &'static str,
    /// How many periods have passed.
    pub periods: u32,
    /// Evaluations of the rates, or turns, since the start.
    pub work: usize,
    /// The length of the quaternion less one.
    pub length: f64,
    /// The energy over that of the start, less one.
    pub energy: f64,
    /// The angle between the attitude and the true one, rad.
    pub attitude: f64,
}

/// A way to go on: from seven numbers to those after a time, with what it cost.
type Advance = Box<dyn Fn([f64; 7], f64, u32) -> Result<([f64; 7], usize), Cause>>;

/// Follows the hoop with each method, to the last of `periods`.
///
/// # Errors
/// Whatever a method says.
pub(crate) fn rows(periods: &[u32]) -> Result<Vec<Row>, Cause> {
    let moments = PrincipalMoments::new(1.5, 0.5, 2.0)?;
    let start = turning(&problems::hoop());
    let top = FreeTop::new(moments, start)?;
    let period = top.period().ok_or("the hoop tumbles")?;
    let free = move || euler::turning_rates(moments, |_, _| Vector3::zeros());
    let runge_kutta = |steps: usize| -> Advance {
        Box::new(move |state, time, periods| {
            let steps = steps * periods as usize;
            Ok((rk4(free(), 0.0, state, time, steps)?, 4 * steps))
        })
    };
    let adaptive = |tolerance: f64| -> Advance {
        Box::new(move |state, time, _| {
            let solver = Dop853::new(tolerance)?.with_max_evaluations(usize::MAX);
            let end = solver.solve(free(), 0.0, state, time)?;
            Ok((end.state, end.work.evaluations))
        })
    };
    let splitting: Advance = Box::new(move |state, time, periods| {
        let (method, steps) = (Splitting::BlanesMoan, 40 * periods as usize);
        let end = method.solve(&moments, Turning::from_array(state), time, steps)?;
        Ok((end.to_array(), method.turns_per_step() * steps))
    });
    let methods: [(&str, &str, Advance); 8] = [
        ("RK4", "40 steps a period", runge_kutta(40)),
        ("RK4", "80 steps a period", runge_kutta(80)),
        ("DOP853", "tolerance 1e-6", adaptive(1e-6)),
        ("DOP853", "tolerance 1e-9", adaptive(1e-9)),
        ("DOP853", "tolerance 1e-12", adaptive(1e-12)),
        ("DOP853", "tolerance 1e-13", adaptive(1e-13)),
        ("DOP853", "tolerance 1e-14", adaptive(1e-14)),
        ("Blanes–Moan", "40 steps a period", splitting),
    ];
    let energy = moments.kinetic_energy(&start.omega_body);
    let judge = |numbers: [f64; 7], time: f64| -> Result<[f64; 3], Cause> {
        let [w, i, j, k, ..] = numbers;
        let turning = Turning::from_array(numbers);
        let exact = top.at(time)?;
        Ok([
            Quaternion::new(w, i, j, k).norm() - 1.0,
            moments.kinetic_energy(&turning.omega_body) / energy - 1.0,
            rotation_between(&turning.world_from_body, &exact.world_from_body),
        ])
    };
    let mut rows = Vec::new();
    for (method, setting, advance) in methods {
        let (mut state, mut done, mut work) = (start.to_array(), 0, 0);
        for &periods in periods {
            let (next, cost) = advance(state, f64::from(periods - done) * period, periods - done)?;
            (state, done, work) = (next, periods, work + cost);
            let [length, energy, attitude] = judge(state, f64::from(periods) * period)?;
            rows.push(Row { method, setting, periods, work, length, energy, attitude });
        }
    }
    for &periods in periods {
        // The closed form judges the others; by what it keeps itself it can be judged too.
        let time = f64::from(periods) * period;
        let [length, energy, _] = judge(top.at(time)?.to_array(), time)?;
        rows.push(Row {
            method: "closed form",
            setting: "",
            periods,
            work: 0,
            length,
            energy,
            attitude: 0.0,
        });
    }
    Ok(rows)
}

/// The rows as a table with a comma between the columns.
pub(crate) fn csv(rows: &[Row]) -> String {
    let mut text = String::from(
        "# The hoop pinned at 60°, followed for up to a million periods: what is left. Judged by the closed form.\n\
         # length: of the quaternion, less one; energy: over that of the start, less one; attitude: rad, and lost where above 1.\n\
         # written by: cargo bench --bench speed -- long FILE\n\
         method,setting,periods,work,length,energy,attitude\n",
    );
    for Row { method, setting, periods, work, length, energy, attitude } in rows {
        text.push_str(&format!(
            "{method},{setting},{periods},{work},{length:.2e},{energy:.2e},{attitude:.2e}\n"
        ));
    }
    text
}

impl fmt::Display for Row {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{} {} after {} periods", self.method, self.setting, self.periods)
    }
}
