//! What shows motion: ghosts, ways, spins.

use super::{ORIGIN, UP, drawn, landed, lines, usual_view};
use drawing::space::{Camera, Curve, Finish, Hiding, Solid, SpaceError, Stage};
use drawing::{Fill, Hue, Role, Stroke};

fn stage() -> Stage {
    Stage::new(Camera::new(usual_view()).expect("a view"))
}

#[test]
fn a_ghost_is_pale_and_hides_no_line() -> Result<(), SpaceError> {
    let through = || Curve::segment([0.0, 2.0, 0.0], [0.0, -2.0, 0.0]);
    let hidden = Role::Line(Stroke::Hidden, Hue::Pink);
    for (finish, hides) in [(Finish::Opaque, true), (Finish::Ghost, false)] {
        let mut stage = stage();
        stage.solid(Solid::disc(ORIGIN, UP, 1.0, 0.4)?.finish(finish), Hue::Blue)?;
        stage.curve(through()?, Stroke::Curve, Hue::Pink)?;
        let drawing = drawn(&stage);
        assert_eq!(!lines(&drawing, hidden).is_empty(), hides);
        let pale = !lines(&drawing, Role::Line(Stroke::Pale, Hue::Blue)).is_empty();
        let tint = drawing.items().iter().any(|item| item.role == Role::Area(Fill::Ghost, Hue::Blue));
        assert_eq!((pale, tint), (!hides, !hides));
    }
    // A body in front of a ghost hides the ghost's edges.
    let mut stage = stage();
    stage.solid(Solid::sphere([0.0, 2.0, 0.0], 0.2)?.finish(Finish::Ghost), Hue::Green)?;
    stage.solid(Solid::sphere([0.5, 0.0, 0.3], 1.5)?, Hue::Blue)?;
    assert!(lines(&drawn(&stage), Role::Line(Stroke::Pale, Hue::Green)).is_empty());
    Ok(())
}

#[test]
fn heads_along_a_curve_point_the_way_it_goes_where_it_is_seen() -> Result<(), SpaceError> {
    let mut stage = stage();
    stage.solid(Solid::sphere(ORIGIN, 1.0)?, Hue::Blue)?;
    let path = Curve::segment([-1.0, -1.5, 1.2], [1.0, -1.5, 1.2])?;
    stage.way(path.hiding(Hiding::Pale), Stroke::Curve, &[0.5], Hue::Pink)?;
    let behind = Curve::segment([-1.0, 1.5, -1.0], [1.0, 1.5, -1.0])?;
    stage.way(behind.hiding(Hiding::Pale), Stroke::Curve, &[0.5], Hue::Green)?;
    let drawing = drawn(&stage);
    assert!(!lines(&drawing, Role::Line(Stroke::Pale, Hue::Green)).is_empty());
    let heads = |hue| lines(&drawing, Role::Area(Fill::Solid, hue));
    assert!(heads(Hue::Green).is_empty());
    let [head] = &heads(Hue::Pink)[..] else { panic!("one head") };
    let [from, to] =
        [[-1.0, -1.5, 1.2], [1.0, -1.5, 1.2]].map(|end| landed(usual_view(), end).expect("in front"));
    assert!((head[0] - from.towards(to, 0.5)).length() < 1e-9, "its tip is half-way along on the page");
    let (along, back) = ((to - from).unit(), head[2] - head[0]);
    assert!(back.x * along.x + back.y * along.y < -7.0, "its notch lies behind its tip");
    Ok(())
}

#[test]
fn a_spin_turns_right_handed_about_its_vector() -> Result<(), SpaceError> {
    // Seen from above the head goes round counter-clockwise: on the near side, to the right.
    for (tip, sense) in [(UP, 1.0), ([0.0, 0.0, -1.0], -1.0)] {
        let mut stage = stage();
        stage.spin(ORIGIN, tip, r"$\boldsymbol\omega$", Hue::Orange)?;
        let drawing = drawn(&stage);
        let heads = lines(&drawing, Role::Area(Fill::Solid, Hue::Orange));
        assert_eq!(heads.len(), 2);
        let arc = lines(&drawing, Role::Line(Stroke::Outline, Hue::Orange)).concat();
        let lowest = (1..arc.len() - 1).max_by(|&a, &b| arc[a].y.total_cmp(&arc[b].y)).expect("points");
        assert!((arc[lowest + 1].x - arc[lowest - 1].x) * sense > 0.0);
        let width = arc.iter().map(|point| point.x).fold(f64::NEG_INFINITY, f64::max)
            - arc.iter().map(|point| point.x).fold(f64::INFINITY, f64::min);
        assert!((18.0..24.0).contains(&width), "{width} px at any distance of the eye");
    }
    Ok(())
}
