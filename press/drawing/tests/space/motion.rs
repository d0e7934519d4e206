//! What shows motion: ghosts, and arrows that turn.

use super::{ORIGIN, UP, drawn, lines, usual_view};
use drawing::space::{Camera, Curve, Finish, Solid, SpaceError, Stage};
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
fn an_arrow_turns_right_handed_about_its_axis() -> Result<(), SpaceError> {
    // Seen from above the head goes round counter-clockwise: on the near side, to the right.
    for (axis, sense) in [(UP, 1.0), ([0.0, 0.0, -1.0], -1.0)] {
        let mut stage = stage();
        stage.turning(ORIGIN, axis, 0.2, Hue::Orange)?;
        let drawing = drawn(&stage);
        assert_eq!(lines(&drawing, Role::Area(Fill::Solid, Hue::Orange)).len(), 1);
        let arc = lines(&drawing, Role::Line(Stroke::Outline, Hue::Orange)).concat();
        let lowest = (1..arc.len() - 1).max_by(|&a, &b| arc[a].y.total_cmp(&arc[b].y)).expect("points");
        assert!((arc[lowest + 1].x - arc[lowest - 1].x) * sense > 0.0);
    }
    Ok(())
}
