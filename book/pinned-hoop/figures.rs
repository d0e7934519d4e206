//! The figures of the chapter "The pinned hoop".

use crate::{Axis, Cause, Outcome, Plot, linear_steps, log_steps};
use drawing::kit::{self, Heads, Marker};
use drawing::space::{Camera, Curve, Hiding, Solid, Stage, View};
use drawing::{Drawing, Hue, Point, Rect, Role, Side, Stroke, at};
use mechanics::elliptic::quarter_period;
use mechanics::free_rotation::FreeTop;
use mechanics::InvalidQuantity;
use mechanics::scenes::pinned_hoop::{Parameters, Pin, Pinning, Shape};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, PI, SQRT_2};

/// A body of mass, radius and spin one.
fn pinned(shape: Shape, pin: Pin) -> Result<Pinning, InvalidQuantity> {
    Pinning::new(Parameters { shape, mass: 1.0, radius: 1.0, spin: 1.0, pin })
}

/// The same, pinned at an angle in degrees.
fn pinning(shape: Shape, degrees: f64) -> Result<Pinning, InvalidQuantity> {
    pinned(shape, Pin::Angle(degrees.to_radians()))
}

/// The hoop in the plane of the page, with A, B, both axes of rotation and the angles.
pub(crate) fn pinned_hoop(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 500.0, 420.0).titled(
        "The hoop in its plane",
        "A circle with its centre. The old angular velocity omega zero points up along the vertical diameter. The pinned point A is on the circle, up \
         and to the right, at the angle theta from the vertical. From A the axis 2 points to the centre and the axis 1 along the tangent, up \
         and to the left. \
         Through A runs the new axis of rotation, whose direction omega leans from the vertical towards A by phi, and makes the angle alpha with axis 1. \
         The point B is a quarter of the circle further on, at the lower right.",
    );
    let degrees = 62.0;
    let hoop = pinning(Shape::Hoop, degrees)?;
    let theta = hoop.angle();
    let (centre, radius) = (at(215.0, 232.0), 145.0);
    let upright = FRAC_PI_2;
    let on_rim = |polar: f64| centre + Point::polar(radius, upright - polar);
    let pin = on_rim(theta);
    drawing.circle(centre, radius, Role::Line(Stroke::Vector, Hue::Blue));
    drawing.circle(centre, radius - 7.0, Role::Line(Stroke::Outline, Hue::Blue));
    drawing.line(centre + at(0.0, 170.0), centre - at(0.0, 160.0), Stroke::Reference, Hue::Muted);
    drawing.line(centre, pin, Stroke::Outline, Hue::Muted);

    let up = centre - at(0.0, radius);
    kit::arrow(&mut drawing, up, up - at(0.0, 66.0), Hue::Orange);
    drawing.label(up - at(0.0, 66.0), Side::Right, r"$\boldsymbol{\omega}_0$", Hue::Orange)?;

    // The axes at A: 2 to the centre, 1 along the tangent on the side of ω₀.
    let second = Point::polar(1.0, upright - theta + PI);
    let first = Point::polar(1.0, upright - theta + FRAC_PI_2);
    let plane = |v: Vector3<f64>| first * v.x + second * v.y;
    kit::arrow(&mut drawing, pin, pin + first * 105.0, Hue::Ink);
    drawing.label(pin + first * 105.0, Side::AboveLeft, r"$\hat{\mathbf{1}}$", Hue::Ink)?;
    kit::arrow(&mut drawing, pin, pin + second * 88.0, Hue::Ink);
    drawing.label(pin + second * 72.0, Side::BelowRight, r"$\hat{\mathbf{2}}$", Hue::Ink)?;
    let direction = plane(hoop.omega_after()).unit();
    drawing.line(pin - direction * 200.0, pin + direction * 40.0, Stroke::Dotted, Hue::Orange);
    kit::arrow(&mut drawing, pin, pin + direction * 96.0, Hue::Orange);
    drawing.label(pin + direction * 96.0, Side::Right, r"$\boldsymbol{\omega}$", Hue::Orange)?;
    drawing.line(pin, pin - at(0.0, 96.0), Stroke::Reference, Hue::Muted);

    // Angles: θ at the centre; φ from the upright to ω, α from axis 1 to ω, at A.
    let (alpha, phi) = (hoop.axis_angle(), hoop.axis_shift());
    kit::angle(&mut drawing, centre, 46.0, upright, -theta, Heads::End, Hue::Ink);
    drawing.label(
        centre + Point::polar(46.0, upright - 0.5 * theta),
        Side::AboveRight,
        r"$\theta$",
        Hue::Ink,
    )?;
    kit::angle(&mut drawing, pin, 76.0, upright, -phi, Heads::None, Hue::Ink);
    drawing.label(pin + Point::polar(76.0, upright - 0.5 * phi), Side::Above, r"$\varphi$", Hue::Ink)?;
    kit::angle(&mut drawing, pin, 38.0, direction.angle(), alpha, Heads::None, Hue::Ink);
    drawing.label(
        pin + Point::polar(54.0, direction.angle() + 0.76 * alpha),
        Side::Over,
        r"$\alpha$",
        Hue::Ink,
    )?;

    let b = on_rim(theta + FRAC_PI_2);
    for (point, name, side) in [(pin, "$A$", Side::Right), (b, "$B$", Side::Right)] {
        drawing.dot(point, 4.5, Hue::Pink);
        drawing.label(point + at(6.0, 2.0), side, name, Hue::Pink)?;
    }
    drawing.line(centre, b, Stroke::Reference, Hue::Muted);
    kit::marker(&mut drawing, centre, Marker::Mass, Hue::Ink);
    drawing.label(centre.towards(b, 0.5), Side::BelowLeft, "$a$", Hue::Ink)?;
    Ok(drawing)
}

/// Speeds of the two points a quarter of the circle from A, and the stated answer.
pub(crate) fn speed_of_b(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 690.0, 350.0).titled(
        "Speeds of the two points a quarter of the circle from A",
        "Speeds in units of a omega zero against the angle theta from 0 to 90 degrees. The point at theta plus 90 degrees starts at one, falls to \
         zero at 71.57 degrees and rises to one third. The point at theta minus 90 degrees starts at one, rises a little and falls to \
         one third. A dashed curve, the stated answer, runs between the two and meets neither but at the ends.",
    );
    let angle = Axis::linear(0.0, 90.0, 15.0)?.minor(5.0).titled(r"angle $\theta$, degrees");
    let speed = Axis::linear(0.0, 1.2, 0.2)?.minor(0.05).titled(r"speed, in $a\omega_0$");
    let mut plot = Plot::new(&mut drawing, Rect::new(52.0, 34.0, 470.0, 262.0), angle, speed)?;
    type Velocity = fn(&Pinning) -> f64;
    let curves: [(Velocity, &str, Hue); 2] =
        [(Pinning::velocity_of_b, "plus", Hue::Blue), (Pinning::velocity_opposite_b, "minus", Hue::Green)];
    for (velocity, name, hue) in curves {
        let values = linear_steps(0.0, 90.0, 720)
            .map(|degrees| Ok((degrees, velocity(&pinning(Shape::Hoop, degrees)?).abs())))
            .collect::<Result<Vec<_>, InvalidQuantity>>()?;
        plot.curve(name, values, Stroke::Curve, hue);
    }
    let stated = linear_steps(0.0, 90.0, 180)
        .map(|degrees| {
            let hoop = pinning(Shape::Hoop, degrees)?;
            let (below, above) = (hoop.velocity_of_b(), hoop.velocity_opposite_b());
            Ok((degrees, (0.5 * (below * below + above * above)).sqrt()))
        })
        .collect::<Result<Vec<_>, InvalidQuantity>>()?;
    plot.curve("stated", stated, Stroke::DashedCurve, Hue::Pink);
    plot.label((46.0, 0.98), Side::AboveRight, r"at $\theta - 90°$", Hue::Green)?;
    plot.label((71.0, 0.27), Side::Over, "the stated answer", Hue::Pink)?;
    plot.label((37.0, 0.55), Side::BelowLeft, r"$B$, at $\theta + 90°$", Hue::Blue)?;
    plot.label((59.0, 0.06), Side::Over, "71.57°", Hue::Blue)?;
    Ok(drawing)
}

/// ω in the body after the snap, on the ellipsoid of equal energy.
pub(crate) fn polhodes(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 480.0, 400.0).titled(
        "Polhodes of the pinned hoop",
        "An ellipsoid, longest along axis 2. Four closed curves on it, the paths of minus omega, circle axis 2: a small one for 30 degrees, larger ones for 60 and 80, and one for \
         89 degrees that reaches almost to axis 1 and to its opposite, next to a dashed curve, the separatrix, that passes through axis 1.",
    );
    let moments = pinning(Shape::Hoop, 45.0)?.moments_about_pin().to_array();
    let semi = moments.map(|moment| 1.0 / moment.sqrt());
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0; 3],
        azimuth: 0.85,
        elevation: 0.42,
        distance: 9.0,
        centre: at(235.0, 200.0),
        scale: 122.0,
    })?);
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    stage.solid(Solid::ellipsoid([0.0; 3], axes, semi)?, Hue::Blue)?;
    for (degrees, hue) in [(30.0, Hue::Green), (60.0, Hue::Green), (80.0, Hue::Orange), (89.0, Hue::Pink)] {
        let hoop = pinning(Shape::Hoop, degrees)?;
        let top = hoop.free_motion()?;
        let period = top.period().ok_or("a polhode closes")?;
        let size = (2.0 * hoop.moments_about_pin().kinetic_energy(&hoop.omega_after())).sqrt();
        let path = linear_steps(0.0, period, 720)
            .map(|time| Ok(-top.at(time)?.omega_body / size))
            .collect::<Result<Vec<_>, InvalidQuantity>>()?;
        // Named where there is room: above its highest point, inside its turn, or on the way up.
        let on_the_way = path.iter().position(|point| point.x > 0.4 * path[360].x).ok_or("it crosses")?;
        let (place, step, side) = match degrees {
            60.0 | 80.0 => (360, at(2.0, 0.0), Side::Right),
            89.0 => (on_the_way, at(2.0, -5.0), Side::AboveLeft),
            _ => (180, at(0.0, 0.0), Side::Above),
        };
        stage.label_shifted(path[place], step, side, &format!("{degrees}°"), hue)?;
        stage.curve(Curve::smooth(path)?, Stroke::Curve, hue)?;
    }
    // The separatrix: L² = 2T I₁ on the ellipsoid, two plane curves through axis 1.
    let [i1, i2, i3] = moments;
    let slope = (i2 * (i1 - i2) / (i3 * (i3 - i1))).sqrt();
    for sign in [1.0, -1.0] {
        let across = 1.0 / (i2 + i3 * slope * slope).sqrt();
        let path: Vec<[f64; 3]> = linear_steps(0.0, 2.0 * PI, 360)
            .map(|angle| {
                let (sin, cos) = angle.sin_cos();
                [semi[0] * cos, across * sin, sign * slope * across * sin]
            })
            .collect();
        stage.curve(Curve::smooth(path)?, Stroke::Reference, Hue::Muted)?;
    }
    for (k, name) in
        [r"$\hat{\mathbf{1}}$", r"$\hat{\mathbf{2}}$", r"$\hat{\mathbf{3}}$"].into_iter().enumerate()
    {
        let direction = Vector3::from(axes[k]);
        stage.named_vector(direction * semi[k], direction * (semi[k] + 0.42), name, Hue::Ink)?;
    }
    stage.write(&mut drawing);
    Ok(drawing)
}

/// The components of ω in the plane of the hoop for a pin near a right angle.
pub(crate) fn flip(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 690.0, 340.0).titled(
        "The flip of a hoop pinned at 89.9 degrees",
        "Two components of omega against time in units of one over omega zero, from 0 to 150. The component along the tangent stays near one \
         third until about 20, falls through zero at 28 to minus one third, stays there till 78, and rises again. The component along the diameter through A is near zero but for \
         short negative pulses, to minus one third, at each of these flips.",
    );
    let hoop = pinning(Shape::Hoop, 89.9)?;
    let top = hoop.free_motion()?;
    let time = Axis::linear(0.0, 150.0, 30.0)?.minor(10.0).titled(r"time, in $1/\omega_0$");
    let omega = Axis::linear(-0.4, 0.4, 0.2)?.minor(0.05).titled(r"angular velocity, in $\omega_0$");
    let mut plot = Plot::new(&mut drawing, Rect::new(58.0, 34.0, 500.0, 250.0), time, omega)?;
    plot.level(0.0, Stroke::Reference);
    for (axis, name, hue) in [(0, "tangent", Hue::Orange), (1, "diameter", Hue::Blue)] {
        let values = linear_steps(0.0, 150.0, 1500)
            .map(|time| Ok((time, top.at(time)?.omega_body[axis])))
            .collect::<Result<Vec<_>, InvalidQuantity>>()?;
        plot.curve(name, values, Stroke::Curve, hue);
    }
    plot.label((150.0, 0.33), Side::Right, r"$\omega_1$, tangent", Hue::Orange)?;
    plot.label((150.0, -0.03), Side::Right, r"$\omega_2$, diameter", Hue::Blue)?;
    Ok(drawing)
}

/// The free motion in a room whose third axis lies along the angular momentum.
fn along_momentum(hoop: &Pinning) -> Result<(FreeTop, UnitQuaternion<f64>), Cause> {
    let upright = UnitQuaternion::rotation_between(&hoop.angular_momentum(), &Vector3::z())
        .ok_or("the momentum is not opposite to the upright")?;
    Ok((hoop.free_motion()?, upright))
}

/// The tip of ω in the room, seen along the angular momentum.
pub(crate) fn herpolhode(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 420.0, 400.0).titled(
        "The herpolhode of a hoop pinned at 60 degrees",
        "Seen along the angular momentum, the tip of omega traces a rosette of twelve loops between two dashed circles about the middle.",
    );
    let hoop = pinning(Shape::Hoop, 60.0)?;
    let (top, upright) = along_momentum(&hoop)?;
    let period = top.period().ok_or("it swings")?;
    let values = linear_steps(0.0, 6.0 * period, 6000)
        .map(|time| {
            let omega = upright * top.at(time)?.omega_world();
            Ok((omega.x, omega.y))
        })
        .collect::<Result<Vec<(f64, f64)>, InvalidQuantity>>()?;
    let reach = values.iter().map(|(x, y)| x.hypot(*y)).fold(0.0, f64::max);
    let least = values.iter().map(|(x, y)| x.hypot(*y)).fold(f64::INFINITY, f64::min);
    let side = || Axis::linear(-0.4, 0.4, 0.2).map(|axis| axis.minor(0.05));
    let (x, y) = (side()?.titled(r"$\omega_x/\omega_0$"), side()?.titled(r"$\omega_y/\omega_0$"));
    let mut plot = Plot::new(&mut drawing, Rect::new(58.0, 34.0, 320.0, 320.0), x, y)?;
    for radius in [least, reach] {
        let circle =
            linear_steps(0.0, 2.0 * PI, 180).map(|angle| (radius * angle.cos(), radius * angle.sin()));
        plot.curve(
            &format!("circle-{}", if radius == reach { "outer" } else { "inner" }),
            circle,
            Stroke::Reference,
            Hue::Muted,
        );
    }
    plot.curve("rosette", values, Stroke::Orbit, Hue::Orange);
    plot.label((0.39, 0.37), Side::Left, r"tip of $\boldsymbol{\omega}$", Hue::Orange)?;
    Ok(drawing)
}

/// Paths of the centres of a hoop and of a sphere, pinned at the same place.
pub(crate) fn hoop_and_sphere(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 660.0, 285.0).titled(
        "Paths of the centre of a hoop and of a sphere",
        "Two pictures, each with the pinned point A, the upright direction of the angular momentum and the path of the centre at unit distance from A. Left, the hoop's centre \
         goes round the upright and nods, so that its path fills a band of the sphere about A. Right, the sphere's centre goes round the upright on one circle.",
    );
    for (x, shape, time, name) in
        [(175.0, Shape::Hoop, 170.0, "hoop"), (490.0, Shape::Sphere, 40.0, "sphere")]
    {
        let body = pinning(shape, 89.0)?;
        let (top, upright) = along_momentum(&body)?;
        let path = linear_steps(0.0, time, 4000)
            .map(|t| Ok(upright * (top.at(t)?.world_from_body * body.centre())))
            .collect::<Result<Vec<_>, InvalidQuantity>>()?;
        let mut stage = Stage::new(Camera::new(View {
            target: [0.0, 0.0, -0.1],
            azimuth: -1.0,
            elevation: 0.42,
            distance: 9.0,
            centre: at(x, 160.0),
            scale: 98.0,
        })?);
        let (first, last) = (path[0], path[path.len() - 1]);
        stage.curve(Curve::smooth(path)?.hiding(Hiding::Ignored), Stroke::Orbit, Hue::Blue)?;
        stage.named_vector([0.0; 3], [0.0, 0.0, 1.15], r"$\boldsymbol{L}_A$", Hue::Green)?;
        stage.curve(Curve::segment([0.0; 3], last)?.hiding(Hiding::Ignored), Stroke::Outline, Hue::Blue)?;
        stage.dot([0.0; 3], 4.5, Hue::Pink)?;
        stage.label_shifted([0.0; 3], at(3.0, 5.0), Side::BelowRight, "$A$", Hue::Pink)?;
        stage.dot_in_front(first, 4.5, Hue::Muted)?;
        stage.dot(last, 4.5, Hue::Blue)?;
        stage.write(&mut drawing);
        drawing.label(at(x, 267.0), Side::Over, name, Hue::Ink)?;
    }
    Ok(drawing)
}

/// Error of the period by the parameter and by the complement.
pub(crate) fn period_error(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 680.0, 350.0).titled(
        "Error of the period near a right angle",
        "Both scales are logarithmic: along x the distance of the pin from a right angle, from 1e-12 to 0.1; along y the relative error of the period. Computed from the \
         parameter it rises from 1e-16 to a hundredth at 1e-8, where the curve ends. From the complement it stays at 1e-16.",
    );
    let (mut naive, mut better) = (Vec::new(), Vec::new());
    for distance in log_steps(1e-12, 0.1, 66) {
        let (cos, sin) = distance.sin_cos();
        let hoop = pinned(Shape::Hoop, Pin::Point { from_axis: sin, height: cos })?;
        let found = hoop.free_motion()?.period().ok_or("it tumbles")?;
        // eq:hoop-jacobi, with W from the same sine and cosine.
        let w = (sin * sin / 9.0 + cos * cos).sqrt();
        let exact = 4.0 * SQRT_2 / w * quarter_period(9.0 * cos * cos / (1.0 + 8.0 * cos * cos));
        let parameter = sin * sin / (1.0 + 8.0 * cos * cos);
        let by_parameter = 4.0 * SQRT_2 / w * quarter_period((1.0 - parameter).max(0.0));
        if by_parameter.is_finite() {
            naive.push((distance, (by_parameter / exact - 1.0).abs().max(1e-17)));
        }
        better.push((distance, (found / exact - 1.0).abs().max(1e-17)));
    }
    let distance = Axis::log(1e-12, 0.1, 2)?.titled(r"distance of the pin from a right angle, rad");
    let error = Axis::log(1e-17, 1.0, 2)?.titled("relative error of the period");
    let mut plot = Plot::new(&mut drawing, Rect::new(66.0, 34.0, 592.0, 262.0), distance, error)?;
    plot.series("parameter", &naive, Marker::Disc, Hue::Orange);
    plot.series("complement", &better, Marker::Square, Hue::Blue);
    plot.label((1e-7, 1e-3), Side::Right, "from the parameter $k^2$", Hue::Orange)?;
    plot.label((1e-11, 1e-14), Side::Right, r"from the complement $k'^2$", Hue::Blue)?;
    Ok(drawing)
}
