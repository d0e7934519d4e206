//! The map of fates.

use drawing::{Drawing, Fill, Hue, Point, Rect, Role, Shape, Side, Stroke, at};
use figures::{Axis, Outcome, Plot, in_both, log_steps};
use mechanics::InvalidQuantity;
use mechanics::inertia::{Body, Spheroid, SymmetricMoments};
use mechanics::scenes::air_drag::Drag;
use std::f64::consts::FRAC_PI_4;

/// Bodies of revolution as signs on the map, seen from the side.
enum Sign {
    /// A spheroid whose axis stands upright, by its proportion b/a.
    Spheroid(f64),
    /// A stick, and a thinner one through it.
    Stick(bool),
    /// A disc seen edge on, and whether its rim is rough.
    Disc(bool),
}

/// Paints a sign, in a box of about 22 px.
fn sign(drawing: &mut Drawing, place: Point, form: &Sign) {
    let bar = |drawing: &mut Drawing, half: f64, across: f64, turn: f64| {
        let (along, aside) = (Point::polar(half, turn), Point::polar(across, turn).quarter_turned());
        let corners =
            vec![place + along + aside, place + along - aside, place - along - aside, place - along + aside];
        drawing.polygon(corners, Fill::Solid, Hue::Blue);
    };
    match *form {
        Sign::Spheroid(eta) => {
            let most = 9.5;
            let radii = if eta > 1.0 { (most / eta, most) } else { (most, most * eta) };
            let ellipse = || Shape::Ellipse { centre: place, radii, turn: 0.0 };
            drawing.push(Role::Area(Fill::Page, Hue::Blue), ellipse());
            drawing.push(Role::Area(Fill::Side, Hue::Blue), ellipse());
            drawing.push(Role::Line(Stroke::Outline, Hue::Blue), ellipse());
        }
        Sign::Stick(straw) => {
            if straw {
                bar(drawing, 16.0, 0.6, FRAC_PI_4);
            }
            bar(drawing, 9.0, 1.6, FRAC_PI_4);
        }
        Sign::Disc(rough) => {
            bar(drawing, 10.0, 1.7, 0.0);
            for rim in [-1.0, 1.0] {
                let end = place + at(10.0 * rim, 0.0);
                let reach = if rough { 5.0 } else { 2.5 };
                let down = if rough { reach } else { 4.5 };
                drawing.line(end - at(0.0, reach), end + at(0.0, down), Stroke::Vector, Hue::Blue);
            }
        }
    }
}

/// The map of fates: moments along it, drag up it, the border, and where real and even bodies lie.
pub(crate) fn fates(id: &str) -> Outcome {
    in_both(|room| {
        let side = room.of(420.0, 262.0);
        let mut drawing = Drawing::new(id, side + 110.0, side + 100.0).titled(
            "Which bodies settle",
            "Both scales are logarithmic: along x the ratio of the moments, I3 over I1, from a thousandth to 2, \
             where the map ends; along y the ratio of the drags, C1 over C3, from a tenth to a \
             thousand. The border is the falling straight line on which their product is one; above it bodies \
             settle, below it, where the map is tinted, they tumble. Dashed lines beside it: one clock ten times as fast as the other. A \
             curve of all even spheroids in slow air runs from flat ones at the lower right, above the border, \
             through the ball, which is on it, to needles, below it and nearly along it. A pencil lies below \
             the border, a pencil with a straw and a Frisbee above it, a disc with a rough rim below.",
        );
        let (flattest, least, most) = (2.0, 1e-3, 1e3);
        let moments = Axis::log(least, flattest, 1).titled(r"$I_3/I_1$");
        let drags = Axis::log(0.05, most, 1).titled(r"$C_1/C_3$");
        let mut plot = Plot::new(&mut drawing, Rect::new(56.0, 36.0, side, side), moments, drags)?;
        // Below the border.
        let tumble = [(least, 1.0 / least), (flattest, 1.0 / flattest), (flattest, 0.05), (least, 0.05)];
        let corners = tumble.map(|value| plot.at(value)).to_vec();
        plot.drawing().polygon(corners, Fill::Ground, Hue::Muted);
        plot.upright(flattest, Stroke::Reference);
        for (name, clocks, stroke) in [
            ("border", 1.0, Stroke::Border),
            ("ten", 10.0, Stroke::Reference),
            ("tenth", 0.1, Stroke::Reference),
        ] {
            let line = log_steps(least, flattest, 40).map(|ratio| (ratio, clocks / ratio));
            plot.curve(name, line, stroke, if clocks == 1.0 { Hue::Ink } else { Hue::Muted });
        }
        let spheroid = |eta: f64| {
            let shape = Spheroid { equatorial_radius: 1.0, polar_radius: eta };
            let SymmetricMoments { transverse, axial } =
                Body::spheroid(1.0, shape)?.moments().as_symmetric()?;
            let drag = Drag::of_spheroid(shape, 1.0)?;
            Ok::<_, InvalidQuantity>((axial / transverse, drag.transverse / drag.axial))
        };
        let all = log_steps(1e-3, 46.0, 400).map(spheroid).collect::<Result<Vec<_>, InvalidQuantity>>()?;
        plot.curve("spheroids", all, Stroke::Curve, Hue::Ink);
        let steps = |wide: Point, narrow: Point| room.of(wide, narrow);
        for (place, form, step, side, name) in [
            ((1.0 / 549.0, 813.0), Sign::Stick(true), at(14.0, 0.0), Side::Right, "straw"),
            ((2.0, 10.0), Sign::Disc(false), at(12.0, 0.0), Side::Right, "Frisbee"),
            ((2.0, 0.1), Sign::Disc(true), at(12.0, -2.0), Side::Right, "rough rim"),
            (
                spheroid(10.0)?,
                Sign::Spheroid(10.0),
                steps(at(-4.0, 6.0), at(0.0, 1.0)),
                Side::BelowLeft,
                "$10$",
            ),
            (spheroid(3.0)?, Sign::Spheroid(3.0), at(-4.0, 6.0), Side::BelowLeft, "$3$"),
            (spheroid(1.0)?, Sign::Spheroid(1.0), at(-6.0, 8.0), Side::BelowLeft, "$1$"),
            (spheroid(0.4)?, Sign::Spheroid(0.4), at(14.0, 3.0), Side::Right, "$0.4$"),
        ] {
            let place = plot.at(place);
            sign(plot.drawing(), place, &form);
            plot.drawing().label(place + step, side, name, Hue::Ink)?;
        }
        // The lines are close to the pencil: its name stands apart.
        let [pencil, name] = [plot.at((1.0 / 417.2, 81.4)), plot.at((1.0 / 417.2, 12.0))];
        plot.drawing().line(pencil, name, Stroke::Dotted, Hue::Muted);
        sign(plot.drawing(), pencil, &Sign::Stick(false));
        plot.drawing().label(name, Side::Below, "pencil", Hue::Ink)?;
        plot.label((0.4, 90.0), Side::Over, "settle", Hue::Ink)?;
        plot.label((0.006, 1.2), Side::Over, "tumble", Hue::Ink)?;
        plot.label((flattest, most), Side::Above, "$I_3 = 2I_1$", Hue::Muted)?;
        for (place, side, lines) in [
            (plot.at((0.035, 760.0)), Side::Right, ["wobble’s clock", "10 × as fast"]),
            (plot.at((0.2, 0.2)), Side::Left, ["spin’s clock", "10 × as fast"]),
        ] {
            for (line, words) in lines.into_iter().enumerate() {
                plot.drawing().label(place + at(0.0, 17.0 * line as f64), side, words, Hue::Muted)?;
            }
        }
        Ok(drawing)
    })
}
