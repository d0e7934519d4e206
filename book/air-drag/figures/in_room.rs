//! What the air does to the angular momentum in the room, and the path of the axis about it.

use drawing::kit::{self, Heads, Marker};
use drawing::{Drawing, Fill, Hue, Point, Role, Side, Stroke, at};
use figures::{Cause, Outcome, Plot, in_both, linear_steps};
use mechanics::euler::Turning;
use mechanics::inertia::{Body, PrincipalMoments};
use mechanics::integrate::Dop853;
use mechanics::scenes::air_drag::{Drag, DraggedTop, DraggedTopParameters, ThrownTop};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::TAU;

/// A top in the air that is thrown so that its angular momentum is upright at the start.
fn thrown_upright(
    moments: PrincipalMoments,
    drag: Drag,
    omega_body: Vector3<f64>,
) -> Result<(DraggedTop, ThrownTop), Cause> {
    let top = DraggedTop::new(DraggedTopParameters { moments, drag, omega_body })?;
    let momentum = moments.angular_momentum(&omega_body);
    let upright =
        UnitQuaternion::rotation_between(&momentum, &Vector3::z()).ok_or("L is not opposite to z")?;
    Ok((top, top.thrown(upright, &Dop853::new(1e-10)?)?))
}

/// The torque of the air in the room.
fn torque(top: &DraggedTop, state: &Turning) -> Vector3<f64> {
    state.world_from_body * top.torque_body(&state.omega_body)
}

/// The torque of the air on a disc: what shortens L, and what pulls it to the axis, all the way round.
pub(crate) fn air_pull(id: &str) -> Outcome {
    // A disc, whose axis leans by 30° from L, with a drag of which little is seen in a round.
    let moments = PrincipalMoments::symmetric(1.0, 2.0)?;
    let omega_body = Vector3::new(2.0 * 30_f64.to_radians().tan(), 0.0, 1.0);
    let (top, thrown) = thrown_upright(moments, Drag::isotropic(1e-4), omega_body)?;
    let start = thrown.at(0.0)?;
    let momentum = start.angular_momentum_world(&moments);
    let round = TAU * moments.to_array()[0] / momentum.norm();
    Ok(Drawing::panels(
        id,
        vec![
            two_parts(&top, &start)?,
            all_the_way_round(&top, &thrown, round)?,
            head_to_tail(&top, &thrown, round)?,
        ],
    ))
}

/// L, the axis and the spin from the side, and at the tip of L the torque as a sum of two.
fn two_parts(top: &DraggedTop, start: &Turning) -> Outcome {
    let mut drawing = Drawing::new("", 260.0, 300.0).titled(
        "The torque of the air on a disc",
        "The angular momentum L stands upright. The axis 3 of the disc leans to the left, the angular velocity omega to the right. \
         At the tip of L the torque of the air points down and to the left. It is the sum of a longer arrow down, along L, and a shorter \
         one up and to the left, along axis 3.",
    );
    let foot = at(112.0, 244.0);
    let momentum = start.angular_momentum_world(&top.moments());
    let axis = start.axis_3_world();
    // Axis 3 to the left.
    let sign = -axis.x.signum();
    let place = |v: Vector3<f64>| at(sign * v.x, -v.z);
    let whole = torque(top, start);
    // τ = along L + along axis 3: the part across L is that of axis 3 alone.
    let pull = axis * (whole.x / axis.x);
    let shortens = whole - pull;
    let (tall, strong) = (150.0, 74.0 / whole.norm());
    let tip = foot + place(momentum.normalize() * tall);
    let half = start.world_from_body * Vector3::x();
    drawing.polyline(&[foot - place(half) * 52.0, foot + place(half) * 52.0], Stroke::Heavy, Hue::Blue);
    kit::arrow(&mut drawing, foot, tip, Hue::Green);
    drawing.label(tip, Side::Above, r"$\boldsymbol{L}$", Hue::Green)?;
    kit::arrow(&mut drawing, foot, foot + place(axis * 168.0), Hue::Ink);
    drawing.label(foot + place(axis * 168.0), Side::Above, r"$\hat{\mathbf{3}}$", Hue::Ink)?;
    let spin = foot + place(start.omega_world().normalize() * 110.0);
    kit::arrow(&mut drawing, foot, spin, Hue::Orange);
    drawing.label(spin, Side::AboveLeft, r"$\boldsymbol{\omega}$", Hue::Orange)?;
    // To the right of L, so that nothing lies on it.
    let from = at(190.0, tip.y);
    let [down, sum] = [from + place(shortens) * strong, from + place(whole) * strong];
    drawing.line(tip, from, Stroke::Dotted, Hue::Muted);
    for (start, end) in [(from, down), (down, sum)] {
        kit::dimension(&mut drawing, start, end, Heads::End, Hue::Purple);
    }
    drawing.label(from.towards(down, 0.5), Side::Right, "shortens", Hue::Purple)?;
    drawing.label(down + at(0.0, 4.0), Side::Below, "pulls", Hue::Purple)?;
    kit::arrow(&mut drawing, from, sum, Hue::Purple);
    drawing.label(from.towards(sum, 0.62), Side::Left, r"$\boldsymbol{\tau}$", Hue::Purple)?;
    drawing.label(at(112.0, 288.0), Side::Over, "(a) from the side", Hue::Ink)?;
    Ok(drawing)
}

/// How many moments of a round are shown.
const MOMENTS: u32 = 8;

/// The pull across L at the middle of each eighth of a round.
fn pulls(top: &DraggedTop, thrown: &ThrownTop, round: f64) -> Result<Vec<Vector3<f64>>, Cause> {
    (0..MOMENTS)
        .map(|moment| {
            let state = thrown.at(round * (f64::from(moment) + 0.5) / f64::from(MOMENTS))?;
            let along = state.angular_momentum_world(&top.moments()).normalize();
            let whole = torque(top, &state);
            Ok(whole - along * along.dot(&whole))
        })
        .collect()
}

/// The tip of the axis round L from above, and the pulls to it.
fn all_the_way_round(top: &DraggedTop, thrown: &ThrownTop, round: f64) -> Outcome {
    let mut drawing = Drawing::new("", 214.0, 300.0).titled(
        "The pull all the way round",
        "From above, L in the middle. The tip of axis 3 goes round it on a circle, counter-clockwise, and is marked at eight places. From the \
         middle eight arrows of one length point to these places.",
    );
    let middle = at(107.0, 150.0);
    let mut plot = Plot::plane(&mut drawing, middle, 170.0, 0.6)?;
    let path = linear_steps(0.0, 0.98 * round, 120)
        .map(|time| Ok(thrown.at(time)?.axis_3_world()))
        .collect::<Result<Vec<_>, Cause>>()?;
    plot.curve("axis", path.iter().map(|axis| (axis.x, axis.y)), Stroke::Outline, Hue::Ink);
    let [before, end] = [path[114], path[119]].map(|axis| plot.at((axis.x, axis.y)));
    kit::head(&mut drawing, end, end - before, 0.8, Hue::Ink);
    for (moment, pull) in pulls(top, thrown, round)?.into_iter().enumerate() {
        let state = thrown.at(round * (moment as f64 + 0.5) / f64::from(MOMENTS))?.axis_3_world();
        let tip = middle + at(state.x, -state.y) * 170.0;
        drawing.dot(tip, 3.0, Hue::Ink);
        let way = at(pull.x, -pull.y).unit();
        kit::arrow(&mut drawing, middle + way * 7.0, middle + way * 52.0, Hue::Purple);
    }
    kit::marker(&mut drawing, middle, Marker::Out, Hue::Green);
    drawing.label(
        middle + at(0.0, -98.0),
        Side::Over,
        r"$\hat{\mathbf{3}}$ goes round $\boldsymbol{L}$",
        Hue::Ink,
    )?;
    drawing.label(at(107.0, 288.0), Side::Over, "(b) from above", Hue::Ink)?;
    Ok(drawing)
}

/// The same pulls one after the other.
fn head_to_tail(top: &DraggedTop, thrown: &ThrownTop, round: f64) -> Outcome {
    let mut drawing = Drawing::new("", 190.0, 300.0).titled(
        "The pulls of a round add up to nothing",
        "The same eight arrows head to tail. They close into a ring of eight sides, which the tip of L follows.",
    );
    let pulls = pulls(top, thrown, round)?;
    let scale = 46.0 / pulls[0].norm();
    let step = |pull: &Vector3<f64>| at(pull.x, -pull.y) * scale;
    let mut corners = vec![at(0.0, 0.0)];
    for pull in &pulls {
        corners.push(corners[corners.len() - 1] + step(pull));
    }
    let middle = corners[0].towards(corners[corners.len() / 2], 0.5);
    let home = at(95.0, 150.0) - middle;
    for pair in corners.windows(2) {
        kit::arrow(&mut drawing, home + pair[0], home + pair[1], Hue::Purple);
    }
    drawing.dot(home + corners[0], 4.0, Hue::Green);
    drawing.label(at(95.0, 142.0), Side::Over, r"way of the", Hue::Green)?;
    drawing.label(at(95.0, 160.0), Side::Over, r"tip of $\boldsymbol{L}$", Hue::Green)?;
    drawing.label(at(95.0, 288.0), Side::Over, "(c) head to tail", Hue::Ink)?;
    Ok(drawing)
}

/// By which factor the magnifier of the path of the axis enlarges.
const ENLARGED: f64 = 25.0;

/// The path of the Frisbee's axis in the room, and under a magnifier the small dance of its angular momentum.
pub(crate) fn axis_path(id: &str) -> Outcome {
    let moments = Body::thin_disk(0.175, 0.137)?.moments();
    let omega_body = Vector3::new(12.0, 0.0, 40.0);
    let (_, thrown) = thrown_upright(moments, Drag::isotropic(2e-3), omega_body)?;
    let times: Vec<f64> = linear_steps(0.0, 6.0, 12000).collect();
    let states = thrown.sample(&times)?;
    let axis: Vec<(f64, f64)> =
        states.iter().map(|state| (state.axis_3_world().x, state.axis_3_world().y)).collect();
    let momenta: Vec<(f64, f64)> = states
        .iter()
        .map(|state| {
            let direction = state.angular_momentum_world(&moments).normalize();
            (direction.x, direction.y)
        })
        .collect();
    // The middle of the circle on which L goes round.
    let middle_of = |part: fn(&(f64, f64)) -> f64| {
        let parts = || momenta.iter().map(part);
        0.5 * (parts().fold(f64::INFINITY, f64::min) + parts().fold(f64::NEG_INFINITY, f64::max))
    };
    let mean = (middle_of(|place| place.0), middle_of(|place| place.1));
    let from_middle = move |place: (f64, f64)| (place.0 - mean.0, place.1 - mean.1);
    // Where a round ends: on the left, where it began.
    let rounds: Vec<(f64, f64)> = axis
        .windows(2)
        .filter(|pair| pair[0].1 > 0.0 && pair[1].1 <= 0.0 && pair[1].0 < 0.0)
        .map(|pair| pair[1])
        .collect();
    in_both(|room| {
        let (radius, reach) = (room.of(180.0, 150.0), 0.15);
        let (width, height) = room.of((620.0, 390.0), (350.0, 520.0));
        let mut drawing = Drawing::new(id, width, height).titled(
            "The axis spirals in, and the angular momentum stays",
            "Seen along the angular momentum at the start. The tip of the axis begins at the left, 0.15 \
             from the middle, and spirals in, about ten times round, the rounds marked by dots on the left. A small ring in the middle is shown twenty-five times as large \
             beside it: in it the angular momentum goes round a circle, again and again.",
        );
        let middle = at(radius + 34.0, radius + 14.0);
        let mut plot = Plot::plane(&mut drawing, middle, radius / reach, 0.16)?;
        plot.curve("axis", axis.iter().copied(), Stroke::Axis, Hue::Ink);
        plot.markers(&axis[..1], Marker::Disc, Hue::Ink);
        let marks: Vec<Point> = rounds.iter().map(|&place| plot.at(place)).collect();
        for place in marks {
            plot.drawing().dot(place, 2.2, Hue::Ink);
        }
        let [before, here] = [plot.at(axis[112]), plot.at(axis[124])];
        kit::head(plot.drawing(), here, here - before, 1.0, Hue::Ink);
        // The magnifier: a ring about L, and its image.
        let lens = room.of(86.0, 80.0);
        let glass = lens / (ENLARGED * radius / reach);
        let small = lens / ENLARGED;
        let centre =
            room.of(at(middle.x + radius + 112.0, middle.y), at(middle.x, middle.y + radius + 106.0));
        let towards = centre - middle;
        let across = towards.unit().quarter_turned();
        for side in [-1.0, 1.0] {
            drawing.line(
                middle + across * (side * small),
                centre + across * (side * lens),
                Stroke::Dotted,
                Hue::Muted,
            );
        }
        drawing.circle(centre, lens, Role::Area(Fill::Page, Hue::Muted));
        drawing.circle(centre, lens, Role::Line(Stroke::Outline, Hue::Muted));
        drawing.circle(middle, small, Role::Line(Stroke::Outline, Hue::Muted));
        let mut plot = Plot::plane(&mut drawing, centre, lens / glass, glass)?;
        plot.curve("momentum", momenta.iter().map(|&place| from_middle(place)), Stroke::Curve, Hue::Green);
        plot.markers(&[from_middle(momenta[0])], Marker::Disc, Hue::Green);
        let name = format!(r"$\boldsymbol{{L}}$, {ENLARGED} ×");
        drawing.label(centre, Side::Over, &name, Hue::Green)?;
        drawing.label(middle - at(radius, 0.0), Side::Left, r"$\hat{\mathbf{3}}$", Hue::Ink)?;
        Ok(drawing)
    })
}
