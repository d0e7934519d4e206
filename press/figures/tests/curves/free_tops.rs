//! The curves of the free tops, read back from the SVG, lie on formulas that are
//! written out here.

use crate::{PIXELS, curve, figures, lies_on};
use drawing::{Drawing, Fill, Hue, Piece, Point, Role, Shape, Stroke};
use std::f64::consts::{PI, TAU};

#[test]
fn the_height_of_the_normal_is_a_cosine() {
    for (ratio, name) in [(0.2, "0.2"), (0.49, "0.49"), (0.5, "0.5"), (0.51, "0.51")] {
        let tangent: f64 = 1.0 / (2.0 * ratio);
        let sine = tangent * tangent / (1.0 + tangent * tangent);
        let height = |turns: f64| 1.0 - sine + sine * (TAU * turns).cos();
        lies_on("threshold", &format!("whole-{name}"), height);
        if ratio > 0.4 {
            lies_on("threshold", &format!("part-{name}"), height);
        }
    }
}

#[test]
fn the_bias_is_an_inverse_sine() {
    lies_on("bias", "probability", |degrees| {
        let cotangent = 1.0 / degrees.to_radians().tan();
        if degrees <= 45.0 { 0.9999999 } else { 0.5 + (cotangent * cotangent).asin() / PI }
    });
}

/// The middles of the faces of coins in a layout of the film, each with its hue; of faces that cover each other the
/// one that is painted last.
fn faces(film: &Drawing) -> Vec<(Point, Hue)> {
    let mut faces: Vec<(Point, Hue)> = Vec::new();
    for item in film.items() {
        let (Role::Area(Fill::Face, hue), Shape::Ellipse { centre, .. }) = (item.role, &item.shape) else {
            continue;
        };
        faces.retain(|(other, _)| (*other - *centre).length() > 12.0);
        faces.push((*centre, hue));
    }
    faces
}

#[test]
fn the_film_shows_the_face_that_is_up() {
    let figure = figures().iter().find(|figure| figure.id == "fig:toss-film").expect("the film");
    let layouts = figure.drawing.all_parts();
    assert_eq!(layouts.len(), 2, "one for wide pages, one for narrow ones");
    for film in layouts {
        let faces = faces(film);
        let down = film.height() > film.width();
        let along = |point: Point| if down { point.y } else { point.x };
        let first = faces.iter().map(|face| along(face.0)).fold(f64::INFINITY, f64::min);
        let last = faces.iter().map(|face| along(face.0)).fold(0.0, f64::max);
        let mut across: Vec<f64> = faces.iter().map(|face| if down { face.0.x } else { face.0.y }).collect();
        across.sort_by(f64::total_cmp);
        let mut seen = [0; 3];
        for &(middle, hue) in &faces {
            let part = (along(middle) - first) / (last - first);
            let place = if down { middle.x } else { middle.y };
            let strip = ((place - across[0]) / (across[across.len() - 1] - across[0]) * 2.0).round() as usize;
            let square = 1.0 / (1.0 + 4.0 * [0.0_f64, 0.25, 0.6][strip].powi(2)); // sin²ψ
            let frame = (8.0 * part).round() / 8.0;
            let height = 1.0 - square + square * (TAU * frame).cos();
            if height.abs() > 1e-9 {
                assert_eq!(hue == Hue::Blue, height > 0.0, "strip {strip} at {frame}");
                seen[strip] += 1;
            }
        }
        assert_eq!(seen, [7, 9, 9], "frames with a face up");
    }
}

#[test]
fn the_station_nods_faster_than_twice() {
    lies_on("nodding", "in-the-room", |turns| (TAU * turns * (4.0 + 0.4_f64.powi(2)).sqrt()).cos());
    lies_on("nodding", "claimed", |turns| (TAU * turns).cos());
    lies_on("nodding", "on-board", |turns| (TAU * turns).cos());
}

/// Where a picture whose edge is 50° from its middle has a direction, axis 2 to the right and axis 1 up.
fn in_picture([x, y, z]: [f64; 3]) -> (f64, f64) {
    // The tangent of half the angle from the middle, at the azimuth of the direction.
    let (half, across) = (0.5 * x.hypot(y).atan2(z), x.hypot(y));
    let radius = half.tan() / 25_f64.to_radians().tan();
    (radius * y / across, radius * x / across)
}

/// A vector turned about a unit axis (Rodrigues).
fn turned(v: [f64; 3], k: [f64; 3], angle: f64) -> [f64; 3] {
    let (sin, cos) = angle.sin_cos();
    let dot = v[0] * k[0] + v[1] * k[1] + v[2] * k[2];
    let cross = [k[1] * v[2] - k[2] * v[1], k[2] * v[0] - k[0] * v[2], k[0] * v[1] - k[1] * v[0]];
    [0, 1, 2].map(|n| v[n] * cos + cross[n] * sin + k[n] * dot * (1.0 - cos))
}

#[test]
fn star_trails_are_circles_about_one_axis_or_two() {
    let golden = |star: u32, of: u32| {
        let (z, turn) = (1.0 - (f64::from(star) + 0.5) / f64::from(of), 2.399_963 * f64::from(star));
        let across = (1.0 - z * z).sqrt();
        [across * turn.cos(), across * turn.sin(), z]
    };
    let up = [0.0, 0.0, 1.0];
    // In turns of the old spin: backwards about z alone; or about L, tan θ_L = 0.2, at Λ, and then forwards about 3.
    let lean = 0.2_f64.atan();
    let momentum = [lean.sin(), 0.0, lean.cos()];
    let nods = (4.0 + 0.4_f64.powi(2)).sqrt();
    let calm = |star: [f64; 3], turns: f64| turned(star, up, -TAU * turns);
    let struck =
        |star: [f64; 3], turns: f64| turned(turned(star, momentum, -TAU * nods * turns), up, TAU * turns);
    let mut checked = 0;
    for (name, of, exposure, motion) in [
        ("before", 130, 1.0 / 9.0, &calm as &dyn Fn([f64; 3], f64) -> [f64; 3]),
        ("after", 130, 1.0 / 18.0, &struck),
        ("turn", 26, 1.0, &struck),
    ] {
        let figure = figures().iter().find(|figure| figure.id == "fig:crew-sky").expect("the sky");
        let drawn = |star: &u32| {
            let name = format!("{name}-{star}");
            figure
                .drawing
                .parts()
                .iter()
                .any(|part| part.axes().iter().any(|axes| axes.curves.contains(&name)))
        };
        for star in (0..of).filter(drawn) {
            let trail = curve("crew-sky", &format!("{name}-{star}"));
            for step in 0..=37 {
                let turns = exposure * f64::from(step) / 37.0;
                let off = trail.distance(in_picture(motion(golden(star, of), turns)));
                assert!(off < PIXELS, "{name}-{star}: {off} px off after {turns} turns");
                checked += 1;
            }
        }
    }
    assert!(checked > 2000, "{checked}");
    let pole = curve("crew-sky", "pole");
    for turns in [0.01, 0.07, 0.13, 0.19] {
        let (sin, cos) = (TAU * turns).sin_cos();
        assert!(pole.distance(in_picture([0.4 * cos, 0.4 * sin, 1.0])) < PIXELS);
    }
}

#[test]
fn the_tangent_falls_and_rises_exponentially_and_as_a_power_of_the_spin() {
    for (ratio, name) in [(2.0, "2"), (1.0, "1"), (0.5, "0.5")] {
        lies_on("tangent", &format!("ratio-{name}"), |t: f64| 0.3 * (-(1.0 - 1.0 / ratio) * t).exp());
    }
    for (ratio, name) in [(2.0, "2"), (1.5, "1.5"), (1.0, "1"), (0.5, "0.5")] {
        lies_on("spin-tangent", &format!("ratio-{name}"), |spin: f64| spin.powf(ratio - 1.0));
    }
}

#[test]
fn the_two_parts_of_the_angular_velocity_are_powers_of_each_other() {
    lies_on("two-clocks", "flat", |wobble: f64| (wobble / 0.4).sqrt());
    lies_on("two-clocks", "long", |wobble: f64| (wobble / 0.4).powi(2));
}

#[test]
fn the_spiral_makes_as_many_turns_as_are_said() {
    let spiral = curve("wobble-turns", "spiral");
    for step in 0..300 {
        // With I₃ = 2I₁ and u = e^{−Ct/I₃} the length is u², and what is left of the turns is 3.3 u.
        let left = 1.0 - f64::from(step) / 300.0;
        let (sin, cos) = (TAU * 3.3 * (1.0 - left)).sin_cos();
        assert!(spiral.distance((left * left * cos, left * left * sin)) < PIXELS, "{left}");
    }
}

/// The axis n and the angular momentum of a disc with drag C, in the room: n′ = ω × n, L′ = −Cω with
/// ω = L/I₁ + (1/I₃ − 1/I₁)(L·n)n. By steps of fourth order.
fn thrown_disc(
    [i1, i3]: [f64; 2],
    drag: f64,
    mut state: [[f64; 3]; 2],
    seconds: f64,
    mut see: impl FnMut([[f64; 3]; 2]),
) {
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let plus = |a: [[f64; 3]; 2], b: [[f64; 3]; 2], by: f64| {
        [0, 1].map(|part| [0, 1, 2].map(|n| a[part][n] + by * b[part][n]))
    };
    let rates = |[axis, momentum]: [[f64; 3]; 2]| {
        let along = (1.0 / i3 - 1.0 / i1) * dot(momentum, axis);
        let omega = [0, 1, 2].map(|n| momentum[n] / i1 + along * axis[n]);
        [cross(omega, axis), omega.map(|component| -drag * component)]
    };
    let steps = 60_000;
    let h = seconds / f64::from(steps);
    for step in 0..=steps {
        if step % 60 == 0 {
            see(state);
        }
        let first = rates(state);
        let second = rates(plus(state, first, 0.5 * h));
        let third = rates(plus(state, second, 0.5 * h));
        let last = rates(plus(state, third, h));
        for (rate, by) in [(first, 1.0), (second, 2.0), (third, 2.0), (last, 1.0)] {
            state = plus(state, rate, by * h / 6.0);
        }
    }
}

#[test]
fn the_axis_spirals_in_about_a_momentum_that_hardly_moves() {
    let (i1, i3, drag) = (0.175 * 0.137_f64.powi(2) / 4.0, 0.175 * 0.137_f64.powi(2) / 2.0, 2e-3);
    // L upright at the start, its component 1 to the right in the body: the axis leans the other way.
    let (across, along) = (12.0 * i1, 40.0 * i3);
    let size = across.hypot(along);
    let start = [[-across / size, 0.0, along / size], [0.0, 0.0, size]];
    let [omega, axis, momentum] = ["omega", "axis", "momentum"].map(|name| curve("axis-path", name));
    let mut checked = 0;
    thrown_disc([i1, i3], drag, start, 5.9, |[n, l]| {
        let size = l.iter().map(|component| component * component).sum::<f64>().sqrt();
        assert!(axis.distance((n[0], n[1])) < PIXELS, "{n:?}");
        assert!(momentum.distance((1e3 * l[0] / size, 1e3 * l[1] / size)) < PIXELS, "{l:?}");
        checked += 1;
    });
    assert!(checked > 900);
    // On board the length of ω₁ + iω₂ in spins falls as the turns that are left do.
    let turns = 40.0 * i3 / (TAU * drag);
    for step in 0..300 {
        let left = 1.0 - f64::from(step) / 300.0 * 0.98;
        let (sin, cos) = (TAU * turns * (1.0 - left)).sin_cos();
        assert!(omega.distance((0.3 * left * cos, 0.3 * left * sin)) < PIXELS, "{left}");
    }
}

#[test]
fn the_circle_of_the_frisbee_closes() {
    let figure = figures().iter().find(|figure| figure.id == "fig:drag-stills").expect("the stills");
    for part in figure.drawing.all_parts() {
        let names = part.items().iter().filter_map(|item| match (&item.shape, item.role) {
            (Shape::Label(label), _) => match &label.pieces[..] {
                [Piece::Words { text, .. }] => Some((text.clone(), label.bounds.centre())),
                _ => None,
            },
            _ => None,
        });
        let stills: Vec<(f64, Point)> = names
            .filter_map(|(text, place)| {
                let percent = match text.as_str() {
                    "Frisbee, spin 100 %" => 100.0,
                    "50 %" => 50.0,
                    "12 %" => 12.5,
                    _ => return None,
                };
                Some((percent, place))
            })
            .collect();
        assert_eq!(stills.len(), 3, "{stills:?}");
        for (percent, name) in stills {
            // The line of the body's hue that lies wholly between 40 and 90 px over the middle of the still.
            let middle = name.y - 86.0;
            let widths = part.items().iter().filter_map(|item| {
                let points =
                    (item.role == Role::Line(Stroke::Outline, Hue::Blue)).then(|| item.shape.points())?;
                let above = points.iter().all(|point| {
                    (40.0..90.0).contains(&(middle - point.y)) && (point.x - name.x).abs() < 70.0
                });
                let x = |fold: fn(f64, f64) -> f64, from| points.iter().map(|point| point.x).fold(from, fold);
                above.then(|| x(f64::max, f64::NEG_INFINITY) - x(f64::min, f64::INFINITY))
            });
            let width = widths.fold(0.0, f64::max);
            // tan θ_L falls with the spin.
            let tangent = 30_f64.to_radians().tan() * percent / 100.0;
            let expected = 2.0 * 50.0 * 1.1 * tangent / tangent.hypot(1.0);
            assert!(
                (width - expected).abs() < 0.08 * expected + 0.7,
                "{percent} %: {width} px for {expected}"
            );
        }
    }
}
