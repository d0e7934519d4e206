//! The figures of the chapter "The pinned hoop".

use drawing::kit::{self, Heads, Marker};
use drawing::space::{Camera, Curve, Hiding, Solid, Stage, View};
use drawing::{Drawing, Hue, Point, Rect, Role, Room, Side, Stroke, at};
use figures::{Axis, Cause, Figure, Outcome, Plot, figures, in_both, linear_steps, log_steps};
use mechanics::InvalidQuantity;
use mechanics::euler::Turning;
use mechanics::free_rotation::FreeTop;
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::{self, Direction, Dop853};
use mechanics::scenes::pinned_hoop::{Pin, Pinning, PinningParameters, Shape};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, PI, SQRT_2};

/// All figures of this chapter.
pub(crate) const FIGURES: &[Figure] = figures![
    pinned_hoop,
    speed_of_b,
    momentum_in_hoop,
    tumble,
    pendulum::twice_the_angle,
    hoop_pendulum,
    pendulum::swing_at_sixty,
    flip,
    paths::herpolhode,
    paths::hoop_and_sphere,
    pendulum::wait_plateau,
    waits
];

#[path = "figures/paths.rs"]
pub(crate) mod paths;
#[path = "figures/pendulum.rs"]
pub(crate) mod pendulum;

/// A body of mass, radius and spin one, pinned at an angle in degrees.
fn pinning(shape: Shape, degrees: f64) -> Result<Pinning, InvalidQuantity> {
    let pin = Pin::Angle(degrees.to_radians());
    Pinning::new(PinningParameters { shape, mass: 1.0, radius: 1.0, spin: 1.0, pin })
}

/// Where the drawn hoop lies on its panel: the centre, and the radius, px.
const CENTRE: Point = at(132.0, 218.0);
const RADIUS: f64 = 104.0;
/// Where A is caught in the drawings, degrees.
const CAUGHT: f64 = 62.0;

/// A point on the rim of the drawn hoop, by the angle from the upright, clockwise, rad.
fn on_rim(angle: f64) -> Point {
    CENTRE + Point::polar(RADIUS, FRAC_PI_2 - angle)
}

/// The hoop in the plane of the page, with its old axis and the angle of A.
fn drawn_hoop(drawing: &mut Drawing, theta: f64) -> Result<(), Cause> {
    drawing.circle(CENTRE, RADIUS, Role::Line(Stroke::Vector, Hue::Blue));
    drawing.circle(CENTRE, RADIUS - 7.0, Role::Line(Stroke::Outline, Hue::Blue));
    let top = CENTRE - at(0.0, RADIUS + 12.0);
    drawing.line(top, CENTRE + at(0.0, RADIUS + 16.0), Stroke::Reference, Hue::Muted);
    drawing.line(CENTRE, on_rim(theta), Stroke::Outline, Hue::Muted);
    kit::angle(drawing, CENTRE, 40.0, FRAC_PI_2, -theta, Heads::End, Hue::Ink);
    let middle = CENTRE + Point::polar(40.0, FRAC_PI_2 - 0.5 * theta);
    drawing.label(middle, Side::AboveRight, r"$\theta$", Hue::Ink)?;
    kit::marker(drawing, CENTRE, Marker::Mass, Hue::Ink);
    Ok(())
}

/// The angular momentum about the place where A is caught: the same arrow before and after.
fn momentum_at(drawing: &mut Drawing, pin: Point) -> Result<(), Cause> {
    let tip = pin - at(0.0, 98.0);
    kit::arrow(drawing, pin, tip, Hue::Green);
    drawing.label(tip, Side::Above, r"$\boldsymbol{L}_A$", Hue::Green)?;
    Ok(())
}

/// The hoop in the plane of the page, before the snap and after it.
pub(crate) fn pinned_hoop(id: &str) -> Outcome {
    Ok(Drawing::panels(id, vec![before_the_snap("")?, after_the_snap("")?]))
}

fn before_the_snap(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 320.0, 380.0).titled(
        "The hoop before the snap",
        "A hoop in the plane of the page turns about its vertical diameter: its angular velocity omega zero points up. The point A, on the rim up and to the right at the angle \
         theta from the axis, goes into the page. From A the angular momentum about the place of A points up.",
    );
    let hoop = pinning(Shape::Hoop, CAUGHT)?;
    drawn_hoop(&mut drawing, hoop.angle())?;
    let (pin, top) = (on_rim(hoop.angle()), CENTRE - at(0.0, RADIUS));
    kit::arrow(&mut drawing, top, top - at(0.0, 66.0), Hue::Orange);
    drawing.label(top - at(0.0, 60.0), Side::Left, r"$\boldsymbol{\omega}_0$", Hue::Orange)?;
    momentum_at(&mut drawing, pin)?;
    drawing.dot(pin, 4.5, Hue::Pink);
    drawing.label(pin + at(6.0, 12.0), Side::Right, "$A$", Hue::Pink)?;
    // ω₀ × r at A.
    let into = hoop.omega_before().cross(&-hoop.centre()).z < 0.0;
    let mark = if into { Marker::Into } else { Marker::Out };
    kit::marker(&mut drawing, pin + at(22.0, -14.0), mark, Hue::Ink);
    drawing.label(pin + at(27.0, -14.0), Side::Right, r"$\boldsymbol{v}_A$", Hue::Ink)?;
    drawing.label(at(CENTRE.x, 364.0), Side::Over, "just before", Hue::Muted)?;
    Ok(drawing)
}

fn after_the_snap(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 320.0, 380.0).titled(
        "The hoop after the snap",
        "The same hoop, pinned at A. The angular momentum about A is the same arrow. From A the axis 2 points to the centre and the axis 1 along the tangent, up and to the left; axis 3, \
         the impulse of the pin and the velocity of the centre come out of the page. The new angular velocity omega leans from the vertical away from the hoop by phi, and makes the angle \
         chi zero with axis 1; its line, through A, cuts the hoop. The point B is a quarter of the circle from A, at the lower right.",
    );
    let hoop = pinning(Shape::Hoop, CAUGHT)?;
    let theta = hoop.angle();
    drawn_hoop(&mut drawing, theta)?;
    let pin = on_rim(theta);
    // The axes at A: 2 to the centre, 1 along the tangent on the side of ω₀.
    let second = Point::polar(1.0, FRAC_PI_2 - theta + PI);
    let first = Point::polar(1.0, FRAC_PI_2 - theta + FRAC_PI_2);
    let direction = {
        let omega = hoop.omega_after();
        (first * omega.x + second * omega.y).unit()
    };
    drawing.line(pin - direction * 170.0, pin, Stroke::Dotted, Hue::Orange);
    momentum_at(&mut drawing, pin)?;
    kit::arrow(&mut drawing, pin, pin + first * 98.0, Hue::Ink);
    drawing.label(pin + first * 96.0, Side::AboveLeft, r"$\hat{\mathbf{1}}$", Hue::Ink)?;
    kit::arrow(&mut drawing, pin, pin + second * 66.0, Hue::Ink);
    drawing.label(pin + second * 52.0, Side::BelowRight, r"$\hat{\mathbf{2}}$", Hue::Ink)?;
    kit::arrow(&mut drawing, pin, pin + direction * 98.0, Hue::Orange);
    drawing.label(pin + direction * 98.0, Side::Right, r"$\boldsymbol{\omega}$", Hue::Orange)?;
    // Angles at A: φ from the upright to ω, χ₀ from ω to axis 1.
    let (chi, phi) = (hoop.axis_angle(), hoop.axis_shift());
    kit::angle(&mut drawing, pin, 72.0, FRAC_PI_2, -phi, Heads::None, Hue::Ink);
    drawing.label(pin + Point::polar(72.0, FRAC_PI_2 - 0.55 * phi), Side::Above, r"$\varphi$", Hue::Ink)?;
    kit::angle(&mut drawing, pin, 36.0, direction.angle(), chi, Heads::None, Hue::Ink);
    drawing.label(
        pin + Point::polar(54.0, direction.angle() + 0.74 * chi),
        Side::Over,
        r"$\chi_0$",
        Hue::Ink,
    )?;
    let b = on_rim(theta + FRAC_PI_2);
    drawing.line(CENTRE, b, Stroke::Outline, Hue::Muted);
    drawing.label(CENTRE.towards(b, 0.5), Side::BelowLeft, "$a$", Hue::Ink)?;
    drawing.dot(b, 4.5, Hue::Pink);
    drawing.label(b + at(2.0, 4.0), Side::Right, "$B$", Hue::Pink)?;
    // What has no room in the plane of the page.
    let out = hoop.impulse().z > 0.0 && hoop.centre_velocity().z > 0.0;
    let mark = if out { Marker::Out } else { Marker::Into };
    kit::marker(&mut drawing, pin, mark, Hue::Pink);
    drawing.label(pin + at(4.0, 8.0), Side::Right, r"$A$, $\boldsymbol{P}$,", Hue::Pink)?;
    drawing.label(pin + at(42.0, 8.0), Side::Right, r"$\hat{\mathbf{3}}$", Hue::Ink)?;
    kit::marker(&mut drawing, CENTRE + at(-24.0, -14.0), mark, Hue::Ink);
    drawing.label(CENTRE + at(-28.0, -14.0), Side::Left, r"$\boldsymbol{v}_\text{cm}$", Hue::Ink)?;
    drawing.label(at(CENTRE.x, 364.0), Side::Over, "just after", Hue::Muted)?;
    Ok(drawing)
}

/// Speeds of the two points a quarter of the circle from A, and the stated answer.
pub(crate) fn speed_of_b(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 340.0, 310.0).titled(
        "Speeds of the two points a quarter of the circle from A",
        "Speeds in units of a omega zero against the angle theta from 0 to 90 degrees. The point at theta plus 90 degrees starts at one, falls to \
         zero at 71.57 degrees, where a ring marks it, and rises to one third. The point at theta minus 90 degrees starts at one, rises a little and falls to \
         one third. A dashed curve, the root of the squares, runs between the two and meets neither but at the ends.",
    );
    let angle = Axis::linear(0.0, 90.0, 15.0).minor(5.0).titled(r"angle $\theta$, degrees");
    let speed = Axis::linear(0.0, 1.2, 0.2).minor(0.05).titled(r"speed, in $a\omega_0$");
    let mut plot = Plot::new(&mut drawing, Rect::new(38.0, 34.0, 282.0, 226.0), angle, speed)?;
    type Velocity = fn(&Pinning) -> f64;
    let curves: [(Velocity, &str); 2] =
        [(Pinning::velocity_of_b, "plus"), (Pinning::velocity_opposite_b, "minus")];
    for (velocity, name) in curves {
        let values = linear_steps(0.0, 90.0, 720)
            .map(|degrees| Ok((degrees, velocity(&pinning(Shape::Hoop, degrees)?).abs())))
            .collect::<Result<Vec<_>, InvalidQuantity>>()?;
        let stroke = if name == "plus" { Stroke::Heavy } else { Stroke::Curve };
        plot.curve(name, values, stroke, Hue::Ink);
    }
    let stated = linear_steps(0.0, 90.0, 180)
        .map(|degrees| {
            let hoop = pinning(Shape::Hoop, degrees)?;
            let (below, above) = (hoop.velocity_of_b(), hoop.velocity_opposite_b());
            Ok((degrees, (0.5 * (below * below + above * above)).sqrt()))
        })
        .collect::<Result<Vec<_>, InvalidQuantity>>()?;
    plot.curve("stated", stated, Stroke::DashedCurve, Hue::Muted);
    plot.markers(&[(3_f64.atan().to_degrees(), 0.0)], Marker::Ring, Hue::Ink);
    plot.label((44.0, 0.99), Side::AboveRight, r"at $\theta - 90°$", Hue::Ink)?;
    plot.label((37.0, 0.55), Side::BelowLeft, r"$B$, at $\theta + 90°$", Hue::Ink)?;
    plot.label((62.5, 0.07), Side::Left, "$71.57°$", Hue::Ink)?;
    Ok(drawing)
}

/// The phase portrait of the pendulum in the hoop, with the pins from which it is let go.
pub(crate) fn hoop_pendulum(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 390.0, 330.0).titled(
        "The phase portrait of the hoop’s pendulum",
        "The rate of chi, in units of W, against chi from minus 30 to 210 degrees. Three closed curves about the rest at 90 degrees, for pins at 60, 80 and 89 degrees; each begins at a dot on \
         the axis, the nearer to zero the nearer theta is to 90 degrees. A separatrix, two arches from 0 to 180 degrees, encloses them. Outside two \
         curves run on above and below without turning.",
    );
    let angle = Axis::linear(-30.0, 210.0, 30.0).titled(r"$\chi$, degrees");
    let rate = Axis::linear(-1.0, 1.0, 0.5).titled(r"$\dot\chi/W$");
    let mut plot = Plot::new(&mut drawing, Rect::new(44.0, 34.0, 325.0, 246.0), angle, rate)?;
    plot.level(0.0, Stroke::Axis);
    // The separatrix, where the energy is that of the balance at χ = 0: χ̇² = W² sin² χ/2.
    for (sign, name) in [(1.0, "separatrix-above"), (-1.0, "separatrix-below")] {
        let values = linear_steps(-30.0, 210.0, 480)
            .map(|degrees| (degrees, sign * degrees.to_radians().sin() / SQRT_2));
        plot.curve(name, values, Stroke::Border, Hue::Ink);
    }
    // χ and its rate, by eq:flat-rates: ω₁ = W cos χ, ω₂ = −W sin χ, ω₃ = −χ̇.
    let place = |omega: Vector3<f64>| {
        let along = omega.x.hypot(omega.y);
        ((-omega.y).atan2(omega.x).to_degrees(), -omega.z / along)
    };
    for (degrees, hue) in [(60.0, Hue::Faint), (80.0, Hue::Muted), (89.0, Hue::Ink)] {
        let hoop = pinning(Shape::Hoop, degrees)?;
        let top = hoop.free_motion()?;
        let period = top.period().ok_or("a pendulum swings back")?;
        let values = linear_steps(0.0, period, 720)
            .map(|time| Ok(place(top.at(time)?.omega_body)))
            .collect::<Result<Vec<_>, InvalidQuantity>>()?;
        let start = values[0];
        plot.curve(&format!("pin-{degrees}"), values, Stroke::Curve, hue);
        plot.markers(&[start], Marker::Disc, hue);
        let place = match degrees {
            60.0 => (90.0, 0.25),
            80.0 => (90.0, 0.49),
            _ => (178.0, 0.3),
        };
        plot.label(
            place,
            Side::Over,
            &format!("${degrees}°$"),
            if hue == Hue::Faint { Hue::Muted } else { hue },
        )?;
    }
    // One that turns over, about axis 3: a start that no snap gives.
    let moments = pinning(Shape::Hoop, 45.0)?.moments_about_pin();
    for (sign, name) in [(1.0, "over-above"), (-1.0, "over-below")] {
        let omega_body = Vector3::new(1.0, 0.0, -0.45 * sign);
        let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body };
        let top = FreeTop::new(moments, start)?;
        let values = linear_steps(-3.0, 9.0, 600)
            .map(|time| {
                let (angle, rate) = place(top.at(sign * time)?.omega_body);
                // It turns over once on the way: past half a turn the angle goes on.
                Ok((if time > 3.0 && angle < 0.0 { angle + 360.0 } else { angle }, rate))
            })
            .collect::<Result<Vec<_>, InvalidQuantity>>()?;
        plot.curve(name, values, Stroke::Orbit, Hue::Muted);
    }
    plot.label((90.0, 0.94), Side::Over, "about axis 3: no snap starts here", Hue::Muted)?;
    for (place, side, name) in [
        ((0.0, -0.2), Side::Below, "pass"),
        ((90.0, -0.02), Side::Below, "hill"),
        ((180.0, -0.2), Side::Below, "pass"),
    ] {
        plot.label(place, side, name, Hue::Ink)?;
    }
    Ok(drawing)
}

/// Where the angular momentum goes in the hoop: level lines of the energy on a sphere.
pub(crate) fn momentum_in_hoop(id: &str) -> Outcome {
    in_both(|room| {
        let mut drawing = Drawing::new(id, 440.0, 360.0).titled(
            "Where the angular momentum goes in the hoop",
            "A sphere in the axes of the hoop, whose plane is its equator, seen from the side of the negative axis 2. Four closed curves on it circle that axis, the hill: they begin on the equator \
             at 30, 60, 80 and 89 degrees from it, and the last reaches almost to axis 1, a pass, and to its opposite. Next to it a dashed curve, the separatrix, crosses itself at axis 1. Two pale \
             curves circle axis 3, a valley.",
        );
        let moments = pinning(Shape::Hoop, 45.0)?.moments_about_pin();
        let mut stage = Stage::new(Camera::new(View {
            target: [0.0; 3],
            azimuth: -0.92,
            elevation: 0.3,
            distance: 9.0,
            centre: at(210.0, 190.0),
            scale: room.of(128.0, 108.0),
        })?);
        stage.solid(Solid::sphere([0.0; 3], 1.0)?, Hue::Blue)?;
        let equator = Curve::circle([0.0; 3], [0.0, 0.0, 1.0], 1.0)?.hiding(Hiding::Omitted);
        stage.curve(equator, Stroke::Outline, Hue::Blue)?;
        for from_axis_3 in [25.0_f64, 52.0] {
            let (sin, cos) = from_axis_3.to_radians().sin_cos();
            let path = level_line(moments, Vector3::new(sin, 0.0, cos))?;
            stage.curve(Curve::smooth(path)?.hiding(Hiding::Omitted), Stroke::Outline, Hue::Muted)?;
        }
        // The separatrix, L² = 2T I₁: two great circles through axis 1.
        let [i1, i2, i3] = moments.to_array();
        let slope = (i3 * (i1 - i2) / (i2 * (i3 - i1))).sqrt();
        for sign in [1.0, -1.0] {
            let across = Vector3::new(0.0, 1.0, sign * slope).normalize();
            let path = linear_steps(0.0, 2.0 * PI, 360)
                .map(|angle| Vector3::x() * angle.cos() + across * angle.sin());
            stage.curve(Curve::smooth(path)?.hiding(Hiding::Omitted), Stroke::Border, Hue::Ink)?;
        }
        for degrees in [30.0, 60.0, 80.0, 89.0] {
            let start = pinning(Shape::Hoop, degrees)?.angular_momentum().normalize();
            let path = level_line(moments, start)?;
            // Named where it begins, or where there is room.
            let (place, aside, side) = match degrees {
                89.0 => (start, at(24.0, -12.0), Side::Right),
                30.0 => (start, at(3.0, 3.0), Side::BelowRight),
                _ => (start, at(-3.0, -4.0), Side::AboveLeft),
            };
            stage.label_shifted(place, aside, side, &format!("${degrees}°$"), Hue::Green)?;
            stage.curve(Curve::smooth(path)?, Stroke::Curve, Hue::Green)?;
            stage.dot(start, 3.5, Hue::Green)?;
        }
        for (direction, name) in
            [(Vector3::x(), r"$\hat{\mathbf{1}}$, pass"), (Vector3::z(), r"$\hat{\mathbf{3}}$, valley")]
        {
            stage.named_vector(direction, direction * 1.35, name, Hue::Ink)?;
        }
        stage.dot(-Vector3::y(), 3.0, Hue::Ink)?;
        stage.label_shifted(
            -Vector3::y(),
            at(-8.0, -4.0),
            Side::AboveRight,
            r"$-\hat{\mathbf{2}}$, hill",
            Hue::Ink,
        )?;
        stage.write(&mut drawing);
        Ok(drawing)
    })
}

/// The direction of L in a free body over a period, from a direction at the start.
fn level_line(moments: PrincipalMoments, start: Vector3<f64>) -> Result<Vec<Vector3<f64>>, Cause> {
    let omega_body = start.component_div(&Vector3::from(moments.to_array()));
    let top = FreeTop::new(moments, Turning { world_from_body: UnitQuaternion::identity(), omega_body })?;
    let period = top.period().ok_or("a level line closes")?;
    linear_steps(0.0, period, 720)
        .map(|time| Ok(moments.angular_momentum(&top.at(time)?.omega_body)))
        .collect()
}

/// When the stills of the tumble are taken, in 1/ω₀, of a hoop that is pinned at 89.9 degrees.
const STILLS: [f64; 8] = [0.0, 7.0, 16.0, 22.0, 25.0, 28.0, 32.0, 46.0];
const NEARLY: f64 = 89.9;

/// Eight stills of the hoop in the room, from the snap through a tumble.
pub(crate) fn tumble(id: &str) -> Outcome {
    in_both(|room| stills(id, room))
}

/// The stills, in rows.
fn stills(id: &str, room: Room) -> Outcome {
    let in_a_row = room.of(4, 2);
    let (wide, high) = (154.0, 212.0);
    let rows = STILLS.len().div_ceil(in_a_row);
    let mut drawing = Drawing::new(id, wide * in_a_row as f64 + 10.0, high * rows as f64 + 10.0).titled(
        "Eight stills of a tumbling hoop",
        "The hoop in the room at eight moments, pinned at A, with the fixed upright angular momentum. In the first three it turns about its tangent at A, axis 1, which points up, like a door about \
         its hinge. Then the tangent leans over, the hoop passes through an almost level place, and in the last it turns about the tangent again, which now points down. The angular velocity \
         points upwards all the time.",
    );
    let hoop = pinning(Shape::Hoop, NEARLY)?;
    let (top, upright) = along_momentum(&hoop)?;
    for (n, time) in STILLS.into_iter().enumerate() {
        let pin = at(wide * ((n % in_a_row) as f64 + 0.5) + 5.0, high * (n / in_a_row) as f64 + 100.0);
        let now = top.at(time)?;
        let attitude = upright * now.world_from_body;
        let mut stage = Stage::new(Camera::new(View {
            target: [0.0; 3],
            azimuth: -0.9,
            elevation: 0.3,
            distance: 12.0,
            centre: pin,
            scale: 38.0,
        })?);
        let (centre, normal) = (attitude * hoop.centre(), attitude * Vector3::z());
        stage.solid(Solid::ring(centre, normal, 1.0, 0.88, 0.1)?, Hue::Blue)?;
        let [tangent, omega] = [attitude * Vector3::x() * 1.5, upright * now.omega_world() * 4.1];
        let to_the_left = |tip: &Vector3<f64>| tip.x * 0.9_f64.sin() + tip.y * 0.9_f64.cos() < -0.05;
        let sides = [
            if to_the_left(&tangent) || n < 2 { Side::Left } else { Side::Right },
            if to_the_left(&omega) || n == 2 { Side::Left } else { Side::Right },
        ];
        for (tip, side, name, hue) in [
            (Vector3::z() * 2.2, Side::Above, r"$\boldsymbol{L}_A$", Hue::Green),
            (tangent, sides[0], r"$\hat{\mathbf{1}}$", Hue::Ink),
            (omega, sides[1], r"$\boldsymbol{\omega}$", Hue::Orange),
        ] {
            let arrow = Curve::segment([0.0; 3], tip)?.hiding(Hiding::Ignored);
            stage.arrow(arrow, Stroke::Vector, Heads::End, hue)?;
            stage.label(tip, side, name, hue)?;
        }
        stage.dot_in_front([0.0; 3], 4.0, Hue::Pink)?;
        stage.write(&mut drawing);
        drawing.label(pin + at(0.0, 80.0), Side::Over, &format!("$t = {time}$"), Hue::Ink)?;
    }
    Ok(drawing)
}

/// The components of ω in the plane of the hoop for a pin near a right angle.
pub(crate) fn flip(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 340.0, 300.0).titled(
        "The flip of a hoop pinned at 89.9 degrees",
        "Two components of omega against time in units of one over omega zero, from 0 to 120. The component along the tangent stays near one \
         third until about 20, falls through zero at 28 to minus one third, stays there till 78, and rises again. The component along the diameter through A is near zero but for \
         short negative pulses, to minus one third, at each of these flips. Eight dots from the start through the first fall mark the stills.",
    );
    let hoop = pinning(Shape::Hoop, NEARLY)?;
    let top = hoop.free_motion()?;
    let time = Axis::linear(0.0, 120.0, 30.0).minor(10.0).titled(r"time, in $1/\omega_0$");
    let omega = Axis::linear(-0.4, 0.4, 0.2).minor(0.05).titled(r"angular velocity, in $\omega_0$");
    let mut plot = Plot::new(&mut drawing, Rect::new(46.0, 34.0, 270.0, 216.0), time, omega)?;
    plot.level(0.0, Stroke::Reference);
    for (axis, name, stroke) in [(1, "diameter", Stroke::Orbit), (0, "tangent", Stroke::Curve)] {
        let values = linear_steps(0.0, 120.0, 1200)
            .map(|time| Ok((time, top.at(time)?.omega_body[axis])))
            .collect::<Result<Vec<_>, InvalidQuantity>>()?;
        plot.curve(name, values, stroke, Hue::Orange);
    }
    for time in STILLS {
        plot.markers(&[(time, top.at(time)?.omega_body.x)], Marker::Disc, Hue::Orange);
    }
    plot.label((36.0, 0.26), Side::Right, r"$\omega_1$, tangent", Hue::Orange)?;
    plot.label((57.0, 0.07), Side::Over, r"$\omega_2$, diameter", Hue::Orange)?;
    Ok(drawing)
}

/// The free motion in a room whose third axis lies along the angular momentum.
fn along_momentum(hoop: &Pinning) -> Result<(FreeTop, UnitQuaternion<f64>), Cause> {
    let upright = UnitQuaternion::rotation_between(&hoop.angular_momentum(), &Vector3::z())
        .ok_or("the momentum is not opposite to the upright")?;
    Ok((hoop.free_motion()?, upright))
}

/// A body of mass, radius and spin one, pinned with a gap to a right angle whose sine is given.
fn pinned_beside(shape: Shape, gap: f64) -> Result<Pinning, InvalidQuantity> {
    let pin = Pin::Point { from_axis: (1.0 - gap * gap).sqrt(), height: gap };
    Pinning::new(PinningParameters { shape, mass: 1.0, radius: 1.0, spin: 1.0, pin })
}

/// The wait of the hoop as a program finds it that steps its attitude in a room whose axes are not the hoop's.
fn stepped_in_the_room(gap: f64) -> Result<f64, Cause> {
    let hoop = pinned_beside(Shape::Hoop, gap)?;
    let moments = Vector3::from(hoop.moments_about_pin().to_array());
    let aligned = UnitQuaternion::from_euler_angles(0.3, 0.7, -1.1);
    let momentum = aligned * hoop.angular_momentum();
    let attitude = |q: &[f64; 4]| UnitQuaternion::new_normalize(Quaternion::from(*q));
    let omega = |q: &[f64; 4]| (attitude(q).inverse() * momentum).component_div(&moments);
    let rates = |_: f64, q: &[f64; 4]| {
        let rate = attitude(q).into_inner() * Quaternion::from_imag(0.5 * omega(q));
        rate.coords.into()
    };
    let tumbles = |_: f64, q: &[f64; 4]| omega(q).x;
    let start = aligned.coords.into();
    match Dop853::new(1e-12)?.solve_until(rates, 0.0, start, 1000.0, tumbles, Direction::Falling)? {
        integrate::Outcome::Event(end) => Ok(end.time),
        _ => Err("it does not tumble".into()),
    }
}

/// How long hoop, disc and ball keep some rotation about the tangent, against the gap of the pin.
pub(crate) fn waits(id: &str) -> Outcome {
    let wait = |body: Pinning| body.wait()?.ok_or_else(|| Cause::from("it never comes"));
    let curve = |shape: Shape, from: f64| {
        log_steps(from, 0.99, 400)
            .map(|gap| Ok((gap, wait(pinned_beside(shape, gap)?)?)))
            .collect::<Result<Vec<_>, Cause>>()
    };
    // The nearest number to a right angle has a cosine, and who is told the angle waits no longer than for that.
    let told_the_angle = wait(pinning(Shape::Hoop, 90.0)?)?;
    let gaps = (1..=20).map(|decade| 10_f64.powi(-decade));
    let stepped = gaps.map(|gap| Ok((gap, stepped_in_the_room(gap)?))).collect::<Result<Vec<_>, Cause>>()?;
    in_both(|room| {
        let mut drawing = Drawing::new(id, room.of(660.0, 400.0), 380.0).titled(
            "Waits of a hoop, a disc and a ball against the gap of the pin",
            "Time until the rotation about the tangent has gone, in units of one over omega zero, from 0 to 300, against the gap from 1 down to 1e-20 on a logarithmic scale. \
             The hoop's is a straight line from 6 to 197, the disc's a steeper one to 281. The ball's rises out of the picture within two decades. \
             Dots of a program that steps in the room lie on the hoop's line down to a gap of 1e-15 and then stay near 150. A ring \
             at a gap of 6e-17 and 160 ends what a program can do that is told the angle.",
        );
        let gap = Axis::log(1e-20, 1.0, room.of(4, 5)).titled(r"gap of the pin, $\cos\theta$");
        let time = Axis::linear(0.0, 300.0, 50.0).minor(10.0).titled(r"time, in $1/\omega_0$");
        let frame = Rect::new(52.0, 34.0, room.of(580.0, 320.0), 290.0);
        let mut plot = Plot::new(&mut drawing, frame, gap, time)?;
        plot.curve("hoop", curve(Shape::Hoop, 1e-20)?, Stroke::Heavy, Hue::Ink);
        plot.curve("disc", curve(Shape::Disk, 1e-20)?, Stroke::Curve, Hue::Muted);
        plot.curve("ball", curve(Shape::Sphere, 0.0075)?, Stroke::Curve, Hue::Faint);
        plot.markers(&stepped, Marker::Ring, Hue::Ink);
        plot.markers(&[(FRAC_PI_2.cos(), told_the_angle)], Marker::Diamond, Hue::Ink);
        plot.label((1e-5, 44.0), Side::BelowLeft, "hoop", Hue::Ink)?;
        plot.label((1e-9, 126.0), Side::AboveRight, "disc", Hue::Muted)?;
        plot.label((0.005, 260.0), Side::Left, "ball", Hue::Muted)?;
        plot.label((2e-20, room.of(142.0, 92.0)), Side::BelowRight, "stepped in the room", Hue::Ink)?;
        let diamond = plot.at((FRAC_PI_2.cos(), told_the_angle));
        plot.drawing().line(diamond, diamond + at(0.0, -24.0), Stroke::Dotted, Hue::Muted);
        plot.drawing().label(
            diamond + at(0.0, -24.0),
            Side::Above,
            room.of("told the angle", "angle"),
            Hue::Ink,
        )?;
        Ok(drawing)
    })
}
