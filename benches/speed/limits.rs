//! What a sample costs in long lists, beside what the functions in it cost by themselves; and a sweep, on one core and
//! on all.

use crate::contest::Cause;
use crate::ours::{UNIT_DISC, turning};
use crate::problems;
use mechanics::Motion;
use mechanics::faddeeva::faddeeva;
use mechanics::free_rotation::FreeTop;
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::Taylor;
use mechanics::rolling::Rolling;
use mechanics::scenes::laundromat::{Machine, MachineParameters, Shaft};
use mechanics::scenes::rolling_wheel::Wheel;
use mechanics::scenes::spinning_coin::EulersDisk;
use mechanics::sweep::sweep;
use nalgebra::Complex;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Samples in a list: set-up no longer counts.
const SAMPLES: usize = 4096;
/// Rounds, of which the median is taken.
const ROUNDS: usize = 31;
/// How long each round lasts.
const SLICE: Duration = Duration::from_millis(4);
/// Machines in a sweep, and the samples of each.
const MACHINES: usize = 20_000;

/// Nanoseconds for one of `count` things that `work` does, the median of some rounds.
fn nanoseconds(count: usize, mut work: impl FnMut() -> Result<(), Cause>) -> Result<f64, Cause> {
    let mut rounds = Vec::with_capacity(ROUNDS);
    for _ in 0..ROUNDS {
        let (began, mut runs) = (Instant::now(), 0_u32);
        while runs == 0 || began.elapsed() < SLICE {
            work()?;
            runs += 1;
        }
        rounds.push(began.elapsed().as_secs_f64() / f64::from(runs));
    }
    rounds.sort_by(f64::total_cmp);
    Ok(1e9 * rounds[ROUNDS / 2] / count as f64)
}

/// Nanoseconds for one value of `functions`, computed one by one.
fn by_themselves(times: &[f64], functions: impl Fn(f64) -> f64) -> Result<f64, Cause> {
    let mut values = vec![0.0; times.len()];
    nanoseconds(times.len(), || {
        for (value, &time) in values.iter_mut().zip(black_box(times)) {
            *value = functions(time);
        }
        black_box(&values);
        Ok(())
    })
}

/// Nanoseconds for a sample of a motion.
fn a_sample<M: Motion<Error: Into<Cause>>>(motion: &M, times: &[f64]) -> Result<f64, Cause> {
    nanoseconds(times.len(), || {
        black_box(motion.sample(black_box(times)).map_err(Into::into)?);
        Ok(())
    })
}

fn machine(damping: f64, spin: f64) -> Result<Machine, Cause> {
    let (drum_mass, load_mass, load_radius, stiffness) = (0.0, 1.0, 1.0, 1.0);
    Ok(Machine::new(MachineParameters { drum_mass, load_mass, load_radius, stiffness, damping, spin })?)
}

/// A line of `limits.csv`: of what, what it is, and nanoseconds.
type Row = (&'static str, &'static str, f64);

/// Measures all lines.
///
/// # Errors
/// Whatever the library says.
pub(crate) fn rows() -> Result<Vec<Row>, Cause> {
    let times: Vec<f64> = (0..SAMPLES).map(|n| 0.37 * n as f64).collect();
    let mut rows = Vec::new();

    let motion = machine(0.01, 3.0)?.transient(Shaft::AT_REST)?;
    rows.push(("washer", "a sample", a_sample(&motion, &times)?));
    let functions = by_themselves(&times, |t| {
        let ((a, b), (c, d)) = ((3.0 * t).sin_cos(), t.sin_cos());
        a + b + (c + d) * (-0.005 * t).exp()
    })?;
    rows.push(("washer", "its functions", functions));

    let ramp = machine(0.01, 0.0)?.ramp(0.01, Shaft::AT_REST)?;
    rows.push(("ramp", "a sample", a_sample(&ramp, &times)?));
    let functions = by_themselves(&times, |t| {
        let past = 0.05 * (t - 100.0).abs();
        let (near, far) = (faddeeva(Complex::new(past, past)), faddeeva(Complex::new(past, 5.0 + past)));
        let ((a, b), (c, d)) = ((0.005 * t * t).sin_cos(), t.sin_cos());
        near.re + far.im + a + b + (c + d) * (-0.005 * t).exp()
    })?;
    rows.push(("ramp", "its functions", functions));

    let start = turning(&problems::hoop());
    let top = FreeTop::new(PrincipalMoments::new(1.5, 0.5, 2.0)?, start)?;
    rows.push(("hoop", "a sample", a_sample(&top, &times)?));
    let functions = by_themselves(&times, |t| {
        let ((a, b), (c, d)) = ((0.2 * t).sin_cos(), t.sin_cos());
        (a + b * c + 3.0).sqrt() + (b - a * d + 3.0).sqrt() / (2.0 + a)
    })?;
    rows.push(("hoop", "its functions", functions));

    let top = FreeTop::new(PrincipalMoments::new(0.25, 0.25, 0.5)?, turning(&problems::toss()))?;
    rows.push(("toss", "a sample", a_sample(&top, &times)?));
    let functions = by_themselves(&times, |t| {
        let ((a, b), (c, d)) = ((0.2 * t).sin_cos(), t.sin_cos());
        a * b + c * d
    })?;
    rows.push(("toss", "its functions", functions));

    let disk = EulersDisk::new(UNIT_DISC, 1e-5)?;
    let sinking = disk.sinking(disk.steady(0.3)?, &Taylor::new(1e-11)?)?;
    let cost = nanoseconds(1, || {
        black_box(sinking.at(black_box(1e-3))?);
        Ok(())
    })?;
    rows.push(("rest", "a step with its sample", cost));

    let wheel = Wheel::new(UNIT_DISC)?;
    let rolling = Rolling { omega_1: -0.15, ..wheel.steady(0.5, 3.0)?.state() };
    let wobble = wheel.wobble(rolling, &Taylor::new(1e-16)?)?;
    rows.push(("disk", "a sample", a_sample(&wobble, &times)?));

    // Which of twenty thousand machines shakes most while it starts? A hundred states of each.
    let dampings: Vec<f64> = (0..MACHINES).map(|n| 1e-4 * n as f64).collect();
    let largest = |damping: &f64| {
        let motion = machine(*damping, 3.0).ok()?.transient(Shaft::AT_REST).ok()?;
        let states = motion.sample(&times[..100]).ok()?;
        Some(states.iter().map(|shaft| shaft.position.norm_sqr()).fold(0.0, f64::max))
    };
    let cost = nanoseconds(MACHINES, || {
        black_box(dampings.iter().map(largest).collect::<Vec<_>>());
        Ok(())
    })?;
    rows.push(("sweep", "a machine on one core", cost));
    if cfg!(feature = "parallel") {
        let cost = nanoseconds(MACHINES, || {
            black_box(sweep(black_box(&dampings), largest));
            Ok(())
        })?;
        rows.push(("sweep", "a machine on all cores", cost));
    }
    Ok(rows)
}

/// The first line of the data.
const COLUMNS: &str = "what,what it is,nanoseconds";

/// The rows as a table with a comma between the columns.
pub(crate) fn csv(rows: &[Row]) -> String {
    let mut text = format!("{COLUMNS}\n");
    for (what, kind, cost) in rows {
        text.push_str(&format!("{what},{kind},{cost:.3}\n"));
    }
    text
}
