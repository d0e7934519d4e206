//! Euler's disk on its film of air.

use crate::long::{Long, long};
use crate::rolling::{Disc, Numbers};
use crate::search::{Case, Draw, search};
use mechanics::scenes::spinning_coin::{EulersDisk, NoSinking, Sinking};

/// Units in the last place, and how many times what such a unit makes of start and time; for a looser tolerance in its place.
const PROMISE: f64 = 30.0;

/// A start, and what kind.
fn start(draw: &mut Draw<'_>, disk: &EulersDisk, rate: f64) -> Option<Sinking> {
    let steady = disk.steady(draw.decades(1e-3, 1.5)).ok()?;
    let placed = Sinking {
        heading: draw.between(-4.0, 4.0),
        spin: draw.between(-4.0, 4.0),
        contact: [0, 1].map(|_| draw.between(-3.0, 3.0)),
        ..steady
    };
    Some(match draw.below(3) {
        0 => placed,
        1 => Sinking {
            tilt_rate: rate * draw.signed(1e-6, 1e-2),
            along: rate * draw.signed(1e-6, 1e-1),
            ..placed
        },
        _ => Sinking {
            tilt: draw.between(0.2, 2.9),
            tilt_rate: rate * draw.signed(1e-3, 2.0),
            across: rate * draw.signed(1e-3, 3.0),
            along: rate * draw.signed(1e-3, 5.0),
            ..placed
        },
    })
}

fn numbers(start: &Sinking, radius: f64) -> Numbers {
    let mut numbers = start.to_array().map(long);
    numbers[6] = numbers[6] / radius;
    numbers[7] = numbers[7] / radius;
    numbers
}

#[test]
fn a_sinking_disk_is_as_good_as_its_start_its_time_and_its_tolerance() {
    let worst = search("film", 60, |draw| {
        let k = if draw.below(2) == 0 { draw.one_of(&[0.5, 1.0]) } else { draw.decades(1e-3, 1.0) };
        let (radius, gravity) =
            if draw.below(2) == 0 { (1.0, 1.0) } else { (draw.decades(1e-2, 1e2), draw.decades(1e-1, 1e3)) };
        let film = if draw.below(4) == 0 { 0.0 } else { draw.decades(1e-10, 1e-1) };
        let disk = EulersDisk::new(radius, k, gravity, film).ok()?;
        let rate = (gravity / radius).sqrt();
        let start = start(draw, &disk, rate)?;
        if start.across == 0.0 && start.along == 0.0 {
            return None; // it falls flat
        }
        // A few turns of what is quickest, either way.
        let quickest = 1.0 + (start.across / start.tilt.sin()).abs().max(start.along.abs()) / rate;
        let damping = film / (0.5 * k * start.tilt.sin().powi(3));
        let time = draw.one_of(&[-1.0, 1.0]) * draw.decades(1e-3, 30.0) / quickest / rate;
        if time < 0.0 && damping * rate * time < -10.0 || damping / quickest > 1e3 {
            return None; // what was, in glue, cannot be told from what is; and what will be is not worth the steps
        }
        let tolerance = if draw.below(2) == 0 { 1e-16 } else { draw.decades(1e-16, 1e-4) };
        let way = match (film > 0.0, time > 0.0, damping > quickest) {
            (false, ..) => "no film",
            (true, true, false) => "sinking",
            (true, true, true) => "as in glue",
            (true, false, _) => "back",
        };
        let said = format!(
            "tolerance {tolerance:?}, k {k:?}, a {radius:?}, g {gravity:?}, K {film:?}, {start:?}, t {time:?}"
        );
        let ours = match disk.sample(&start, &[time], tolerance) {
            Ok(frames) => frames[0],
            Err(NoSinking::Over { .. }) if time > 0.0 => return None,
            // Back in time a film drives the disk, in the end past all bounds.
            Err(NoSinking::Integration(_)) if time < 0.0 => return None,
            Err(error) => return Some(Case { ratio: f64::INFINITY, way, said: format!("{error}: {said}") }),
        };
        let gravity_over_radius = long(gravity) / radius;
        let disc = Disc { k, gravity_over_radius, film: gravity_over_radius.sqrt() * film };
        // Back in time a film drives the disk; where it has driven it wild, the judge would need too many steps.
        let damping_there = film / (0.5 * k * ours.tilt.sin().powi(3));
        if time < 0.0
            && (damping_there * rate * time < -10.0 || ours.tilt_rate.abs() > 30.0 * quickest * rate)
        {
            return None;
        }
        // There the tolerance counts, which is that of numbers of size one.
        let least = if time < 0.0 { [1.0, rate, rate, rate] } else { [0.0; 4] };
        let judged = disc.with_conditioning(&numbers(&start, radius), time, least);
        if judged.is_none() && time < 0.0 {
            return None;
        }
        let (truth, change) = judged.expect("the judge follows what sinks");
        let turned = (truth[4] - start.heading).abs().rounded();
        let given = start.to_array();
        let mut worst = (0.0, 0);
        for (i, found) in ours.to_array().into_iter().enumerate() {
            let unit = [1.0, rate, rate, rate, 1.0, 1.0, radius, radius][i];
            let true_value: Long = if i < 6 { truth[i] } else { truth[i] * radius };
            let size = unit.max(given[i].abs()).max(true_value.abs().rounded());
            // A place has the rounding of the heading that led there.
            let (size, change) = if i < 6 {
                (size, change[i])
            } else {
                (size + radius * turned, radius * (change[6].max(change[7]) + change[4]))
            };
            let ratio = (true_value - found).abs().rounded()
                / ((size + change / f64::EPSILON) * tolerance.max(f64::EPSILON));
            if ratio.is_nan() || ratio > worst.0 {
                worst = (ratio, i);
            }
        }
        Some(Case { ratio: worst.0 / PROMISE, way, said: format!("{said}: {ours:?}, number {}", worst.1) })
    });
    worst.keeps_its_promise(&["as in glue", "back", "no film", "sinking"]);
}
