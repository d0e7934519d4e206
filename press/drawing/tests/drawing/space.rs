//! Scenes in space against a judge that walks along lines of sight.

use crate::distance;
use crate::judge::{Body, Chance, Eye, Vector, cross, dot, some_body, some_view, step, sum, times, unit};
use drawing::kit::Heads;
use drawing::space::{Camera, Curve, Finish, Hiding, Solid, Stage, View};
use drawing::{Drawing, Fill, Flaw, Hue, Item, Point, Role, Shape, Side, Stroke, at};
use std::f64::consts::{FRAC_PI_2, TAU};

type Done = Result<(), Flaw>;

const UP: Vector = [0.0, 0.0, 1.0];
const ORIGIN: Vector = [0.0; 3];

/// The curve that tests look for.
const CURVE: Role = Role::Line(Stroke::Curve, Hue::Pink);
/// Where it is hidden.
const HIDDEN: Role = Role::Line(Stroke::Hidden, Hue::Pink);

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

/// An empty scene from the usual view.
fn staged() -> Stage {
    Stage::new(Eye::new(usual_view()).camera())
}

fn drawn(stage: &Stage) -> Drawing {
    let mut drawing = Drawing::new("fig:test", 400.0, 400.0).titled("A test", "A scene.");
    stage.write(&mut drawing);
    drawing
}

/// The lines and areas of a drawing with this role.
fn lines(drawing: &Drawing, role: Role) -> Vec<Vec<Point>> {
    let matching = |item: &&Item| item.role == role && !matches!(item.shape, Shape::Label(_));
    drawing.items().iter().filter(matching).map(|item| item.shape.points()).collect()
}

#[test]
fn points_land_where_the_definition_of_the_view_puts_them() -> Done {
    let landed = |view: View, point: Vector| Eye::new(view).camera().on_page(point);
    let mut chance = Chance(1);
    for _ in 0..300 {
        let eye = Eye::new(some_view(&mut chance));
        assert_eq!(landed(eye.view, eye.view.target)?, eye.view.centre, "the target lands on the centre");
        for _ in 0..10 {
            let point = chance.vector(2.0);
            let page = landed(eye.view, point)?;
            assert!((page - eye.project(point)).length() < 1e-10, "{point:?} lands at {page:?}");
        }
    }
    // From straight above, with x to the right: azimuth −90° and elevation 90°.
    let above = View { azimuth: -FRAC_PI_2, elevation: FRAC_PI_2, ..usual_view() };
    let page = landed(above, [1.0, 0.5, 0.0])?;
    assert!((page - at(300.0, 150.0)).length() < 1e-10, "{page:?}");
    // A distant eye sees what an eye at infinity sees, with an error like 1/distance.
    let seen = |distance: f64| landed(View { distance, ..usual_view() }, [0.7, -0.4, 0.9]);
    let far = |distance: f64| Ok((seen(distance)? - seen(f64::INFINITY)?).length() * distance);
    assert!((far(1e4)? / far(1e6)? - 1.0).abs() < 1e-3 && far(1e6)? > 1.0);
    Ok(())
}

/// Asks at many points of a segment whether the drawing and the judge agree on what is hidden. Points within
/// half a pixel of a boundary are left out, as the judge walks in steps. Returns how many points each way
/// were compared.
fn agree(eye: &Eye, bodies: &[Body], from: Vector, to: Vector) -> Result<(usize, usize), Flaw> {
    let mut stage = Stage::new(eye.camera());
    for body in bodies {
        stage.solid(body.solid()?, Hue::Blue)?;
    }
    stage.curve(Curve::segment(from, to)?, Stroke::Curve, Hue::Pink)?;
    let drawing = drawn(&stage);
    let [seen, hidden] = [CURVE, HIDDEN].map(|role| lines(&drawing, role));
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
    Ok(counts)
}

#[test]
fn a_segment_behind_a_disc_is_hidden_over_exactly_the_right_interval() -> Done {
    // Seen along the axis of a thin disc of radius 1 from 4 above it, the segment one below lies behind it as far as
    // x = ±√((5/4)² − y²) with y = 0.75: ±1, and a little less for the disc's lower face.
    let view = View { azimuth: -FRAC_PI_2, elevation: FRAC_PI_2, distance: 4.0, ..usual_view() };
    let mut stage = Stage::new(Camera::new(view)?);
    stage.solid(Solid::disc(ORIGIN, UP, 1.0, 1e-6)?, Hue::Blue)?;
    stage.curve(Curve::segment([-2.0, 0.75, -1.0], [2.0, 0.75, -1.0])?, Stroke::Curve, Hue::Pink)?;
    let drawing = drawn(&stage);
    let hidden = lines(&drawing, HIDDEN);
    let [line] = &hidden[..] else { panic!("one hidden piece: {hidden:?}") };
    // One unit at this depth is 100·4/5 px.
    for (end, x) in [(line[0], -80.0), (line[line.len() - 1], 80.0)] {
        assert!((end - at(200.0 + x, 200.0 - 60.0)).length() < 1e-3, "{end:?}");
    }
    assert_eq!(lines(&drawing, CURVE).len(), 2);
    Ok(())
}

#[test]
fn what_is_hidden_is_what_a_walk_to_the_eye_finds_hidden() -> Done {
    let mut chance = Chance(2);
    for kind in 0..6 {
        let mut counts = (0, 0);
        for _ in 0..16 {
            let eye = Eye::new(some_view(&mut chance));
            let body = some_body(kind, &mut chance);
            let found = agree(&eye, &[body], chance.vector(1.2), chance.vector(1.2))?;
            counts = (counts.0 + found.0, counts.1 + found.1);
        }
        assert!(counts.0 > 1000 && counts.1 > 60, "{kind}: {counts:?}");
    }
    // Several together hide what each hides.
    let mut hidden = 0;
    for index in 0..12 {
        let eye = Eye::new(some_view(&mut chance));
        let bodies = [0, 1, 2].map(|next| some_body(index + next, &mut chance));
        hidden += agree(&eye, &bodies, chance.vector(1.5), chance.vector(1.5))?.1;
    }
    assert!(hidden > 200, "{hidden}");
    // Behind a cone half-way up, where only its straight outlines bound what is hidden.
    let eye = Eye::new(View { azimuth: 0.0, elevation: 0.1, ..usual_view() });
    let cone = Body::Cone([0.0, 0.0, -1.0], UP, 0.5, 2.0, None);
    let found = agree(&eye, &[cone], [-1.0, -1.5, 0.0], [-1.0, 1.5, 0.0])?;
    assert!(found.0 > 30 && found.1 > 30, "{found:?}");
    Ok(())
}

#[test]
fn a_curve_that_goes_a_fourth_of_a_pixel_past_an_outline_is_cut_there() -> Done {
    let view = View { azimuth: -FRAC_PI_2, elevation: FRAC_PI_2, distance: f64::INFINITY, ..usual_view() };
    let (mut chance, past) = (Chance(6), 0.0025); // a unit has 100 px
    for index in 0..2000 {
        // A circle below a rod of radius one along x, that comes out from behind it, or goes in from outside.
        let comes_out = index % 2 == 0;
        let (radius, count) = (chance.number(0.3, 0.9), chance.number(24.0, 60.0).floor());
        let middle = if comes_out { 1.0 + past - radius } else { 1.0 - past + radius };
        // It begins far from there, so that its piece is not cut in two.
        let begun = chance.number(-1.0, 1.0) + if comes_out { -FRAC_PI_2 } else { FRAC_PI_2 };
        let point = |turn: i32| {
            let (sin, cos) = (begun + TAU * f64::from(turn) / count).sin_cos();
            [radius * cos, middle + radius * sin, -2.0]
        };
        let mut stage = Stage::new(Eye::new(view).camera());
        stage.solid(Solid::rod([-5.0, 0.0, 0.0], [5.0, 0.0, 0.0], 1.0)?, Hue::Blue)?;
        stage.curve(Curve::smooth((0..=count as i32).map(point))?, Stroke::Curve, Hue::Pink)?;
        let found = lines(&drawn(&stage), if comes_out { CURVE } else { HIDDEN });
        let of = format!("{count} points of a circle of {radius} from {begun}, {comes_out}");
        let [line] = &found[..] else { panic!("{of}: {} pieces", found.len()) };
        for end in [line[0], line[line.len() - 1]] {
            let far = view.centre.y - end.y;
            assert!((far - 100.0).abs() < 0.01, "{of}: it ends {far} px from the rod's axis");
        }
    }
    Ok(())
}

#[test]
fn the_outline_of_an_ellipsoid_is_where_lines_of_sight_touch_it() -> Done {
    let mut chance = Chance(4);
    for _ in 0..20 {
        let eye = Eye::new(some_view(&mut chance));
        let body = some_body(4, &mut chance);
        let Body::Ellipsoid(centre, axes, radii) = body else { panic!("an ellipsoid") };
        let mut stage = Stage::new(eye.camera());
        stage.solid(body.solid()?, Hue::Green)?;
        let drawing = drawn(&stage);
        let roles = [Role::Line(Stroke::Outline, Hue::Green), Role::Area(Fill::Round, Hue::Green)];
        let drawn = roles.map(|role| lines(&drawing, role).concat());
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
            for (line, role) in drawn.iter().zip(roles) {
                let off = distance(line, touched);
                assert!(off < 0.1, "{touched:?} is {off} px off {role:?}");
            }
        }
    }
    Ok(())
}

#[test]
fn edges_end_where_they_end_whatever_the_last_digit_is() -> Done {
    let ends = |axis: Vector, thickness: f64, shift: f64| -> Result<Vec<Point>, Flaw> {
        let mut stage = staged();
        stage.solid(Solid::disc([shift, -shift, shift], axis, 1.0, thickness)?, Hue::Blue)?;
        let edges = lines(&drawn(&stage), Role::Line(Stroke::Outline, Hue::Blue));
        Ok(edges.iter().flat_map(|line| [line[0], line[line.len() - 1]]).collect())
    };
    let mut chance = Chance(11);
    for _ in 0..400 {
        let (axis, thickness) = (chance.direction(), chance.number(0.05, 2.0));
        let first = ends(axis, thickness, 0.0)?;
        for last in 1..=6 {
            let other = ends(axis, thickness, 1e-14 * f64::from(last))?;
            let is_same = first.len() == other.len()
                && first.iter().zip(&other).all(|(&one, &other)| (one - other).length() < 0.01);
            assert!(is_same, "{axis:?}, {thickness} thick: {first:?} and {other:?}");
        }
    }
    Ok(())
}

#[test]
fn curves_on_a_surface_do_not_flicker() -> Done {
    let mut chance = Chance(5);
    let mut pieces = 0;
    for index in 0..60 {
        let eye = Eye::new(some_view(&mut chance));
        let (axes, radii) = (chance.axes(), [1.0, 0.8, 0.5]);
        let mut stage = Stage::new(eye.camera());
        let place = |[x, y, z]: Vector| sum(sum(times(axes[0], x), times(axes[1], y)), times(axes[2], z));
        stage.solid(Solid::ellipsoid(ORIGIN, axes, radii)?, Hue::Blue)?;
        // A circle of the unit sphere, stretched: points as they come out of arithmetic, some a little inside.
        let (normal, offset) = (chance.direction(), chance.number(-0.9, 0.9));
        let first = unit(cross(normal, [0.2, 0.9, -0.4]));
        let (second, radius) = (cross(normal, first), (1.0 - offset * offset).sqrt());
        let point = |turn: i32| {
            let (sin, cos) = (TAU * f64::from(turn % 150) / 150.0).sin_cos();
            let ball = sum(times(normal, offset), times(sum(times(first, cos), times(second, sin)), radius));
            times(
                place([ball[0] * radii[0], ball[1] * radii[1], ball[2] * radii[2]]),
                1.0 - 1e-6 * f64::from(turn % 2),
            )
        };
        stage.curve(Curve::smooth((0..=150).map(point))?, Stroke::Curve, Hue::Pink)?;
        let drawing = drawn(&stage);
        let [seen, hidden] = [CURVE, HIDDEN].map(|role| lines(&drawing, role).len());
        assert!(seen <= 1 && hidden <= 1, "{index}: {seen} seen and {hidden} hidden pieces");
        pieces += seen + hidden;
    }
    assert!(pieces > 75, "{pieces}: most curves pass behind the outline");
    // A spoke on the face of a disc, a circle on its rim, and the line in which two cones touch.
    let mut stage = staged();
    stage.solid(Solid::disc(ORIGIN, UP, 1.0, 0.1)?, Hue::Blue)?;
    for turn in 0..24 {
        let (sin, cos) = (TAU * f64::from(turn) / 24.0).sin_cos();
        let spoke = Curve::segment([0.0, 0.0, 0.05], [cos, sin, 0.05])?;
        stage.curve(spoke, Stroke::Curve, Hue::Pink)?;
    }
    stage.curve(Curve::circle([0.0, 0.0, 0.05], UP, 1.0)?, Stroke::Curve, Hue::Pink)?;
    let drawing = drawn(&stage);
    assert_eq!([CURVE, HIDDEN].map(|role| lines(&drawing, role).len()), [25, 0]);
    let mut stage = staged();
    let (space, body) = (0.4_f64, 0.6_f64);
    let axis = [(space + body).sin(), 0.0, (space + body).cos()];
    stage.solid(Solid::cone(ORIGIN, UP, space, 1.0)?, Hue::Green)?;
    stage.solid(Solid::cone(ORIGIN, axis, body, 1.0)?, Hue::Blue)?;
    let contact = Curve::segment(ORIGIN, [space.sin(), 0.0, space.cos()])?;
    stage.curve(contact, Stroke::Curve, Hue::Pink)?;
    assert_eq!(lines(&drawn(&stage), CURVE).len(), 1);
    Ok(())
}

/// The hue that the areas of a drawing leave on a point of the page.
fn painted(drawing: &Drawing, page: Point) -> Option<Hue> {
    let covers = |item: &&Item| {
        let Role::Area(Fill::Face | Fill::Side | Fill::Round, _) = item.role else { return false };
        let points = item.shape.points();
        // Two areas of one body meet along a curve, and each in chords of its own.
        if distance(&points, page) < 0.1 {
            return true;
        }
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
fn right_areas(eye: &Eye, bodies: &[Body]) -> Result<usize, Flaw> {
    let mut stage = Stage::new(eye.camera());
    for (body, &hue) in bodies.iter().zip(Hue::ALL) {
        stage.solid(body.solid()?, hue)?;
    }
    let drawing = drawn(&stage);
    let first = |page: Point| {
        let (near, far) = eye.sight(page);
        let met = |body: &Body| body.met(near, far, 1500);
        let nearest = bodies.iter().zip(Hue::ALL).filter_map(|(body, &hue)| Some((met(body)?, hue)));
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
                let found = painted(&drawing, page);
                assert_eq!(found, expected, "{bodies:?} at {page:?} from {:?}", eye.view);
                compared += usize::from(expected.is_some());
            }
        }
    }
    Ok(compared)
}

#[test]
fn what_is_painted_last_is_what_is_in_front() -> Done {
    let tube = |centre: Vector, axis: Vector, half: f64, radius: f64, hole: f64| {
        let axis = times(unit(axis), half);
        Body::Tube(step(axis, centre), sum(centre, axis), radius, hole)
    };
    let cone = |axis: Vector, half_angle: f64, length: f64, open: Option<Vector>| {
        Body::Cone(ORIGIN, axis, half_angle, length, open)
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
        ("cone beside a cone", vec![cone(UP, 0.4, 1.2, None), cone([0.9, 0.0, 0.5], 0.5, 1.2, None)]),
        (
            "cone in half a cone",
            vec![cone(UP, 0.3, 1.2, None), cone([-0.5, 0.0, 0.8], 0.95, 1.2, Some([0.1, -1.0, 0.0]))],
        ),
        (
            "pencil in a cone",
            vec![cone(UP, 0.6, 1.1, None), tube([0.0, 0.0, 0.9], [0.1, 0.0, 1.0], 0.6, 0.06, 0.0)],
        ),
    ];
    for (name, bodies) in scenes {
        for (azimuth, elevation, distance) in
            [(-1.1, 0.4, 7.0), (0.7, 0.5, 6.0), (2.4, 0.9, 9.0), (-2.6, 0.25, f64::INFINITY), (0.2, 1.2, 5.0)]
        {
            let eye = Eye::new(View { azimuth, elevation, distance, ..usual_view() });
            let compared = right_areas(&eye, &bodies)?;
            assert!(compared > 15, "{name}: only {compared} points were compared");
        }
    }
    Ok(())
}

/// A scene with everything, at random.
fn anything(seed: u64) -> Result<Drawing, Flaw> {
    let mut chance = Chance(seed);
    let eye = Eye::new(some_view(&mut chance));
    let mut stage = Stage::new(eye.camera());
    stage.ground([-1.5, -1.5], [1.5, 1.2], -1.0, 0.25)?;
    for kind in 0..6 {
        if chance.number(0.0, 1.0) < 0.6 {
            let finish = if seed.is_multiple_of(4) { Finish::Glass } else { Finish::Opaque };
            let solid = some_body(kind, &mut chance).solid()?.finish(finish);
            stage.solid(if seed.is_multiple_of(2) { solid } else { solid.dashed() }, Hue::Blue)?;
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
fn scenes_at_random_are_finite_and_the_same_twice() -> Done {
    for seed in 0..200 {
        let svg = anything(seed)?.to_svg()?;
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{seed}: {svg}");
        assert!(roxmltree::Document::parse(&svg).is_ok(), "{seed}");
        assert_eq!(svg, anything(seed)?.to_svg()?, "{seed}");
    }
    Ok(())
}

#[test]
fn what_is_hidden_is_pale_or_left_out() -> Done {
    let scene = |hiding: Hiding| -> Result<Drawing, Flaw> {
        let mut stage = staged();
        stage.solid(Solid::sphere(ORIGIN, 1.0)?, Hue::Blue)?;
        let eye = Eye::new(usual_view());
        let behind = sum(times(eye.back, -1.2), times(eye.right, 0.5));
        let shaft = Curve::segment(ORIGIN, behind)?.hiding(hiding);
        stage.arrow(shaft, Stroke::Vector, Heads::Both, Hue::Pink)?;
        stage.curve(Curve::circle(ORIGIN, UP, 0.9)?.hiding(hiding), Stroke::Curve, Hue::Pink)?;
        stage.dot(behind, 3.0, Hue::Pink)?;
        stage.dot([0.0, 0.0, 0.2], 5.0, Hue::Pink)?;
        stage.dot_in_front(behind, 3.0, Hue::Green)?;
        Ok(drawn(&stage))
    };
    let pink = |hiding: Hiding| -> Result<Vec<Role>, Flaw> {
        let drawing = scene(hiding)?;
        let roles = drawing.items().iter().map(|item| item.role);
        let is_pink = |role: &Role| matches!(role, Role::Line(_, Hue::Pink) | Role::Area(_, Hue::Pink));
        Ok(roles.filter(is_pink).collect())
    };
    assert_eq!(lines(&scene(Hiding::Dashed)?, Role::Area(Fill::Solid, Hue::Green)).len(), 1);
    let dashed = pink(Hiding::Dashed)?;
    assert!(dashed.len() >= 5 && dashed.iter().all(|&role| role == HIDDEN), "{dashed:?}");
    assert_eq!(pink(Hiding::Omitted)?, vec![HIDDEN; 2], "only the two points");
    let ignored = pink(Hiding::Ignored)?;
    assert_eq!(ignored.iter().filter(|&&role| role == HIDDEN).count(), 2, "{ignored:?}");
    assert!(ignored.contains(&Role::Line(Stroke::Vector, Hue::Pink)) && ignored.contains(&CURVE));
    Ok(())
}

#[test]
fn a_ghost_is_pale_and_hides_no_line() -> Done {
    for (finish, hides) in [(Finish::Opaque, true), (Finish::Ghost, false)] {
        let mut stage = staged();
        stage.solid(Solid::disc(ORIGIN, UP, 1.0, 0.4)?.finish(finish), Hue::Blue)?;
        stage.curve(Curve::segment([0.0, 2.0, 0.0], [0.0, -2.0, 0.0])?, Stroke::Curve, Hue::Pink)?;
        let drawing = drawn(&stage);
        let roles = [HIDDEN, Role::Line(Stroke::Pale, Hue::Blue), Role::Area(Fill::Ghost, Hue::Blue)];
        assert_eq!(roles.map(|role| !lines(&drawing, role).is_empty()), [hides, !hides, !hides]);
    }
    // A body in front of a ghost hides the ghost's edges.
    let mut stage = staged();
    stage.solid(Solid::sphere([0.0, 2.0, 0.0], 0.2)?.finish(Finish::Ghost), Hue::Green)?;
    stage.solid(Solid::sphere([0.5, 0.0, 0.3], 1.5)?, Hue::Blue)?;
    assert!(lines(&drawn(&stage), Role::Line(Stroke::Pale, Hue::Green)).is_empty());
    Ok(())
}

#[test]
fn arrowheads_keep_their_size_and_end_at_their_points() -> Done {
    let (eye, mut stage) = (Eye::new(usual_view()), staged());
    // One close to the eye, one far from it: their shafts differ, their heads do not.
    let tips = [[0.0, -2.5, 0.8], [0.0, 3.0, 0.8]];
    for tip in tips {
        stage.vector(step(UP, tip), tip, Hue::Pink)?;
    }
    let drawing = drawn(&stage);
    let heads = lines(&drawing, Role::Area(Fill::Solid, Hue::Pink));
    let shafts = lines(&drawing, Role::Line(Stroke::Vector, Hue::Pink));
    assert_eq!((heads.len(), shafts.len()), (2, 2));
    for ((head, shaft), tip) in heads.iter().zip(shafts).zip(tips) {
        assert!((head[0] - eye.project(tip)).length() < 1e-9);
        let width = (head[1] - head[3]).length();
        assert!((width - 7.2).abs() < 1e-9, "{width} px");
        // The shaft ends in the notch of the head, 10 − 2.2 px before the tip.
        let gap = (shaft[shaft.len() - 1] - eye.project(tip)).length();
        assert!((gap - 7.8).abs() < 1e-9, "{gap} px");
    }
    let mut stage = staged();
    stage.arrow(Curve::segment(ORIGIN, UP)?, Stroke::Vector, Heads::Both, Hue::Pink)?;
    let heads = lines(&drawn(&stage), Role::Area(Fill::Solid, Hue::Pink));
    let tips: Vec<Point> = heads.iter().map(|head| head[0]).collect();
    let close = |tip: Vector| tips.iter().any(|&head| (head - eye.project(tip)).length() < 1e-9);
    assert!(tips.len() == 2 && close(UP) && close(ORIGIN), "{tips:?}");
    Ok(())
}

#[test]
fn an_arrow_turns_right_handed_about_its_axis_and_is_open_to_the_right() -> Done {
    // About an axis that points up it goes counter-clockwise as seen from above: on the near side, to the right.
    for (axis, sense) in [(UP, 1.0), (times(UP, -1.0), -1.0)] {
        let mut stage = staged();
        stage.turning(ORIGIN, axis, 1.0, Hue::Orange)?;
        let drawing = drawn(&stage);
        assert_eq!(lines(&drawing, Role::Area(Fill::Solid, Hue::Orange)).len(), 1);
        let arc = lines(&drawing, Role::Line(Stroke::Outline, Hue::Orange)).concat();
        let lowest = (1..arc.len() - 1).max_by(|&a, &b| arc[a].y.total_cmp(&arc[b].y)).expect("points");
        assert!((arc[lowest + 1].x - arc[lowest - 1].x) * sense > 0.0);
        // Of a turn upwards the beginning is on the far side and the end on the near one.
        let [first, last] = [arc[0], arc[arc.len() - 1]].map(|end| end - at(200.0, 200.0));
        let is_open = first.x > 50.0 && last.x > 50.0 && first.y * sense < 0.0 && last.y * sense > 0.0;
        assert!(is_open, "{first:?} to {last:?}");
    }
    Ok(())
}

#[test]
fn hidden_edges_are_drawn_as_asked() -> Done {
    let scene = |is_dashed: bool| -> Result<Drawing, Flaw> {
        let mut stage = staged();
        stage.solid(Solid::disc(ORIGIN, [0.5, 0.0, 0.8], 1.0, 0.1)?, Hue::Blue)?;
        let shaft = Solid::rod([0.0, 0.0, -1.2], [0.0, 0.0, 1.2], 0.06)?;
        stage.solid(if is_dashed { shaft.dashed() } else { shaft }, Hue::Green)?;
        Ok(drawn(&stage))
    };
    let [plain, dashed] = [scene(false)?, scene(true)?];
    let count = |drawing: &Drawing| lines(drawing, Role::Line(Stroke::Hidden, Hue::Green)).len();
    // The two long edges behind the plate.
    assert_eq!((count(&plain), count(&dashed)), (0, 2));
    // Where the shaft comes out of the plate stands a line: half of it is seen. The near side of the shaft on the
    // upper face, (½x + 0.8z)/√0.89 = 0.05.
    let eye = Eye::new(usual_view());
    let near = times(unit([eye.back[0], eye.back[1], 0.0]), 0.06);
    let foot = [near[0], near[1], (0.05 * 0.89_f64.sqrt() - 0.5 * near[0]) / 0.8];
    let outlines = lines(&plain, Role::Line(Stroke::Outline, Hue::Green));
    let closest = outlines.iter().map(|line| distance(line, eye.project(foot))).fold(f64::INFINITY, f64::min);
    assert!(closest < 0.1, "{closest} px");
    Ok(())
}

#[test]
fn a_rod_is_not_painted_inside_what_it_pierces() -> Done {
    let mut stage = staged();
    stage.solid(Solid::rod([0.0, 0.0, -1.2], [0.0, 0.0, 1.2], 0.06)?, Hue::Green)?;
    stage.solid(Solid::sphere(ORIGIN, 0.5)?.finish(Finish::Glass), Hue::Blue)?;
    // A plate inside the glass.
    stage.solid(Solid::disc(ORIGIN, UP, 0.3, 0.1)?, Hue::Orange)?;
    let drawing = drawn(&stage);
    assert!(lines(&drawing, Role::Area(Fill::Page, Hue::Blue)).is_empty(), "glass covers nothing");
    let walls = lines(&drawing, Role::Area(Fill::Side, Hue::Green));
    assert_eq!(walls.len(), 2, "one above the sphere and one below");
    for wall in walls {
        assert!(wall.iter().all(|&point| (point - at(200.0, 200.0)).length() > 40.0), "{wall:?}");
    }
    Ok(())
}

#[test]
fn labels_have_a_rim_only_off_the_solids() -> Done {
    let mut stage = staged();
    stage.solid(Solid::sphere(ORIGIN, 1.0)?, Hue::Blue)?;
    stage.label(ORIGIN, Side::Over, "$O$", Hue::Ink)?;
    stage.label([0.0, 0.0, 1.5], Side::Above, "$z$", Hue::Ink)?;
    let drawing = drawn(&stage);
    let roles: Vec<Role> = drawing.items().iter().rev().take(2).map(|item| item.role).collect();
    assert_eq!(roles, [Role::Text(Hue::Ink), Role::PlainText(Hue::Ink)]);
    Ok(())
}

#[test]
fn a_patch_lies_over_every_solid_and_under_every_line() -> Done {
    let mut stage = staged();
    stage.patch([[0.5, -0.5, 1.0], [0.5, 0.5, 1.0], [-0.5, 0.0, 1.0]], Fill::Side, Hue::Green)?;
    stage.vector(UP, [0.0, 0.0, 2.0], Hue::Orange)?;
    stage.solid(Solid::disc(ORIGIN, UP, 1.0, 2.0)?, Hue::Blue)?;
    let drawing = drawn(&stage);
    let place = |role: Role| drawing.items().iter().rposition(|item| item.role == role).expect("it is drawn");
    let patch = place(Role::Area(Fill::Side, Hue::Green));
    assert!(place(Role::Area(Fill::Face, Hue::Blue)) < patch);
    assert!(patch < place(Role::Line(Stroke::Vector, Hue::Orange)));
    let Shape::Polygon(drawn) = &drawing.items()[patch].shape else { panic!("a patch is a polygon") };
    assert_eq!(drawn.len(), 3);
    Ok(())
}

#[test]
fn what_cannot_be_drawn_is_refused_with_its_reason() -> Done {
    let nan = f64::NAN;
    let no_plane = "directions that are parallel or opposite fix no plane";
    let view = View { azimuth: 0.0, elevation: 0.0, ..usual_view() };
    let mut stage = Stage::new(Camera::new(view)?);
    let around = Solid::sphere([6.5, 0.0, 0.0], 1.0)?;
    let cone = Solid::cone([8.0, 0.0, 0.0], [-1.0, 0.0, 0.0], 0.7, 5.0)?;
    for (flaw, words) in [
        (Solid::disc(ORIGIN, ORIGIN, 1.0, 0.1).err(), "axis has no length, so it has no direction"),
        (Solid::disc([0.0, nan, 0.0], UP, 1.0, 0.1).err(), "centre is infinite or no number"),
        (Solid::disc(ORIGIN, UP, -1.0, 0.1).err(), "radius is -1, it must be positive"),
        (Solid::disc(ORIGIN, UP, 1.0, 0.0).err(), "thickness is 0, it must be positive"),
        (Solid::rod(UP, UP, 0.1).err(), "rod has no length, so it has no direction"),
        (Solid::ring(ORIGIN, UP, 1.0, 1.0, 0.1).err(), "the hole's radius 1 is not less than the ring's, 1"),
        (Solid::half_cone(ORIGIN, UP, 0.5, 1.0, UP).err(), no_plane),
        (Solid::cone(ORIGIN, UP, 1.6, 1.0).err(), "the cone's half-angle 1.6 rad is not between 0 and π/2"),
        (Solid::cone(ORIGIN, UP, nan, 1.0).err(), "half-angle is infinite or no number"),
        (Solid::sphere(ORIGIN, f64::INFINITY).err(), "radius is infinite or no number"),
        (
            Solid::ellipsoid(ORIGIN, [UP, UP, UP], [1.0; 3]).err(),
            "axes are not perpendicular: the cosine of an angle between two is 1",
        ),
        (Curve::segment(UP, UP).err(), "a curve needs two points that differ"),
        (Curve::between(ORIGIN, UP, [0.0, 0.0, -2.0], 1.0).err(), no_plane),
        // Opposite up to rounding, which leaves a cross product of 1e-17.
        (Curve::between(ORIGIN, [0.1, 0.2, 0.3], times([0.1, 0.2, 0.3], -0.7), 1.0).err(), no_plane),
        (Curve::circle(ORIGIN, UP, 0.0).err(), "radius is 0, it must be positive"),
        (
            Camera::new(View { elevation: 1.6, ..view }).err(),
            "the camera's elevation 1.6 rad is not between −π/2 and π/2",
        ),
        (Camera::new(View { scale: 0.0, ..view }).err(), "scale is 0, it must be positive"),
        (Camera::new(View { distance: nan, ..view }).err(), "distance is infinite or no number"),
        (stage.solid(around, Hue::Blue).err(), "the eye is inside the sphere"),
        (stage.solid(cone, Hue::Blue).err(), "the eye is inside the cone"),
        (
            stage.dot([7.5, 0.0, 0.0], 3.0, Hue::Ink).err(),
            "the point (7.5, 0, 0) lies behind the eye or too close to it",
        ),
        (
            stage.vector(ORIGIN, [9.0, 0.0, 0.0], Hue::Ink).err(),
            "the point (9, 0, 0) lies behind the eye or too close to it",
        ),
        (
            stage.ground([0.0, 0.0], [1.0, 1.0], 0.0, 0.001).err(),
            "a grid of 2000 lines; at most 400 can be told apart",
        ),
        (
            stage.ground([0.0, 0.0], [0.0, 1.0], 0.0, 0.1).err(),
            "side of the ground is 0, it must be positive",
        ),
        (stage.patch([UP, ORIGIN], Fill::Side, Hue::Green).err(), "a patch needs at least three corners"),
        (stage.patch([[nan; 3]; 3], Fill::Side, Hue::Green).err(), "point is infinite or no number"),
        (
            stage.label(ORIGIN, Side::Over, r"$\omga$", Hue::Ink).err(),
            r"label `$\omga$`: unknown command `\omga`",
        ),
    ] {
        assert_eq!(flaw.map(|flaw| flaw.to_string()).as_deref(), Some(words));
    }
    assert!(drawn(&stage).items().is_empty(), "what is refused leaves nothing behind");
    Ok(())
}
