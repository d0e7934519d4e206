//! Scenes in space against a judge that walks along lines of sight.

#[path = "space/judge.rs"]
mod judge;
#[path = "space/motion.rs"]
mod motion;

use drawing::kit::Heads;
use drawing::space::{Camera, Curve, Edges, Finish, Hiding, Solid, SpaceError, Stage, View};
use drawing::{Drawing, Fill, Hue, Item, Point, Role, Shape, Side, Stroke, at};
use judge::{Body, Chance, Eye, Vector, dot, some_body, some_view, step, sum, times, unit};
use std::f64::consts::{FRAC_PI_2, TAU};

const UP: Vector = [0.0, 0.0, 1.0];
const ORIGIN: Vector = [0.0; 3];

fn usual_view() -> View {
    View {
        target: ORIGIN,
        azimuth: -1.1,
        elevation: 0.4,
        distance: 7.0,
        centre: at(200.0, 200.0),
        scale: 100.0,
    }
}

fn drawn(stage: &Stage) -> Drawing {
    let mut drawing = Drawing::new("fig:test", 400.0, 400.0).titled("A test", "A scene.");
    stage.write(&mut drawing);
    drawing
}

/// The polylines of a drawing with this role.
fn lines(drawing: &Drawing, role: Role) -> Vec<Vec<Point>> {
    let matching = |item: &&Item| item.role == role && !matches!(item.shape, Shape::Label(_));
    drawing.items().iter().filter(matching).map(|item| item.shape.points()).collect()
}

/// The least distance of a point from a polyline, px.
fn distance(points: &[Point], point: Point) -> f64 {
    let from_segment = |pair: &[Point]| {
        let (chord, far) = (pair[1] - pair[0], point - pair[0]);
        let square = chord.x * chord.x + chord.y * chord.y;
        let part =
            if square > 0.0 { ((far.x * chord.x + far.y * chord.y) / square).clamp(0.0, 1.0) } else { 0.0 };
        (far - chord * part).length()
    };
    points.windows(2).map(from_segment).fold(f64::INFINITY, f64::min)
}

/// Where a point lands on the page; none for one behind the eye.
fn landed(view: View, point: Vector) -> Option<Point> {
    let mut stage = Stage::new(Camera::new(view).expect("a view"));
    stage.dot(point, 1.0, Hue::Ink).ok()?;
    match drawn(&stage).items()[0].shape {
        Shape::Circle { centre, .. } => Some(centre),
        _ => None,
    }
}

#[test]
fn points_land_where_the_definition_of_the_view_puts_them() {
    let mut chance = Chance(1);
    for _ in 0..300 {
        let eye = Eye::new(some_view(&mut chance));
        assert_eq!(
            landed(eye.view, eye.view.target),
            Some(eye.view.centre),
            "the target lands on the centre"
        );
        for _ in 0..10 {
            let point = chance.vector(2.0);
            let page = landed(eye.view, point).expect("in front of the eye");
            assert!((page - eye.project(point)).length() < 1e-10, "{point:?} lands at {page:?}");
        }
    }
    // From straight above, with x to the right: azimuth −90° and elevation 90°.
    let above = View { azimuth: -FRAC_PI_2, elevation: FRAC_PI_2, ..usual_view() };
    let page = landed(above, [1.0, 0.5, 0.0]).expect("in front of the eye");
    assert!((page - at(300.0, 150.0)).length() < 1e-10, "{page:?}");
    // A distant eye sees what an eye at infinity sees, with an error like 1/distance.
    let seen = |distance: f64| {
        landed(View { distance, ..usual_view() }, [0.7, -0.4, 0.9]).expect("in front of the eye")
    };
    let far = |distance: f64| (seen(distance) - seen(f64::INFINITY)).length() * distance;
    assert!((far(1e4) / far(1e6) - 1.0).abs() < 1e-3 && far(1e6) > 1.0);
    assert_eq!(landed(usual_view(), times(Eye::new(usual_view()).back, 7.1)), None, "behind the eye");
}

/// Asks at many points of a segment whether the drawing and the judge agree on what is hidden. Points within
/// half a pixel of a boundary are left out, as the judge walks in steps. Returns how many points each way
/// were compared.
fn agree(eye: &Eye, bodies: &[Body], from: Vector, to: Vector) -> (usize, usize) {
    let mut stage = Stage::new(eye.camera());
    for body in bodies {
        stage.solid(body.solid().expect("a sound body"), Hue::Blue).expect("in front of the eye");
    }
    stage.curve(Curve::segment(from, to).expect("a segment"), Stroke::Curve, Hue::Pink).expect("a curve");
    let drawing = drawn(&stage);
    let seen = lines(&drawing, Role::Line(Stroke::Curve, Hue::Pink));
    let hidden = lines(&drawing, Role::Line(Stroke::Hidden, Hue::Pink));
    let boundaries: Vec<Point> =
        seen.iter().chain(&hidden).flat_map(|line| [line[0], line[line.len() - 1]]).collect();
    let mut counts = (0, 0);
    for index in 0..=100 {
        let point = sum(from, times(step(from, to), f64::from(index) / 100.0));
        let page = eye.project(point);
        if boundaries.iter().any(|&boundary| (boundary - page).length() < 0.5) {
            continue;
        }
        let [as_seen, as_hidden] =
            [&seen, &hidden].map(|lines| lines.iter().any(|line| distance(line, page) < 1e-6));
        assert!(as_seen != as_hidden, "{point:?} is drawn once");
        let place = eye.place(point);
        let behind = bodies.iter().any(|body| body.met(place, point, 4000).is_some());
        assert_eq!(as_hidden, behind, "{bodies:?}: {point:?} of {from:?} to {to:?} seen from {:?}", eye.view);
        *(if behind { &mut counts.1 } else { &mut counts.0 }) += 1;
    }
    counts
}

#[test]
fn a_segment_behind_a_disc_is_hidden_over_exactly_the_right_interval() {
    // Seen along the axis of a thin disc of radius 1 from 4 above it, the segment one below lies behind it as far as
    // x = ±√((5/4)² − y²) with y = 0.75: ±1, and a little less for the disc's lower face.
    let thickness = 1e-6;
    let view = View { azimuth: -FRAC_PI_2, elevation: FRAC_PI_2, distance: 4.0, ..usual_view() };
    let mut stage = Stage::new(Camera::new(view).expect("a view"));
    stage.solid(Solid::disc(ORIGIN, UP, 1.0, thickness).expect("a disc"), Hue::Blue).expect("a disc");
    let segment = Curve::segment([-2.0, 0.75, -1.0], [2.0, 0.75, -1.0]).expect("a segment");
    stage.curve(segment, Stroke::Curve, Hue::Pink).expect("a curve");
    let drawing = drawn(&stage);
    let hidden = lines(&drawing, Role::Line(Stroke::Hidden, Hue::Pink));
    let [line] = &hidden[..] else { panic!("one hidden piece: {hidden:?}") };
    // One unit at this depth is 100·4/5 px.
    for (end, x) in [(line[0], -80.0), (line[line.len() - 1], 80.0)] {
        assert!((end - at(200.0 + x, 200.0 - 60.0)).length() < 1e-3, "{end:?}");
    }
    assert_eq!(lines(&drawing, Role::Line(Stroke::Curve, Hue::Pink)).len(), 2);

    let mut chance = Chance(2);
    let mut counts = (0, 0);
    for kind in 0..5 {
        for _ in 0..12 {
            let eye = Eye::new(some_view(&mut chance));
            let body = some_body(kind, &mut chance);
            let found = agree(&eye, &[body], chance.vector(1.5), chance.vector(1.5));
            counts = (counts.0 + found.0, counts.1 + found.1);
        }
    }
    assert!(counts.0 > 3000 && counts.1 > 700, "{counts:?}");
    // Half a cone, whose cut sides are boundaries too.
    let mut cut = (0, 0);
    for _ in 0..24 {
        let eye = Eye::new(some_view(&mut chance));
        let Body::Cone(apex, axis, half_angle, length) = some_body(3, &mut chance) else { panic!("a cone") };
        let body = Body::HalfCone(apex, axis, half_angle, length, chance.direction());
        let found = agree(&eye, &[body], chance.vector(1.2), chance.vector(1.2));
        cut = (cut.0 + found.0, cut.1 + found.1);
    }
    assert!(cut.0 > 1500 && cut.1 > 150, "{cut:?}");
    // Behind a cone half-way up, where only its straight outlines bound what is hidden.
    let eye = Eye::new(View { azimuth: 0.0, elevation: 0.1, ..usual_view() });
    let cone = Body::Cone([0.0, 0.0, -1.0], UP, 0.5, 2.0);
    let found = agree(&eye, &[cone], [-1.0, -1.5, 0.0], [-1.0, 1.5, 0.0]);
    assert!(found.0 > 30 && found.1 > 30, "{found:?}");
}

#[test]
fn several_solids_hide_together_what_each_hides() {
    let mut chance = Chance(3);
    let mut hidden = 0;
    for index in 0..12 {
        let eye = Eye::new(some_view(&mut chance));
        let bodies = [0, 1, 2].map(|next| some_body(index + next, &mut chance));
        hidden += agree(&eye, &bodies, chance.vector(1.5), chance.vector(1.5)).1;
    }
    assert!(hidden > 200, "{hidden}");
}

#[test]
fn the_outline_of_an_ellipsoid_is_where_lines_of_sight_touch_it() {
    let mut chance = Chance(4);
    for _ in 0..20 {
        let eye = Eye::new(some_view(&mut chance));
        let body = some_body(4, &mut chance);
        let Body::Ellipsoid(centre, axes, radii) = body else { panic!("an ellipsoid") };
        let mut stage = Stage::new(eye.camera());
        stage.solid(body.solid().expect("sound"), Hue::Green).expect("in front of the eye");
        let drawing = drawn(&stage);
        let outline = lines(&drawing, Role::Line(Stroke::Outline, Hue::Green)).concat();
        let filled = lines(&drawing, Role::Area(Fill::Round, Hue::Green)).concat();
        // The least value on a line of sight of the form that is 1 on the ellipsoid, by golden section.
        let least = |page: Point| {
            let (near, far) = eye.sight(page);
            let form = |part: f64| -> f64 {
                let point = step(centre, sum(near, times(step(near, far), part)));
                (0..3).map(|index| (dot(point, axes[index]) / radii[index]).powi(2)).sum()
            };
            let (golden, mut low, mut high) = (0.5 * (5.0_f64.sqrt() - 1.0), 0.0, 1.0);
            for _ in 0..80 {
                let (first, second) = (high - golden * (high - low), low + golden * (high - low));
                if form(first) < form(second) { high = second } else { low = first }
            }
            form(0.5 * (low + high))
        };
        let middle = eye.project(centre);
        for turn in 0..90 {
            let way = Point::polar(1.0, TAU * f64::from(turn) / 90.0);
            let (mut inside, mut outside) = (0.0, 300.0);
            for _ in 0..40 {
                let reach = 0.5 * (inside + outside);
                *(if least(middle + way * reach) < 1.0 { &mut inside } else { &mut outside }) = reach;
            }
            let touched = middle + way * inside;
            // The polyline is thinned to 0.06 px; the shape of the fill comes here as 120 chords.
            assert!(
                distance(&outline, touched) < 0.1,
                "{touched:?} is {} px off",
                distance(&outline, touched)
            );
            assert!(
                distance(&filled, touched) < 0.1,
                "{touched:?} is {} px off the fill",
                distance(&filled, touched)
            );
        }
    }
}

#[test]
fn curves_on_a_surface_do_not_flicker() {
    let mut chance = Chance(5);
    let mut pieces = 0;
    for index in 0..60 {
        let eye = Eye::new(some_view(&mut chance));
        let (axes, radii) = (chance.axes(), [1.0, 0.8, 0.5]);
        let mut stage = Stage::new(eye.camera());
        let place = |[x, y, z]: Vector| sum(sum(times(axes[0], x), times(axes[1], y)), times(axes[2], z));
        stage.solid(Solid::ellipsoid(ORIGIN, axes, radii).expect("sound"), Hue::Blue).expect("in sight");
        // A circle of the unit sphere, stretched: points as they come out of arithmetic, some a little inside.
        let (normal, offset) = (chance.direction(), chance.number(-0.9, 0.9));
        let first = unit(judge::cross(normal, [0.2, 0.9, -0.4]));
        let (second, radius) = (judge::cross(normal, first), (1.0 - offset * offset).sqrt());
        let point = |turn: i32| {
            let (sin, cos) = (TAU * f64::from(turn % 150) / 150.0).sin_cos();
            let ball = sum(times(normal, offset), times(sum(times(first, cos), times(second, sin)), radius));
            times(
                place([ball[0] * radii[0], ball[1] * radii[1], ball[2] * radii[2]]),
                1.0 - 1e-6 * f64::from(turn % 2),
            )
        };
        let curve = Curve::smooth((0..=150).map(point)).expect("a curve");
        stage.curve(curve, Stroke::Curve, Hue::Pink).expect("in sight");
        let drawing = drawn(&stage);
        let seen = lines(&drawing, Role::Line(Stroke::Curve, Hue::Pink)).len();
        let hidden = lines(&drawing, Role::Line(Stroke::Hidden, Hue::Pink)).len();
        assert!(seen <= 1 && hidden <= 1, "{index}: {seen} seen and {hidden} hidden pieces");
        pieces += seen + hidden;
    }
    assert!(pieces > 75, "{pieces}: most curves pass behind the outline");
    // A spoke on the face of a disc, a circle on its rim, and the line in which two cones touch.
    let mut stage = Stage::new(Camera::new(usual_view()).expect("a view"));
    stage.solid(Solid::disc(ORIGIN, UP, 1.0, 0.1).expect("a disc"), Hue::Blue).expect("in sight");
    for turn in 0..24 {
        let (sin, cos) = (TAU * f64::from(turn) / 24.0).sin_cos();
        let spoke = Curve::segment([0.0, 0.0, 0.05], [cos, sin, 0.05]).expect("a segment");
        stage.curve(spoke, Stroke::Curve, Hue::Pink).expect("in sight");
    }
    stage
        .curve(Curve::circle([0.0, 0.0, 0.05], UP, 1.0).expect("a circle"), Stroke::Curve, Hue::Pink)
        .expect("in sight");
    let drawing = drawn(&stage);
    assert_eq!(lines(&drawing, Role::Line(Stroke::Curve, Hue::Pink)).len(), 25);
    assert!(lines(&drawing, Role::Line(Stroke::Hidden, Hue::Pink)).is_empty());
    let mut stage = Stage::new(Camera::new(usual_view()).expect("a view"));
    let (space, body) = (0.4_f64, 0.6_f64);
    let axis = [(space + body).sin(), 0.0, (space + body).cos()];
    stage.solid(Solid::cone(ORIGIN, UP, space, 1.0).expect("a cone"), Hue::Green).expect("in sight");
    stage.solid(Solid::cone(ORIGIN, axis, body, 1.0).expect("a cone"), Hue::Blue).expect("in sight");
    let contact = Curve::segment(ORIGIN, [space.sin(), 0.0, space.cos()]).expect("a segment");
    stage.curve(contact, Stroke::Curve, Hue::Pink).expect("in sight");
    assert_eq!(lines(&drawn(&stage), Role::Line(Stroke::Curve, Hue::Pink)).len(), 1);
}

/// The hue that the areas of a drawing leave on a point of the page.
fn painted(drawing: &Drawing, page: Point) -> Option<Hue> {
    let covers = |item: &&Item| {
        let Role::Area(Fill::Face | Fill::Side | Fill::Round, _) = item.role else { return false };
        let points = item.shape.points();
        // Winding number, so that a hole that is cut the other way round is empty.
        let mut winding = 0;
        for (a, b) in points.iter().zip(points.iter().cycle().skip(1)) {
            let left = (b.x - a.x) * (page.y - a.y) - (b.y - a.y) * (page.x - a.x);
            if a.y <= page.y && b.y > page.y && left > 0.0 {
                winding += 1;
            } else if a.y > page.y && b.y <= page.y && left < 0.0 {
                winding -= 1;
            }
        }
        winding != 0
    };
    drawing.items().iter().rfind(covers).and_then(|item| match item.role {
        Role::Area(_, hue) => Some(hue),
        _ => None,
    })
}

/// Compares, on a grid over the page, what is painted with what the judge sees first. Where the judge's
/// answer changes within two pixels nothing is compared. Returns how many points were.
fn right_areas(eye: &Eye, bodies: &[Body]) -> usize {
    let mut stage = Stage::new(eye.camera());
    for (body, hue) in bodies.iter().zip(Hue::ALL) {
        stage.solid(body.solid().expect("a sound body"), hue).expect("in front of the eye");
    }
    let drawing = drawn(&stage);
    let first = |page: Point| {
        let (near, far) = eye.sight(page);
        let met = |body: &Body| body.met(near, far, 1500);
        let nearest = bodies.iter().zip(Hue::ALL).filter_map(|(body, hue)| Some((met(body)?, hue)));
        nearest.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, hue)| hue)
    };
    let mut compared = 0;
    for row in 0..24 {
        for column in 0..24 {
            let page = at(200.0 + 12.0 * f64::from(column - 12), 200.0 + 12.0 * f64::from(row - 12));
            let expected = first(page);
            let steady = [at(2.0, 0.0), at(-2.0, 0.0), at(0.0, 2.0), at(0.0, -2.0)]
                .iter()
                .all(|&aside| first(page + aside) == expected);
            if steady {
                assert_eq!(
                    painted(&drawing, page),
                    expected,
                    "{bodies:?} at {page:?} seen as {:?}",
                    eye.view
                );
                compared += usize::from(expected.is_some());
            }
        }
    }
    compared
}

#[test]
fn what_is_painted_last_is_what_is_in_front() {
    let tube = |centre: Vector, axis: Vector, half: f64, radius: f64, hole: f64| {
        let axis = times(unit(axis), half);
        Body::Tube(step(axis, centre), sum(centre, axis), radius, hole)
    };
    let shaft = tube(ORIGIN, UP, 1.2, 0.08, 0.0);
    let scenes: [(&str, Vec<Body>); 8] = [
        ("plate on a shaft", vec![tube(ORIGIN, [0.5, 0.0, 0.8], 0.05, 0.9, 0.0), shaft.clone()]),
        (
            "sphere on a rod",
            vec![
                tube([0.0, 0.0, 0.1], [0.3, 0.5, 0.7], 1.3, 0.1, 0.0),
                Body::Ellipsoid(ORIGIN, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], UP], [0.5; 3]),
            ],
        ),
        (
            "rod through a ring",
            vec![
                tube(ORIGIN, [0.3, 0.2, 1.0], 0.1, 0.9, 0.7),
                tube([0.2, 0.1, 0.0], [0.2, 0.4, 0.9], 1.3, 0.07, 0.0),
            ],
        ),
        (
            "linked rings",
            vec![
                tube([-0.45, 0.0, 0.0], [0.2, -0.3, 1.0], 0.08, 0.8, 0.6),
                tube([0.45, 0.0, 0.0], [0.1, 1.0, 0.2], 0.08, 0.8, 0.6),
            ],
        ),
        (
            "pistons on a plate",
            vec![
                tube(ORIGIN, [0.3, 0.1, 1.0], 0.05, 0.9, 0.0),
                shaft,
                tube([0.5, 0.3, 0.5], UP, 0.25, 0.15, 0.0),
                tube([-0.5, 0.3, 0.7], UP, 0.25, 0.15, 0.0),
                tube([0.1, -0.5, 0.5], UP, 0.25, 0.15, 0.0),
            ],
        ),
        (
            "cone beside a cone",
            vec![Body::Cone(ORIGIN, UP, 0.4, 1.2), Body::Cone(ORIGIN, [0.9, 0.0, 0.5], 0.5, 1.2)],
        ),
        (
            "cone in half a cone",
            vec![
                Body::Cone(ORIGIN, UP, 0.3, 1.2),
                Body::HalfCone(ORIGIN, [-0.5, 0.0, 0.8], 0.95, 1.2, [0.1, -1.0, 0.0]),
            ],
        ),
        (
            "pencil in a cone",
            vec![Body::Cone(ORIGIN, UP, 0.6, 1.1), tube([0.0, 0.0, 0.9], [0.1, 0.0, 1.0], 0.6, 0.06, 0.0)],
        ),
    ];
    for (name, bodies) in scenes {
        for (azimuth, elevation, distance) in
            [(-1.1, 0.4, 7.0), (0.7, 0.5, 6.0), (2.4, 0.9, 9.0), (-2.6, 0.25, f64::INFINITY), (0.2, 1.2, 5.0)]
        {
            let eye = Eye::new(View { azimuth, elevation, distance, ..usual_view() });
            let compared = right_areas(&eye, &bodies);
            assert!(compared > 15, "{name}: only {compared} points were compared");
        }
    }
}

/// A scene with everything, at random.
fn anything(seed: u64) -> Result<Drawing, SpaceError> {
    let mut chance = Chance(seed);
    let eye = Eye::new(some_view(&mut chance));
    let mut stage = Stage::new(eye.camera());
    stage.ground([-1.5, -1.5], [1.5, 1.2], -1.0, 0.25)?;
    for kind in 0..5 {
        if chance.number(0.0, 1.0) < 0.6 {
            let edges = [Edges::Seen, Edges::BehindOthers][(seed % 2) as usize];
            let finish = if seed.is_multiple_of(4) { Finish::Glass } else { Finish::Opaque };
            stage.solid(some_body(kind, &mut chance).solid()?.edges(edges).finish(finish), Hue::Blue)?;
        }
    }
    let (centre, axis) = (chance.vector(0.5), chance.direction());
    stage.named_vector(chance.vector(1.0), chance.vector(1.0), r"$\boldsymbol\omega$", Hue::Orange)?;
    stage.turning(centre, axis, 0.3, Hue::Orange)?;
    stage.angle(centre, axis, chance.direction(), 0.5, r"$\alpha$", Hue::Ink)?;
    stage.curve(Curve::circle(centre, axis, 1.0)?, Stroke::Curve, Hue::Green)?;
    let hiding = [Hiding::Dashed, Hiding::Omitted, Hiding::Ignored][(seed % 3) as usize];
    stage.arrow(
        Curve::smooth([chance.vector(1.0), chance.vector(1.0), chance.vector(1.0)])?.hiding(hiding),
        Stroke::Outline,
        Heads::Both,
        Hue::Green,
    )?;
    stage.dot(chance.vector(1.0), 3.0, Hue::Pink)?;
    stage.label(chance.vector(1.0), Side::Right, "a label", Hue::Ink)?;
    Ok(drawn(&stage))
}

#[test]
fn scenes_at_random_are_finite_and_the_same_twice() {
    for seed in 0..200 {
        let drawing = anything(seed).expect("a sound scene");
        for item in drawing.items() {
            let sound = item.shape.points().iter().all(|point| point.x.is_finite() && point.y.is_finite());
            assert!(sound, "{seed}: {item:?}");
        }
        let svg = drawing.to_svg().expect("no flaw");
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{seed}: {svg}");
        assert!(roxmltree::Document::parse(&svg).is_ok(), "{seed}");
        assert_eq!(svg, anything(seed).expect("a sound scene").to_svg().expect("no flaw"), "{seed}");
    }
}

#[test]
fn what_is_hidden_is_pale_or_left_out() {
    let scene = |hiding: Hiding| {
        let mut stage = Stage::new(Camera::new(usual_view()).expect("a view"));
        let sphere = Solid::sphere(ORIGIN, 1.0).expect("a sphere");
        stage.solid(sphere, Hue::Blue).expect("in sight");
        let eye = Eye::new(usual_view());
        let behind = sum(times(eye.back, -1.2), times(eye.right, 0.5));
        let shaft = Curve::segment(ORIGIN, behind).expect("a segment").hiding(hiding);
        stage.arrow(shaft, Stroke::Vector, Heads::Both, Hue::Pink).expect("in sight");
        let ring = Curve::circle(ORIGIN, UP, 0.9).expect("a circle").hiding(hiding);
        stage.curve(ring, Stroke::Curve, Hue::Pink).expect("in sight");
        stage.dot(behind, 3.0, Hue::Pink).expect("in sight");
        stage.dot([0.0, 0.0, 0.2], 5.0, Hue::Pink).expect("in sight");
        drawn(&stage)
    };
    let pink = |drawing: &Drawing| -> Vec<Role> {
        let roles = drawing.items().iter().map(|item| item.role);
        roles.filter(|role| matches!(role, Role::Line(_, Hue::Pink) | Role::Area(_, Hue::Pink))).collect()
    };
    let pale = Role::Line(Stroke::Hidden, Hue::Pink);
    let dashed = pink(&scene(Hiding::Dashed));
    assert!(dashed.len() >= 5 && dashed.iter().all(|&role| role == pale), "{dashed:?}");
    assert_eq!(pink(&scene(Hiding::Omitted)), vec![pale; 2], "only the two points");
    let ignored = pink(&scene(Hiding::Ignored));
    assert_eq!(ignored.iter().filter(|&&role| role == pale).count(), 2, "{ignored:?}");
    assert!(
        ignored.contains(&Role::Line(Stroke::Vector, Hue::Pink))
            && ignored.contains(&Role::Line(Stroke::Curve, Hue::Pink))
    );
}

#[test]
fn arrowheads_keep_their_size_and_end_at_their_points() {
    let view = usual_view();
    let eye = Eye::new(view);
    let mut stage = Stage::new(eye.camera());
    // One close to the eye, one far from it: their shafts differ, their heads do not.
    let tips = [[0.0, -2.5, 0.8], [0.0, 3.0, 0.8]];
    for tip in tips {
        stage.vector(step(UP, tip), tip, Hue::Pink).expect("in sight");
    }
    let drawing = drawn(&stage);
    let heads = lines(&drawing, Role::Area(Fill::Solid, Hue::Pink));
    assert_eq!(heads.len(), 2);
    for (head, tip) in heads.iter().zip(tips) {
        assert!((head[0] - eye.project(tip)).length() < 1e-9);
        let width = (head[1] - head[3]).length();
        assert!((width - 7.2).abs() < 1e-9, "{width} px");
    }
    // The shaft ends in the notch of the head, 10 − 2.2 px before the tip.
    for (shaft, tip) in lines(&drawing, Role::Line(Stroke::Vector, Hue::Pink)).iter().zip(tips) {
        let gap = (shaft[shaft.len() - 1] - eye.project(tip)).length();
        assert!((gap - 7.8).abs() < 1e-9, "{gap} px");
    }
    // A turning arrow about z goes counter-clockwise as seen from above: on the page its near side runs to the right.
    let mut stage = Stage::new(eye.camera());
    stage.turning(ORIGIN, UP, 1.0, Hue::Orange).expect("in sight");
    let line = lines(&drawn(&stage), Role::Line(Stroke::Outline, Hue::Orange)).concat();
    let lowest = (1..line.len() - 1).max_by(|&a, &b| line[a].y.total_cmp(&line[b].y)).expect("points");
    assert!(line[lowest + 1].x > line[lowest - 1].x);
    // It is open to the right: it begins there on the far side and ends on the near one.
    let (first, last) = (line[0] - at(200.0, 200.0), line[line.len() - 1] - at(200.0, 200.0));
    assert!(first.x > 50.0 && last.x > 50.0 && first.y < 0.0 && last.y > 0.0, "{first:?} to {last:?}");
}

#[test]
fn hidden_edges_are_drawn_as_asked() {
    let scene = |edges: Edges| {
        let mut stage = Stage::new(Camera::new(usual_view()).expect("a view"));
        stage
            .solid(Solid::disc(ORIGIN, [0.5, 0.0, 0.8], 1.0, 0.1).expect("a disc"), Hue::Blue)
            .expect("in sight");
        let shaft = Solid::rod([0.0, 0.0, -1.2], [0.0, 0.0, 1.2], 0.06).expect("a rod").edges(edges);
        stage.solid(shaft, Hue::Green).expect("in sight");
        drawn(&stage)
    };
    let count = |edges: Edges| lines(&scene(edges), Role::Line(Stroke::Hidden, Hue::Green)).len();
    // The two long edges behind the plate.
    assert_eq!((count(Edges::Seen), count(Edges::BehindOthers)), (0, 2));
    // Where the shaft comes out of the plate stands a line: half of it is seen.
    let drawing = scene(Edges::Seen);
    let eye = Eye::new(usual_view());
    // The near side of the shaft on the upper face, (½x + 0.8z)/√0.89 = 0.05.
    let near = times(unit([eye.back[0], eye.back[1], 0.0]), 0.06);
    let foot = [near[0], near[1], (0.05 * 0.89_f64.sqrt() - 0.5 * near[0]) / 0.8];
    let outlines = lines(&drawing, Role::Line(Stroke::Outline, Hue::Green));
    let closest = outlines.iter().map(|line| distance(line, eye.project(foot))).fold(f64::INFINITY, f64::min);
    assert!(closest < 0.1, "{closest} px");
}

#[test]
fn a_rod_is_not_painted_inside_what_it_pierces() {
    let mut stage = Stage::new(Camera::new(usual_view()).expect("a view"));
    let rod = Solid::rod([0.0, 0.0, -1.2], [0.0, 0.0, 1.2], 0.06).expect("a rod");
    stage.solid(rod, Hue::Green).expect("in sight");
    let glass = Solid::sphere(ORIGIN, 0.5).expect("a sphere").finish(Finish::Glass);
    stage.solid(glass, Hue::Blue).expect("in sight");
    // A plate inside the glass.
    stage.solid(Solid::disc(ORIGIN, UP, 0.3, 0.1).expect("a disc"), Hue::Orange).expect("in sight");
    let drawing = drawn(&stage);
    let covers = lines(&drawing, Role::Area(Fill::Page, Hue::Blue));
    assert!(covers.is_empty(), "glass covers nothing");
    let walls = lines(&drawing, Role::Area(Fill::Side, Hue::Green));
    assert_eq!(walls.len(), 2, "one above the sphere and one below");
    let centre = at(200.0, 200.0);
    for wall in walls {
        assert!(wall.iter().all(|&point| (point - centre).length() > 40.0), "{wall:?}");
    }
}

#[test]
fn labels_have_a_rim_only_off_the_solids() {
    let mut stage = Stage::new(Camera::new(usual_view()).expect("a view"));
    stage.solid(Solid::sphere(ORIGIN, 1.0).expect("a sphere"), Hue::Blue).expect("in sight");
    stage.label(ORIGIN, Side::Over, "$O$", Hue::Ink).expect("a label");
    stage.label([0.0, 0.0, 1.5], Side::Above, "$z$", Hue::Ink).expect("a label");
    let drawing = drawn(&stage);
    let roles: Vec<Role> = drawing.items().iter().rev().take(2).map(|item| item.role).collect();
    assert_eq!(roles, [Role::Text(Hue::Ink), Role::PlainText(Hue::Ink)]);
    let wrong = stage.label(ORIGIN, Side::Over, r"$\omga$", Hue::Ink).expect_err("no such command");
    assert_eq!(wrong.to_string(), r"label `$\omga$`: unknown command `\omga`");
}

#[test]
fn what_cannot_be_drawn_is_refused_with_its_reason() {
    let said = |error: Option<SpaceError>| error.map_or("accepted".into(), |error| error.to_string());
    let nan = f64::NAN;
    for (error, words) in [
        (Solid::disc(ORIGIN, ORIGIN, 1.0, 0.1).err(), "axis has no length, so it has no direction"),
        (Solid::disc([0.0, nan, 0.0], UP, 1.0, 0.1).err(), "centre is infinite or no number"),
        (Solid::disc(ORIGIN, UP, -1.0, 0.1).err(), "radius is -1, it must be positive"),
        (Solid::disc(ORIGIN, UP, 1.0, 0.0).err(), "thickness is 0, it must be positive"),
        (Solid::rod(UP, UP, 0.1).err(), "rod has no length, so it has no direction"),
        (Solid::ring(ORIGIN, UP, 1.0, 1.0, 0.1).err(), "the hole's radius 1 is not less than the ring's, 1"),
        (
            Solid::half_cone(ORIGIN, UP, 0.5, 1.0, UP).err(),
            "directions that are parallel or opposite fix no plane",
        ),
        (Solid::cone(ORIGIN, UP, 1.6, 1.0).err(), "the cone's half-angle 1.6 rad is not between 0 and π/2"),
        (Solid::cone(ORIGIN, UP, nan, 1.0).err(), "half-angle is infinite or no number"),
        (Solid::sphere(ORIGIN, f64::INFINITY).err(), "radius is infinite or no number"),
        (
            Solid::ellipsoid(ORIGIN, [UP, UP, UP], [1.0; 3]).err(),
            "axes are not perpendicular: the cosine of an angle between two is 1",
        ),
        (Curve::segment(UP, UP).err(), "a curve needs two points that differ"),
        (
            Curve::between(ORIGIN, UP, [0.0, 0.0, -2.0], 1.0).err(),
            "directions that are parallel or opposite fix no plane",
        ),
        (
            // Opposite up to rounding, which leaves a cross product of 1e-17.
            Curve::between(ORIGIN, [0.1, 0.2, 0.3], [-0.1 * 0.7, -0.2 * 0.7, -0.3 * 0.7], 1.0).err(),
            "directions that are parallel or opposite fix no plane",
        ),
        (Curve::circle(ORIGIN, UP, 0.0).err(), "radius is 0, it must be positive"),
        (
            Camera::new(View { elevation: 1.6, ..usual_view() }).err(),
            "the camera's elevation 1.6 rad is not between −π/2 and π/2",
        ),
        (Camera::new(View { scale: 0.0, ..usual_view() }).err(), "scale is 0, it must be positive"),
        (Camera::new(View { distance: nan, ..usual_view() }).err(), "distance is infinite or no number"),
    ] {
        assert_eq!(said(error), words);
    }
    let view = View { azimuth: 0.0, elevation: 0.0, ..usual_view() };
    let mut stage = Stage::new(Camera::new(view).expect("a view"));
    let around = Solid::sphere([6.5, 0.0, 0.0], 1.0).expect("a sphere");
    assert_eq!(said(stage.solid(around, Hue::Blue).err()), "the eye is inside the sphere");
    let cone = Solid::cone([8.0, 0.0, 0.0], [-1.0, 0.0, 0.0], 0.7, 5.0).expect("a cone");
    assert_eq!(said(stage.solid(cone, Hue::Blue).err()), "the eye is inside the cone");
    assert_eq!(
        said(stage.dot([7.5, 0.0, 0.0], 3.0, Hue::Ink).err()),
        "the point (7.5, 0, 0) lies behind the eye or too close to it"
    );
    assert!(matches!(stage.vector(ORIGIN, [9.0, 0.0, 0.0], Hue::Ink), Err(SpaceError::BehindTheEye { .. })));
    assert_eq!(
        said(stage.ground([0.0, 0.0], [1.0, 1.0], 0.0, 0.001).err()),
        "a grid of 2000 lines; at most 400 can be told apart"
    );
    assert!(matches!(stage.ground([0.0, 0.0], [0.0, 1.0], 0.0, 0.1), Err(SpaceError::NotPositive { .. })));
    assert!(drawn(&stage).items().is_empty(), "what is refused leaves nothing behind");
}

#[test]
fn a_patch_lies_over_every_solid_and_under_every_line() {
    let mut stage = Stage::new(Camera::new(usual_view()).expect("a view"));
    let corners = [[0.5, -0.5, 1.0], [0.5, 0.5, 1.0], [-0.5, 0.0, 1.0]];
    stage.patch(corners, Fill::Side, Hue::Green).expect("a patch");
    stage.vector([0.0, 0.0, 1.0], [0.0, 0.0, 2.0], Hue::Orange).expect("a vector");
    stage.solid(Solid::disc(ORIGIN, UP, 1.0, 2.0).expect("a disc"), Hue::Blue).expect("it is seen");
    let drawing = drawn(&stage);
    let place = |role: Role| drawing.items().iter().rposition(|item| item.role == role).expect("it is drawn");
    let patch = place(Role::Area(Fill::Side, Hue::Green));
    assert!(place(Role::Area(Fill::Face, Hue::Blue)) < patch);
    assert!(patch < place(Role::Line(Stroke::Vector, Hue::Orange)));
    let Shape::Polygon(drawn) = &drawing.items()[patch].shape else { panic!("a patch is a polygon") };
    assert_eq!(drawn.len(), 3);
    assert_eq!(stage.patch(corners[..2].to_vec(), Fill::Side, Hue::Green), Err(SpaceError::NoPatch));
    assert!(stage.patch([[f64::NAN; 3]; 3], Fill::Side, Hue::Green).is_err());
}
