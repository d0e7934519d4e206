//! Other people's numbers: the curves lie where the committed files, read here anew, and integrations of their own say.

use crate::{curve, lies_on};
use mechanics::euler::{Turning, turning_rates};
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::Dop853;
use nalgebra::{UnitQuaternion, Vector3};

/// ω of a free body at a time, degrees in the unit of time, by steps.
fn stepped([i1, i2, i3]: [f64; 3], degrees: [f64; 3], time: f64) -> Vector3<f64> {
    let moments = PrincipalMoments::new(i1, i2, i3).expect("moments");
    let omega_body = Vector3::from(degrees).map(f64::to_radians);
    let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body };
    let free = turning_rates(moments, |_, _| Vector3::zeros());
    let solver = Dop853::new(1e-14).expect("a solver");
    let end = solver.solve(free, 0.0, start.to_array(), time).expect("a state");
    Turning::from_array(end.state).omega_body.map(f64::to_degrees)
}

#[test]
fn simulators_are_as_far_from_the_closed_form_as_from_an_integration() {
    let text = include_str!("../../judged/brick.csv");
    for (simulator, name) in [(2, "two"), (5, "five"), (6, "six")] {
        let start = format!("{simulator},");
        let apart = text.lines().filter_map(|line| line.strip_prefix(&start)).map(|line| {
            // The committed line: time, s; ω, degrees a second.
            let said: Vec<f64> = line.split(',').map(|cell| cell.parse().expect("a number")).collect();
            let brick = stepped([0.001_894_22, 0.006_211_019, 0.007_194_665], [10.0, 20.0, 30.0], said[0]);
            (brick - Vector3::from_row_slice(&said[1..4])).norm()
        });
        let worst = apart.fold(0.0, f64::max);
        let away = curve("judged-brick", name).distance((0.0, worst));
        assert!(away < 1.0, "{name}: {worst:e}, {away} px");
    }
}

#[test]
fn toutatis_swings_as_an_integration_says() {
    for (axis, name) in [(0, "first"), (1, "second")] {
        lies_on("judged-toutatis", name, |day| {
            stepped([3.0836, 3.235, 1.0], [14.51, 33.529, -98.709], day)[axis]
        });
    }
}
