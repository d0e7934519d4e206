//! The coin toss, the space station and air drag: curves lie on formulas that are written out here or on the library,
//! and pictures show what moves where it is.

use crate::{curve, find, lies_on, lines, parts, passes};
use drawing::space::{Camera, View};
use drawing::{Drawing, Fill, Hue, Point, Role, Shape, Stroke, at};
use mechanics::inertia::{Body, Spheroid};
use mechanics::integrate::Dop853;
use mechanics::scenes::air_drag::{Drag, DraggedTop, DraggedTopParameters};
use nalgebra::{Rotation3, UnitQuaternion, Vector3};
use std::f64::consts::{PI, TAU};

#[test]
fn the_chances_of_a_coin_are_inverse_sines_and_parts_of_a_sphere() {
    lies_on("bias", "probability", |ratio| {
        if ratio >= 0.5 { 0.9999999 } else { 0.5 + (4.0 * ratio * ratio).asin() / PI }
    });
    lies_on("bias", "square", |ratio| 0.5 + 4.0 / PI * ratio * ratio);
    lies_on("edge-chance", "area", |ratio| ratio / (1.0 + ratio * ratio).sqrt());
    lies_on("edge-chance", "arc", |ratio| 2.0 / PI * ratio.atan());
    // A nickel, by counting phases: how often the normal's height is within the band.
    let sine = (1.95_f64 / 21.21).atan().sin();
    lies_on("edge-chance", "nickel", |degrees| {
        let square = degrees.to_radians().cos().powi(2);
        let border = |height: f64| ((height - square) / (1.0 - square)).clamp(-1.0, 1.0).acos();
        (border(-sine) - border(sine)) / PI
    });
    // The blue part of the circle of 60° is that of eq:same-face, whose cotangent squared is 1/3.
    let face_on = parts("above")[1];
    let length = |hue: Hue| -> f64 {
        let items = face_on.items().iter().filter(|item| item.role == Role::Line(Stroke::Curve, hue));
        let lines: Vec<Vec<Point>> = items.map(|item| item.shape.points()).collect();
        lines.iter().flat_map(|line| line.windows(2)).map(|ends| (ends[1] - ends[0]).length()).sum()
    };
    let (above, below) = (length(Hue::Blue), length(Hue::Muted));
    let expected = 0.5 + (1.0_f64 / 3.0).asin() / PI;
    assert!((above / (above + below) - expected).abs() < 1e-3);
}

#[test]
fn the_bands_of_the_two_coins_are_thirds() {
    let [area, arc] = parts("edge-band")[..] else { panic!("two drawings") };
    for (part, share) in [(area, 1.0_f64 / 3.0), (arc, 0.5)] {
        let [right, left] = lines(part, Stroke::Curve, Hue::Pink)[..] else { panic!("two sides") };
        let height = (right[0].y - right[right.len() - 1].y).abs();
        let across = |side: &[Point]| side.iter().map(|point| point.x).collect::<Vec<_>>();
        let most = across(right).into_iter().fold(f64::MIN, f64::max);
        let width = most - across(left).into_iter().fold(f64::MAX, f64::min); // the diameter
        assert!((height / width - share).abs() < 1e-3, "{height} of {width}");
    }
}

#[test]
fn the_people_stand_about_the_spread_that_fits_them() {
    // A person of rank r has a twist below s = S z, where half the bell, the error function of z/√2, is r/48: by its
    // series, which shares nothing with the sum of the figure.
    let half_bell = |z: f64| -> f64 {
        let term = |term: &mut f64, n: u32| {
            *term *= if n == 0 { 1.0 } else { -0.5 * z * z / f64::from(n) };
            Some(*term / f64::from(2 * n + 1))
        };
        (0..100).scan(z * (2.0 / PI).sqrt(), term).sum()
    };
    passes(
        "people",
        "spread",
        (1..200).map(|n| {
            let z = f64::from(n) / 75.0;
            (48.0 * half_bell(z), 0.5 + (4.0 * (0.0904 * z).powi(2)).asin() / PI)
        }),
    );
    lies_on("people", "common", |_| 178_078.0 / 350_757.0);
    // As its description says: its top is at 0.090, and it is two below that at 0.073 and at 0.114.
    let likelihood = curve("people", "likelihood");
    for (spread, below) in [(0.0904, 0.0), (0.073, -2.0), (0.114, -2.0)] {
        let found = likelihood.value(spread);
        assert!((found - below).abs() < 0.2, "{found} at {spread}");
    }
}

#[test]
fn the_film_shows_the_face_that_is_up() {
    let layouts = find("toss-film").drawing.all_parts();
    assert_eq!(layouts.len(), 2, "one for wide pages, one for narrow ones");
    for film in layouts {
        // The middles of the faces, from the first frame on and from the first strip on; of faces that cover each other
        // the one that is painted last.
        let down = film.height() > film.width();
        let mut faces: Vec<(Point, Hue)> = Vec::new();
        for item in film.items() {
            let (Role::Area(Fill::Face, hue), Shape::Ellipse { centre, .. }) = (item.role, &item.shape)
            else {
                continue;
            };
            let middle = if down { at(centre.y, centre.x) } else { *centre };
            faces.retain(|(other, _)| (*other - middle).length() > 12.0);
            faces.push((middle, hue));
        }
        let ends = |along: fn(&Point) -> f64| {
            let places = || faces.iter().map(|(middle, _)| along(middle));
            (places().fold(f64::INFINITY, f64::min), places().fold(0.0, f64::max))
        };
        let ((first, last), (top, bottom)) = (ends(|middle| middle.x), ends(|middle| middle.y));
        let mut seen = [0; 3];
        for &(middle, hue) in &faces {
            let frame = (8.0 * (middle.x - first) / (last - first)).round() / 8.0;
            let strip = ((middle.y - top) / (bottom - top) * 2.0).round() as usize;
            let square = 1.0 / (1.0 + 4.0 * [0.0_f64, 0.25, 0.6][strip].powi(2)); // sin²θ_L
            let height = 1.0 - square + square * (TAU * frame).cos();
            if height.abs() > 1e-9 {
                assert_eq!(hue == Hue::Blue, height > 0.0, "strip {strip} at {frame}");
                seen[strip] += 1;
            }
        }
        assert_eq!(seen, [7, 9, 9], "frames with a face up");
    }
}

/// Where a picture whose edge is 50° from its middle has a direction, axis 2 to the right and axis 1 up.
fn in_picture(direction: Vector3<f64>) -> (f64, f64) {
    // The tangent of half the angle from the middle, at the azimuth of the direction.
    let across = direction.x.hypot(direction.y);
    let radius = (0.5 * across.atan2(direction.z)).tan() / 25_f64.to_radians().tan();
    (radius * direction.y / across, radius * direction.x / across)
}

#[test]
fn the_station_nods_and_star_trails_are_circles_about_one_axis_or_two() {
    // In turns of the old spin: backwards about 3 alone; or about L, tan θ_L = 0.2, at Λ, and then forwards about 3.
    let nods = (4.0 + 0.4_f64.powi(2)).sqrt();
    lies_on("nodding", "in-the-room", |turns| (TAU * turns * nods).cos());
    lies_on("nodding", "on-board", |turns| (TAU * turns).cos());
    let momentum = Vector3::new(0.2, 0.0, 1.0);
    let about = |axis: Vector3<f64>, turns: f64| Rotation3::new(axis.normalize() * (TAU * turns));
    let calm = |turns: f64| about(Vector3::z(), -turns);
    let struck = |turns: f64| about(Vector3::z(), turns) * about(momentum, -nods * turns);
    let golden = |star: u32, of: u32| {
        let (z, turn) = (1.0 - (f64::from(star) + 0.5) / f64::from(of), 2.399_963 * f64::from(star));
        let across = (1.0 - z * z).sqrt();
        Vector3::new(across * turn.cos(), across * turn.sin(), z)
    };
    let mut checked = 0;
    for (name, of, exposure, motion) in [
        ("before", 130, 1.0 / 9.0, &calm as &dyn Fn(f64) -> Rotation3<f64>),
        ("after", 130, 1.0 / 18.0, &struck),
    ] {
        let axes = || parts("crew-sky").into_iter().flat_map(Drawing::axes);
        let drawn = |star: &u32| axes().any(|axes| axes.curves.contains(&format!("{name}-{star}")));
        for star in (0..of).filter(drawn) {
            let trail = (0..=37).map(|step| motion(exposure * f64::from(step) / 37.0) * golden(star, of));
            checked += passes("crew-sky", &format!("{name}-{star}"), trail.map(in_picture));
        }
    }
    assert!(checked > 2000, "{checked}");
    // Four stars over a whole turn: one in the direction of L, and three beside it.
    let from_momentum = |distance: f64, heading: f64| {
        let lean = 0.2_f64.atan();
        // Away from L towards axis 3 at the start, which is to the side of minus axis 1; then about L.
        let beside = Rotation3::new(Vector3::new(0.0, -distance * lean, 0.0)) * momentum.normalize();
        Rotation3::new(momentum.normalize() * (TAU * heading)) * beside
    };
    for (name, distance, heading) in
        [("at-momentum", 0.0, 0.0), ("old-pole", 1.0, 0.0), ("ellipse-1", 2.6, 0.0), ("ellipse-2", 2.6, 0.5)]
    {
        let star = from_momentum(distance, heading);
        // A start or an end on the cross itself has no azimuth.
        let trail = (1..37).map(|step| in_picture(struck(f64::from(step) / 37.0) * star));
        passes("crew-sky", name, trail);
    }
    // The pole about which all turn.
    let pole = |turns: f64| about(Vector3::z(), turns) * Vector3::new(0.4, 0.0, 1.0);
    passes("crew-sky", "pole", [0.01, 0.07, 0.13, 0.19].map(|turns| in_picture(pole(turns))));
}

#[test]
fn after_a_small_blow_the_axis_runs_on_half_the_circle_and_the_star_on_a_line() {
    // In units of the lean of ω: a circle about (−½, 0), and the one about (−1, 0) that it leaves.
    let circle = |middle: f64, radius: f64| {
        (0..100).map(move |step| {
            let (sin, cos) = (TAU * f64::from(step) / 100.0).sin_cos();
            (middle + radius * cos, radius * sin)
        })
    };
    passes("equal-speed", "about-momentum", circle(-0.5, 0.5));
    passes("equal-speed", "about-omega", circle(-1.0, 1.0));
    // 2 sin ½Λt of the lean of L, at most, to the right.
    let line = (0..100).map(|step| (2.0 * (0.5 * TAU * 0.875 * f64::from(step) / 100.0).sin(), 0.0));
    passes("two-arrows", "star-3", line);
}

#[test]
fn the_star_over_a_tube_is_the_difference_of_two_arrows_that_turn_in_one_sense() {
    // By eq:nodding-rate the one turns with σ = −0.6 ω₃, and the other with −(Λ − σ) = −ω₃.
    let star = (0..300).map(|step| {
        let angle = 2.5 * TAU * f64::from(step) / 300.0;
        (angle.sin() - (0.6 * angle).sin(), (0.6 * angle).cos() - angle.cos())
    });
    passes("tube-sky", "star", star);
}

#[test]
fn spin_and_wobble_decay_exponentially_and_as_powers_of_each_other() {
    for (ratio, name) in [(2.0, "2"), (1.0, "1"), (0.5, "0.5")] {
        lies_on("tangent", &format!("ratio-{name}"), |t: f64| 0.3 * (-(1.0 - 1.0 / ratio) * t).exp());
        lies_on("spin-tangent", &format!("ratio-{name}"), |lost: f64| (1.0 - lost).powf(ratio - 1.0));
    }
    lies_on("spin-tangent", "frisbee", |lost: f64| (1.0 - lost).powi(19));
    // The example by hand: halved every 10 s, and every 20 s.
    lies_on("two-slopes", "spin", |t: f64| 20.0 * 0.5_f64.powf(t / 10.0));
    lies_on("two-slopes", "across", |t: f64| 2.0 * 0.5_f64.powf(t / 20.0));
    lies_on("two-clocks", "flat", |wobble: f64| (wobble / 0.6).sqrt());
    lies_on("two-clocks", "long", |wobble: f64| (wobble / 0.6).powi(2));
    for (name, clocks) in [("half", 0.5), ("same", 1.0), ("twice", 2.0), ("twenty", 20.0)] {
        lies_on("four-paths", name, |left: f64| left.powf(clocks));
    }
    // With I₃ = 2I₁ and u = e^{−Ct/I₃} the length is u², and what is left of the turns is 3.3 u.
    passes(
        "wobble-turns",
        "spiral",
        (0..300).map(|step| {
            let left = 1.0 - f64::from(step) / 300.0;
            let (sin, cos) = (TAU * 3.3 * (1.0 - left)).sin_cos();
            (left * left * cos, left * left * sin)
        }),
    );
    lies_on("fates", "spheroids", |ratio| {
        let shape = Spheroid { equatorial_radius: 1.0, polar_radius: (2.0 / ratio - 1.0_f64).sqrt() };
        Drag::of_spheroid(shape, 1.0).map_or(f64::NAN, |drag| drag.transverse / drag.axial)
    });
}

#[test]
fn the_axis_spirals_in_about_a_momentum_that_hardly_moves() {
    let (moments, omega_body) =
        (Body::thin_disk(0.175, 0.137).expect("a disc").moments(), Vector3::new(12.0, 0.0, 40.0));
    let top = DraggedTop::new(DraggedTopParameters { moments, drag: Drag::isotropic(2e-3), omega_body })
        .expect("a top");
    let momentum = moments.angular_momentum(&omega_body);
    let upright = UnitQuaternion::rotation_between(&momentum, &Vector3::z()).expect("a turn");
    let thrown = top.thrown(upright, &Dop853::new(1e-12).unwrap()).expect("a motion");
    let states = || (0..1000).map(|n| thrown.at(0.0059 * f64::from(n)).expect("a state"));
    passes("axis-path", "axis", states().map(|state| state.axis_3_world()).map(|axis| (axis.x, axis.y)));
    // Under the magnifier L begins at the top of a circle, whose radius is (C/I₁) (1 − I₁/I₃) ω₃ times the sine and the cosine of the
    // lean of L, divided by the rate L/I₁.
    let [across, _, along] = moments.to_array();
    let lean = (momentum.x / momentum.z).atan();
    let rate = momentum.norm() / across;
    let radius = 2e-3 * (1.0 / across - 1.0 / along) * along * 40.0 * lean.sin() / momentum.norm() / rate;
    let drawn = curve("axis-path", "momentum").values();
    assert!((drawn[0].0.hypot(drawn[0].1) / radius - 1.0).abs() < 0.1, "{:?} of {radius}", drawn[0]);
    // The axis of the disc leans from L by 30° all the way round.
    let ring = (1..90).map(|step| (TAU * (0.5 + 0.98 * f64::from(step) / 90.0)).sin_cos());
    passes("air-pull", "axis", ring.map(|(sin, cos)| (0.5 * cos, 0.5 * sin)));
}

/// How far a place is from the nearest line of a hue, px.
fn distance_from_lines(drawing: &Drawing, hue: Hue, place: Point) -> f64 {
    let to_segment = |from: Point, to: Point| {
        let (chord, step) = (to - from, place - from);
        let square = (chord.x * chord.x + chord.y * chord.y).max(f64::MIN_POSITIVE);
        let part = ((step.x * chord.x + step.y * chord.y) / square).clamp(0.0, 1.0);
        (step - chord * part).length()
    };
    let of_hue = |role| matches!(role, Role::Line(_, found) if found == hue);
    let found = drawing.items().iter().filter(|item| of_hue(item.role)).map(|item| item.shape.points());
    let least =
        |line: Vec<Point>| line.windows(2).map(|ends| to_segment(ends[0], ends[1])).fold(f64::MAX, f64::min);
    found.map(least).fold(f64::MAX, f64::min)
}

#[test]
fn the_cones_touch_along_the_angular_velocity() {
    for (place, ratio, degrees, aside) in [(0, 2.0, 40.0_f64, 0.0), (1, 0.4, 20.0, -0.3)] {
        let cones = parts("cones-roll")[place];
        let camera = Camera::new(View {
            target: [aside, 0.0, 0.75],
            azimuth: -0.25 * TAU,
            elevation: 0.3,
            distance: 9.0,
            centre: at(165.0, 170.0),
            scale: 130.0,
        });
        let camera = camera.expect("a view");
        // Angles from L, upright, to the right; axis 3 is to the left. Flat: ω beyond L; long: between L and axis 3.
        let axis = -(degrees.to_radians().tan() / ratio).atan();
        let omega = axis + degrees.to_radians();
        assert_eq!(omega > 0.0, ratio > 1.0);
        // The arrows; the rim of the space cone, and of the body cone what is not cut away, at their angles.
        for (hue, angle, azimuth, length) in [
            (Hue::Green, 0.0, 0.0, 1.4),
            (Hue::Ink, axis, 0.0, 1.4),
            (Hue::Orange, omega, 0.0, 1.4),
            (Hue::Green, omega, 0.0, 1.3),
            (Hue::Green, omega.abs(), 0.25 * TAU, 1.3),
            (Hue::Green, omega.abs(), 0.75 * TAU, 1.3),
            (Hue::Blue, axis - degrees.to_radians(), 0.0, 1.3),
        ] {
            let (across, up) = angle.sin_cos();
            let place = Vector3::new(across * azimuth.cos(), across * azimuth.sin(), up) * length;
            let off = distance_from_lines(cones, hue, camera.on_page(place).expect("before the eye"));
            assert!(off < 0.6, "{hue:?} of {ratio} at {angle}: {off} px");
        }
    }
}
