//! The curves of the free tops, read back from the SVG, lie on formulas that are
//! written out here.

use crate::{PIXELS, curve, find, lies_on, lines, parts};
use drawing::space::View;
use drawing::{Drawing, Fill, Hue, Piece, Point, Role, Shape, Stroke, at};
use mechanics::inertia::Body;
use mechanics::integrate::Dop853;
use mechanics::scenes::air_drag::{Drag, DraggedTop, DraggedTopParameters};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::{PI, TAU};

#[test]
fn the_circles_are_blue_down_to_the_equator_and_no_further() {
    let [edge_on, face_on] = parts("above")[..] else { panic!("two drawings") };
    // Edge-on: chords of the sphere, from the pole to 2ψ, the part above the equator in blue.
    let [blue, grey] = [Hue::Blue, Hue::Muted].map(|hue| lines(edge_on, Stroke::Curve, hue));
    let pole = blue[0][0];
    let south =
        grey.iter().copied().flatten().max_by(|one, other| one.y.total_cmp(&other.y)).expect("lowest");
    let radius = 0.5 * (south.y - pole.y);
    let on_sphere = |angle: f64| pole + at(angle.sin(), 1.0 - angle.cos()) * radius;
    assert_eq!((blue.len(), grey.len()), (5, 3));
    for (line, degrees) in blue.iter().zip([30.0_f64, 45.0, 60.0, 75.0, 90.0]) {
        let lowest = on_sphere(2.0 * degrees.to_radians());
        assert_eq!(line[0], pole);
        assert!(line[1].y - pole.y < radius + 0.01, "{degrees}: blue below the equator");
        // The equator cuts the chord where it is as far down as the centre.
        let part = (radius / (lowest.y - pole.y)).min(1.0);
        assert!((line[1] - pole.towards(lowest, part)).length() < 0.01, "{degrees}");
        let below = grey.iter().find(|below| (below[0] - line[1]).length() < 0.01);
        assert_eq!(below.is_some(), degrees > 45.1);
        assert!(below.is_none_or(|below| (below[1] - lowest).length() < 0.01));
    }
    // Face-on: the blue part of the circle is that of eq:same-face for 60°, whose cotangent squared is 1/3.
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
fn the_bias_is_an_inverse_sine_and_begins_as_a_square() {
    lies_on("bias", "probability", |ratio| {
        if ratio >= 0.5 { 0.9999999 } else { 0.5 + (4.0 * ratio * ratio).asin() / PI }
    });
    lies_on("bias", "square", |ratio| 0.5 + 4.0 / PI * ratio * ratio);
}

#[test]
fn the_edge_has_its_part_of_the_sphere_and_of_the_circle() {
    lies_on("edge-chance", "area", |ratio| ratio / (1.0 + ratio * ratio).sqrt());
    lies_on("edge-chance", "arc", |ratio| 2.0 / PI * ratio.atan());
    // A nickel, by counting phases: how often the normal's height is within the band.
    let sine = (1.95_f64 / 21.21).atan().sin();
    lies_on("edge-chance", "nickel", |degrees| {
        let square = degrees.to_radians().cos().powi(2);
        let border = |height: f64| ((height - square) / (1.0 - square)).clamp(-1.0, 1.0).acos();
        (border(-sine) - border(sine)) / PI
    });
    lies_on("edge-chance", "thin", |degrees| {
        2.0 * sine / (PI * (-(2.0 * degrees).to_radians().cos()).sqrt())
    });
}

#[test]
fn the_bands_of_the_two_coins_are_thirds() {
    let [area, arc] = parts("edge-band")[..] else { panic!("two drawings") };
    for (part, share) in [(area, 1.0_f64 / 3.0), (arc, 0.5)] {
        let sides = lines(part, Stroke::Curve, Hue::Pink);
        assert_eq!(sides.len(), 2);
        let ends = [sides[0][0], *sides[0].last().expect("an arc")];
        let [bottom, top] = ends.map(|end| end.y);
        let [right, left] = [0, 1].map(|side| sides[side].iter().map(|point| point.x));
        let width = right.fold(f64::MIN, f64::max) - left.fold(f64::MAX, f64::min); // the diameter
        assert!(((bottom - top).abs() / width - share).abs() < 1e-3);
        // The corners of the coin are those of the band.
        let faces = part.items().iter().filter(|item| item.role == Role::Area(Fill::Face, Hue::Blue));
        let corners: Vec<Point> = faces.flat_map(|item| item.shape.points()).collect();
        assert!(
            corners.len() >= 4
                && corners
                    .iter()
                    .all(|corner| (corner.y - top).abs() < 0.01 || (corner.y - bottom).abs() < 0.01)
        );
    }
}

#[test]
fn spheroids_lie_on_the_map_where_their_closed_form_puts_them() {
    lies_on("fates", "border", |ratio| 1.0 / ratio);
    lies_on("fates", "ten", |ratio| 10.0 / ratio);
    lies_on("fates", "tenth", |ratio| 0.1 / ratio);
    lies_on("fates", "spheroids", |ratio| {
        let square = 2.0 / ratio - 1.0;
        let eta = square.sqrt();
        if (square - 1.0).abs() < 1e-4 {
            return 1.0 + 0.6 * (1.0 - ratio);
        }
        let f =
            if eta < 1.0 { eta.acos() / (1.0 - square).sqrt() } else { eta.acosh() / (square - 1.0).sqrt() };
        2.0 * (eta - f) / ((2.0 * square - 1.0) * f - eta) / ratio
    });
}

#[test]
fn the_people_stand_about_the_spread_that_fits_them() {
    // A person of rank r has a twist below s = S z, where half the bell, the error function of z/√2, is r/48.
    let half_bell = |z: f64| -> f64 {
        // By its series, which shares nothing with the sum of the figure.
        let mut term = z * (2.0 / PI).sqrt();
        let mut sum = term;
        for n in 1..100 {
            let n = f64::from(n);
            term *= -0.5 * z * z / n;
            sum += term / (2.0 * n + 1.0);
        }
        sum
    };
    lies_on("people", "spread", |rank| {
        let (mut low, mut high) = (0.0, 5.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if half_bell(middle) < rank / 48.0 { low = middle } else { high = middle }
        }
        0.5 + (4.0 * (0.0904_f64 * low).powi(2)).asin() / PI
    });
    lies_on("people", "common", |_| 178_078.0 / 350_757.0);
    let rows = include_str!("../../coin-toss/flips.csv").lines();
    let rows: Vec<Vec<f64>> = rows
        .filter(|line| line.starts_with(|sign: char| sign.is_ascii_digit()))
        .map(|row| row.split(',').map(|cell| cell.parse().expect("a count")).collect())
        .collect();
    // In the bias b itself, whose bell has the weight ds = (ds/db) db, by midpoints in √b.
    let of = |spread: f64| -> f64 {
        let nodes: Vec<(f64, f64)> = (0..4000)
            .map(|n| (f64::from(n) + 0.5) / 4000.0 * 0.49_f64.sqrt())
            .map(|root| {
                let (bias, turn) = (root * root, PI * root * root);
                let square = 0.25 * turn.sin();
                // s² = sin(πb)/4, so ds/db = π cos(πb)/(8 s), and db = 2 √b d√b.
                let weight = PI * turn.cos() / (8.0 * square.sqrt()) * 2.0 * root;
                (weight * (-0.5 * square / (spread * spread)).exp() / spread, bias)
            })
            .collect();
        let person = |row: &Vec<f64>| {
            let (k, n) = (row[1] + row[3], row[0] + row[2]);
            let times = |p: f64| k * p.ln() + (n - k) * (1.0 - p).ln();
            nodes.iter().map(|(w, b)| w * (times(0.5 + b) - times(k / n)).exp()).sum::<f64>().ln()
        };
        rows.iter().map(person).sum()
    };
    let top = of(0.0904);
    lies_on("people", "likelihood", |spread| of(spread) - top);
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
    let layouts = find("toss-film").drawing.all_parts();
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
        let drawn = |star: &u32| {
            let name = format!("{name}-{star}");
            parts("crew-sky").iter().flat_map(|part| part.axes()).any(|axes| axes.curves.contains(&name))
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
    // The star that stood on the cross: to and fro through it, at half the rate of the nods.
    let old_pole = curve("crew-sky", "old-pole");
    for turns in [0.05, 0.2, 0.45, 0.6, 0.8] {
        let reach = 2.0 * (lean.sin() * (0.5 * TAU * nods * turns).sin()).asin();
        let [x, y, z] = struck([0.0, 0.0, 1.0], turns);
        assert!((z - reach.cos()).abs() < 1e-12, "{turns}");
        assert!(old_pole.distance(in_picture([x, y, z])) < PIXELS, "{turns}");
    }
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
    lies_on("two-clocks", "flat", |wobble: f64| (wobble / 0.6).sqrt());
    lies_on("two-clocks", "long", |wobble: f64| (wobble / 0.6).powi(2));
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

#[test]
fn the_axis_spirals_in_about_a_momentum_that_hardly_moves() {
    let (moments, omega_body) =
        (Body::thin_disk(0.175, 0.137).expect("a disc").moments(), Vector3::new(12.0, 0.0, 40.0));
    let top = DraggedTop::new(DraggedTopParameters { moments, drag: Drag::isotropic(2e-3), omega_body })
        .expect("a top");
    let momentum = moments.angular_momentum(&omega_body);
    let upright = UnitQuaternion::rotation_between(&momentum, &Vector3::z()).expect("a turn");
    let thrown = top.thrown(upright, &Dop853::new(1e-12).unwrap()).expect("a motion");
    let [omega, axis, direction] = ["omega", "axis", "momentum"].map(|name| curve("axis-path", name));
    for n in 0..1000 {
        let state = thrown.at(0.0059 * f64::from(n)).expect("a state");
        let (n, l) = (state.axis_3_world(), state.angular_momentum_world(&moments).normalize() * 1e3);
        assert!(axis.distance((n.x, n.y)) < PIXELS, "{n}");
        assert!(direction.distance((l.x, l.y)) < PIXELS, "{l}");
    }
    // On board the length of ω₁ + iω₂ in spins falls as the turns that are left do.
    let turns = momentum.z / (TAU * 2e-3);
    for step in 0..300 {
        let left = 1.0 - f64::from(step) / 300.0 * 0.98;
        let (sin, cos) = (TAU * turns * (1.0 - left)).sin_cos();
        assert!(omega.distance((0.3 * left * cos, 0.3 * left * sin)) < PIXELS, "{left}");
    }
}

/// How far a place is from the nearest line of a hue, px.
fn distance_from_lines(drawing: &Drawing, hue: Hue, place: Point) -> f64 {
    let to_segment = |from: Point, to: Point| {
        let (chord, step) = (to - from, place - from);
        let square = (chord.x * chord.x + chord.y * chord.y).max(f64::MIN_POSITIVE);
        let part = ((step.x * chord.x + step.y * chord.y) / square).clamp(0.0, 1.0);
        (step - chord * part).length()
    };
    let lines = drawing
        .items()
        .iter()
        .filter(|item| matches!(item.role, Role::Line(_, found) if found == hue))
        .map(|item| item.shape.points());
    lines
        .flat_map(|line| line.windows(2).map(|ends| to_segment(ends[0], ends[1])).collect::<Vec<_>>())
        .fold(f64::INFINITY, f64::min)
}

/// Where a view shows a place: turned about the upright, then about what points to the right, then smaller as it is
/// further away.
fn landed(view: &View, place: [f64; 3]) -> Point {
    let [x, y, z] = [0, 1, 2].map(|n| place[n] - view.target[n]);
    let ((sin, cos), (rise, flat)) = (view.azimuth.sin_cos(), view.elevation.sin_cos());
    let (right, near) = (y * cos - x * sin, x * cos + y * sin);
    let (up, near) = (z * flat - near * rise, z * rise + near * flat);
    let scale = view.scale / (1.0 - near / view.distance);
    view.centre + at(right * scale, -up * scale)
}

/// The direction at an angle from z and an azimuth, rad, of a length.
fn towards(angle: f64, azimuth: f64, length: f64) -> [f64; 3] {
    [angle.sin() * azimuth.cos(), angle.sin() * azimuth.sin(), angle.cos()].map(|part| length * part)
}

/// The part of a round about z, by steps of two degrees from an azimuth on, that lines of a hue show.
fn drawn_round(
    drawing: &Drawing,
    (camera, hue): (&View, Hue),
    (angle, length): (f64, f64),
    first: f64,
    tolerance: f64,
) -> Vec<bool> {
    let place = |step: i32| landed(camera, towards(angle, first + f64::from(step) * TAU / 180.0, length));
    (0..180).map(|step| distance_from_lines(drawing, hue, place(step)) < tolerance).collect()
}

#[test]
fn the_circle_of_the_frisbee_closes_and_that_of_the_pencil_opens() {
    for part in find("drag-stills").drawing.all_parts() {
        let down = part.height() > part.width();
        let mut stills = 0;
        for item in part.items() {
            let Shape::Label(label) = &item.shape else { continue };
            let [Piece::Words { text, .. }] = &label.pieces[..] else { continue };
            let Some(percent) = text.strip_suffix(" %").and_then(|text| text.split(' ').next_back()) else {
                continue;
            };
            let spin = percent.parse::<f64>().expect("a number") / 100.0;
            let place = label.bounds.centre();
            let pencil = if down { place.x > 0.5 * part.width() } else { place.y > 0.5 * part.height() };
            // tan θ_L at the start, the power of the spin by which it changes (eq:tangent-power), and what is drawn of
            // the axis. The drag of the pencil is that of eq:stick-drag, the face of the Frisbee counts ten times.
            let (start, power, length) = if pencil {
                let (i1, i3) = (0.14_f64.powi(2) / 4.0 + 2.3_f64.powi(2) / 12.0, 0.14_f64.powi(2) / 2.0);
                let drags = (2.3_f64 / 0.14).powi(2) / 12.0 / ((2.3_f64 / 0.28).ln() - 0.66);
                (6_f64, drags * i3 / i1 - 1.0, 1.15)
            } else {
                (30.0, 19.0, 1.1)
            };
            // The names have rounded numbers.
            let factor: f64 = if pencil { 0.1 } else { 0.5_f64.powf(1.0 / 19.0) };
            let spin = factor.powf((spin.ln() / factor.ln()).round());
            let angle = (start.to_radians().tan() * spin.powf(power)).atan();
            let below = if pencil || down { 76.0 } else { 60.0 };
            let camera = View {
                target: [0.0; 3],
                azimuth: -0.25 * TAU,
                elevation: 0.32,
                distance: 9.0,
                centre: place - at(0.0, below),
                scale: 50.0,
            };
            // A name stands within 2 px of where it is put.
            let round = drawn_round(part, (&camera, Hue::Blue), (angle, length), 0.0, 2.0);
            let seen = round.iter().filter(|&&drawn| drawn).count();
            assert!(seen > 150, "{text}, pencil: {pencil}, {}°: {seen} of 180", angle.to_degrees());
            stills += 1;
        }
        assert_eq!(stills, 8);
    }
}

/// Whether an arrow of a hue goes from the origin to a place: a head of the hue ends there, and a line leads to it.
fn has_arrow(drawing: &Drawing, camera: &View, hue: Hue, tip: [f64; 3]) -> bool {
    let end = landed(camera, tip);
    let head = drawing.items().iter().any(|item| {
        matches!(item.role, Role::Area(_, found) if found == hue)
            && matches!(item.shape, Shape::Polygon(_))
            && item.shape.points().iter().any(|point| (*point - end).length() < 0.5)
    });
    head && distance_from_lines(drawing, hue, landed(camera, tip.map(|part| 0.8 * part))) < 0.5
}

#[test]
fn the_axes_of_the_station_go_round_each_other_counter_clockwise() {
    let [room, board] = parts("station-views")[..] else { panic!("two views") };
    let camera = View {
        target: [0.0, 0.0, 0.4],
        azimuth: -1.2,
        elevation: 0.36,
        distance: 9.0,
        centre: at(160.0, 165.0),
        scale: 96.0,
    };
    // Twice the blow of the chapter: tan θ = 0.8 and half of that.
    let (omega, momentum) = (0.8_f64.atan(), 0.4_f64.atan());
    let up = [0.0, 0.0, 1.9];
    // In the room axis 3 begins on the other side of L than ω, and the picture is taken after 0.42 nods.
    let (azimuth, later) = (0.42 * TAU, 0.1 * TAU);
    for (view, hue, angle, azimuth) in [
        (room, Hue::Blue, momentum, azimuth + PI),
        (room, Hue::Orange, omega - momentum, azimuth),
        (board, Hue::Orange, omega, later),
        (board, Hue::Green, momentum, later),
    ] {
        assert!(has_arrow(view, &camera, hue, towards(angle, azimuth, 1.65)), "{hue:?} at {angle}");
        // The way goes on from there, counter-clockwise from above, and ends 0.07 of a round short of it.
        let round = drawn_round(view, (&camera, hue), (angle, 0.85 * 1.65), azimuth, 0.6);
        assert!(round[2..164].iter().filter(|&&drawn| drawn).count() > 155, "{hue:?}: {round:?}");
        assert!(!round[170..178].iter().any(|&drawn| drawn), "{hue:?}: {round:?}");
    }
    assert!(has_arrow(room, &camera, Hue::Green, up) && has_arrow(board, &camera, Hue::Blue, up));
}

#[test]
fn the_cones_touch_along_the_angular_velocity() {
    let [flat, long] = parts("cones-roll")[..] else { panic!("two pairs of cones") };
    for (view, ratio, degrees, aside) in [(flat, 2.0, 40.0_f64, 0.0), (long, 0.4, 20.0, -0.3)] {
        let camera = View {
            target: [aside, 0.0, 0.75],
            azimuth: -0.25 * TAU,
            elevation: 0.3,
            distance: 9.0,
            centre: at(165.0, 170.0),
            scale: 130.0,
        };
        // Angles from L, upright, to the right; axis 3 is to the left.
        let axis = -(degrees.to_radians().tan() / ratio).atan();
        let omega = axis + degrees.to_radians();
        assert_eq!(omega > 0.0, ratio > 1.0, "flat: beyond L; long: between L and axis 3");
        assert!(has_arrow(view, &camera, Hue::Green, [0.0, 0.0, 1.75]));
        assert!(has_arrow(view, &camera, Hue::Blue, towards(axis, 0.0, 1.75)));
        assert!(has_arrow(view, &camera, Hue::Orange, towards(omega, 0.0, 1.85)));
        // The rim of the space cone, and of the body cone what is not cut away, lie at their angles about their axes.
        let contact = landed(&camera, towards(omega, 0.0, 1.3));
        for part in [0.25, 0.5, 0.75] {
            let rim = landed(&camera, towards(omega.abs(), part * TAU, 1.3));
            assert!(distance_from_lines(view, Hue::Green, rim) < 0.6, "{ratio}: {part}");
        }
        assert!(distance_from_lines(view, Hue::Green, contact) < 0.6);
        let far = landed(&camera, towards(axis - degrees.to_radians(), 0.0, 1.3));
        assert!(distance_from_lines(view, Hue::Blue, far) < 0.6, "{ratio}");
    }
}
