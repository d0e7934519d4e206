//! Euler's disk on its film of air.

use crate::rolling::{Disc, parameters, placed};
use crate::search::{Case, Draw, keeps_its_promise};
use mechanics::integrate::Taylor;
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::spinning_coin::EulersDisk;
use mechanics::{Error, Rule};

/// A start, and what kind.
fn start(draw: &mut Draw<'_>, disk: &EulersDisk, rate: f64) -> Option<Rolling> {
    let steady = disk.steady(draw.decades(1e-3, 1.5)).ok()?;
    let placed = placed(draw, disk.parameters().radius, steady);
    Some(match draw.below(3) {
        0 => placed,
        1 => Rolling {
            omega_1: rate * draw.signed(1e-6, 1e-2),
            omega_3: rate * draw.signed(1e-6, 1e-1),
            ..placed
        },
        _ => Rolling {
            tilt: draw.between(0.2, 2.9),
            omega_1: rate * draw.signed(1e-3, 2.0),
            omega_2: rate * draw.signed(1e-3, 3.0),
            omega_3: rate * draw.signed(1e-3, 5.0),
            ..placed
        },
    })
}

#[test]
fn a_sinking_disk_is_as_good_as_its_start_its_time_and_its_tolerance() {
    keeps_its_promise("film", 60, &["as in glue", "back", "no film", "sinking"], |draw| {
        let parameters = parameters(draw, 1e-3);
        let film = if draw.below(4) == 0 { 0.0 } else { draw.decades(1e-10, 1e-1) };
        let disk = EulersDisk::new(parameters, film).ok()?;
        let rate = (parameters.gravity / parameters.radius).sqrt();
        let start = start(draw, &disk, rate)?;
        if start.omega_2 == 0.0 && start.omega_3 == 0.0 {
            return None; // it falls flat
        }
        // A few turns of what is quickest, either way.
        let quickest = 1.0 + (start.omega_2 / start.tilt.sin()).abs().max(start.omega_3.abs()) / rate;
        let damping_at = |state: &Rolling| film / (parameters.moments.transverse * state.tilt.sin().powi(3));
        let damping = damping_at(&start);
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
        let said = format!("tolerance {tolerance:?}, {parameters:?}, K {film:?}, {start:?}, t {time:?}");
        let sinking = disk.sinking(start, &Taylor::new(tolerance).ok()?).ok()?;
        let ours = match sinking.at(time) {
            Ok(state) => state,
            Err(Error::Quantity(refused)) if matches!(refused.rule, Rule::NotAbove { .. }) && time > 0.0 => {
                return None; // over
            }
            // Back in time a film drives the disk, in the end past all bounds.
            Err(Error::Integration(_)) if time < 0.0 => return None,
            Err(error) => return Case::refused(way, format!("{error}: {said}")),
        };
        // Back in time a film drives the disk; where it has driven it wild, the judge would need too many steps.
        if time < 0.0
            && (damping_at(&ours) * rate * time < -10.0 || ours.omega_1.abs() > 30.0 * quickest * rate)
        {
            return None;
        }
        // There the tolerance counts, which is that of numbers of size one.
        let disc = Disc::new(&parameters, film);
        let judged = disc.worst_part(&parameters, [&start, &ours], time, tolerance, time < 0.0);
        if judged.is_none() && (time < 0.0 || tolerance > f64::EPSILON) {
            return None;
        }
        let (ratio, number) = judged.expect("the judge follows what sinks");
        Some(Case { ratio, way, said: format!("{said}: {ours:?}, number {number}") })
    });
}

/// Holds the motion of a disk without a film to its promise.
fn kept(disk: &EulersDisk, start: &Rolling, time: f64, tolerance: f64) {
    let parameters = disk.parameters();
    let sinking = disk.sinking(*start, &Taylor::new(tolerance).expect("a tolerance")).expect("a motion");
    let ours = sinking.at(time).expect("a state");
    let disc = Disc::new(&parameters, 0.0);
    let judged = disc.worst_part(&parameters, [start, &ours], time, tolerance, time < 0.0);
    let (ratio, number) = judged.expect("a motion");
    assert!(ratio < 1.0, "{tolerance:e}: {ratio} of the promise in number {number}: {ours:?}");
}

#[test]
fn a_loose_tolerance_is_kept_where_a_disk_stood_nearly_upright() {
    // It falls from there, the further the larger what the tolerance leaves open.
    let (radius, gravity) = (0.311_117_230_430_681_46, 16.030_483_322_782);
    let parameters = DiskParameters { mass: 1.0, radius, moments: MomentFactors::DISK, gravity };
    let start = Rolling {
        tilt: 1.540_501_354_794_922,
        omega_1: 0.064_485_428_113_457_37,
        omega_2: 0.034_992_594_549_972_97,
        omega_3: -0.136_210_772_148_521_12,
        ..Rolling::UPRIGHT
    };
    let disk = EulersDisk::new(parameters, 0.0).expect("a disk");
    let time = -4.101_532_025_448_462;
    for tolerance in [1e-4, 1e-6, 1e-9, 1e-16] {
        kept(&disk, &start, time, tolerance);
    }
}

#[test]
fn a_disk_that_comes_back_to_where_it_stood_has_the_errors_of_its_way() {
    // Nearly upright it falls, whirls round and gets up: a change of the start has nearly gone by then, one on the way not.
    let parameters = DiskParameters { mass: 1.0, radius: 1.0, moments: MomentFactors::DISK, gravity: 1.0 };
    let start = Rolling {
        tilt: 1.584_090_618_042_655_3,
        omega_1: 0.0,
        omega_2: 0.166_580_964_495_201_66,
        omega_3: -0.010_039_390_649_417_666,
        ..Rolling::UPRIGHT
    };
    let disk = EulersDisk::new(parameters, 0.0).expect("a disk");
    for tolerance in [1e-4, 1e-6, 1e-9, 1e-16] {
        kept(&disk, &start, 25.715_850_277_177_477, tolerance);
    }
}
