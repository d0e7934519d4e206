//! Draws solids of every kind, to be looked at: `cargo run -p drawing --example space_sheet -- DIR`.
//!
//! Each becomes an SVG file of its own in `DIR`, and `DIR/sheet.html` shows all of them, light and dark.

use drawing::kit::Heads;
use drawing::space::{Camera, Curve, Edges, Finish, Hiding, Solid, SpaceError, Stage, View};
use drawing::{Drawing, Hue, Point, Side, Stroke, at};
use std::error::Error;
use std::f64::consts::TAU;
use std::fs;
use std::path::PathBuf;

const STYLE: &str = include_str!("../../../book/theme/figures.css");
const UP: [f64; 3] = [0.0, 0.0, 1.0];
const ORIGIN: [f64; 3] = [0.0; 3];

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args().nth(1).ok_or("which folder shall the drawings go to?")?);
    fs::create_dir_all(&folder)?;
    let drawings = [
        plate()?,
        coin()?,
        ring()?,
        cones()?,
        nested()?,
        ellipsoid()?,
        rolling()?,
        pencil()?,
        links()?,
        engine()?,
        frisbee()?,
        sphere()?,
    ];
    let mut cells = String::new();
    for drawing in drawings {
        let name = drawing.id().replace(':', "-");
        fs::write(folder.join(format!("{name}.svg")), drawing.to_standalone_svg()?)?;
        println!("{name} {} bytes", drawing.to_svg()?.len());
        cells += &format!("<figure>{}</figure>\n", drawing.to_svg()?);
    }
    let page = format!(
        "<!doctype html><meta charset=\"utf-8\"><title>Solids</title>\n<style>\n\
         section {{ display: grid; grid-template-columns: repeat(3, 400px); background: var(--bg); color: var(--fg); padding: 8px; }}\n\
         figure {{ margin: 8px; }}\n\
         .light {{ color-scheme: light; --bg: #fff; --fg: #000; }}\n\
         .dark {{ color-scheme: dark; --bg: hsl(226, 23%, 11%); --fg: #bcbdd0; }}\n{STYLE}</style>\n\
         <section class=\"light\">{cells}</section>\n<section class=\"dark\">{}</section>\n",
        cells.replace("fig-", "dark-")
    );
    fs::write(folder.join("sheet.html"), page)?;
    Ok(())
}

fn view(azimuth_deg: f64, elevation_deg: f64, centre: Point, scale: f64) -> View {
    let (azimuth, elevation) = (azimuth_deg.to_radians(), elevation_deg.to_radians());
    View { target: ORIGIN, azimuth, elevation, distance: 7.0, centre, scale }
}

fn scaled(vector: [f64; 3], factor: f64) -> [f64; 3] {
    vector.map(|component| component * factor)
}

/// A tilted plate on its shaft, with its angular momentum between the shaft and the normal.
fn plate() -> Result<Drawing, SpaceError> {
    let mut stage = Stage::new(Camera::new(view(-68.0, 24.0, at(190.0, 226.0), 100.0))?);
    let (alpha, beta) = (35.0_f64.to_radians(), 14.0_f64.to_radians());
    let normal = [alpha.sin(), 0.0, alpha.cos()];
    let momentum = [beta.sin(), 0.0, beta.cos()];
    let first = [-alpha.cos(), 0.0, alpha.sin()];
    stage.solid(Solid::disc(ORIGIN, normal, 1.0, 0.1)?, Hue::Blue)?;
    stage.solid(
        Solid::rod([0.0, 0.0, -1.3], [0.0, 0.0, 1.15], 0.045)?.edges(Edges::BehindOthers),
        Hue::Muted,
    )?;
    stage.named_vector([0.0, 0.0, 1.15], [0.0, 0.0, 1.75], r"$\boldsymbol\omega$", Hue::Orange)?;
    stage.turning([0.0, 0.0, 1.35], UP, 0.2, Hue::Orange)?;
    for (direction, length, name, hue) in [
        (normal, 1.5, r"$\hat{\imath}_3$", Hue::Ink),
        (first, 1.45, r"$\hat{\imath}_1$", Hue::Ink),
        (momentum, 1.45, r"$\boldsymbol L$", Hue::Green),
    ] {
        let shaft = Curve::segment(ORIGIN, scaled(direction, length))?.hiding(Hiding::Ignored);
        stage.named_arrow(shaft, Stroke::Vector, name, hue)?;
    }
    stage.angle(ORIGIN, UP, normal, 1.05, r"$\alpha$", Hue::Ink)?;
    stage.angle(ORIGIN, UP, momentum, 0.75, r"$\beta$", Hue::Green)?;
    stage.triad(
        [-1.25, -0.6, -0.75],
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], UP],
        0.4,
        ["$x$", "$y$", "$z$"],
        Hue::Muted,
    )?;
    draw(&stage, "fig:plate", "The wobble plate")
}

/// A coin in flight.
fn coin() -> Result<Drawing, SpaceError> {
    let mut stage = Stage::new(Camera::new(view(-24.0, 20.0, at(185.0, 225.0), 105.0))?);
    let (sin, cos) = 48.0_f64.to_radians().sin_cos();
    let third = [sin, 0.0, cos];
    stage.solid(Solid::disc(ORIGIN, third, 1.0, 0.16)?, Hue::Blue)?;
    let face = scaled(third, 0.08);
    let from_face =
        |direction: [f64; 3], length: f64| [0, 1, 2].map(|index| face[index] + direction[index] * length);
    for (direction, name) in [
        ([cos, 0.0, -sin], r"$\hat{\boldsymbol 1}$"),
        ([0.0, 1.0, 0.0], r"$\hat{\boldsymbol 2}$"),
        (third, r"$\hat{\boldsymbol 3}$"),
    ] {
        stage.named_vector(face, from_face(direction, 1.5), name, Hue::Ink)?;
    }
    stage.named_vector(face, from_face(UP, 1.5), r"$\boldsymbol L$", Hue::Green)?;
    stage.turning(from_face(third, 1.15), third, 0.2, Hue::Orange)?;
    stage.angle(face, UP, third, 0.8, r"$\theta$", Hue::Ink)?;
    draw(&stage, "fig:coin", "The tossed coin")
}

/// A ring that is struck.
fn ring() -> Result<Drawing, SpaceError> {
    let mut stage = Stage::new(Camera::new(view(-50.0, 28.0, at(190.0, 210.0), 120.0))?);
    let tilt = 20.0_f64.to_radians();
    let normal = [tilt.sin(), 0.0, tilt.cos()];
    stage.solid(Solid::ring(ORIGIN, normal, 1.0, 0.78, 0.3)?, Hue::Blue)?;
    stage.named_vector(ORIGIN, scaled(normal, 1.3), r"$\boldsymbol\omega$", Hue::Orange)?;
    stage.dot(ORIGIN, 3.0, Hue::Ink)?;
    let rim = [tilt.cos(), 0.0, -tilt.sin()];
    stage.curve(Curve::segment(ORIGIN, rim)?, Stroke::Outline, Hue::Ink)?;
    stage.named_arrow(
        Curve::segment([rim[0], 0.0, rim[2] + 0.8], [rim[0], 0.0, rim[2] + 0.22])?,
        Stroke::Vector,
        r"$\boldsymbol P$",
        Hue::Pink,
    )?;
    draw(&stage, "fig:ring", "The struck ring")
}

/// A body cone that rolls outside on a space cone.
fn cones() -> Result<Drawing, SpaceError> {
    let mut stage = Stage::new(Camera::new(View {
        target: [0.25, 0.0, 0.8],
        ..view(-75.0, 22.0, at(190.0, 200.0), 125.0)
    })?);
    let (space, body) = (22.0_f64.to_radians(), 32.0_f64.to_radians());
    let lean = space + body;
    let axis = [lean.sin(), 0.0, lean.cos()];
    stage.solid(Solid::cone(ORIGIN, UP, space, 1.5)?.edges(Edges::All).finish(Finish::Glass), Hue::Green)?;
    stage.solid(Solid::cone(ORIGIN, axis, body, 1.5)?.edges(Edges::All).finish(Finish::Glass), Hue::Blue)?;
    stage.named_vector(ORIGIN, [0.0, 0.0, 1.9], r"$\boldsymbol L$", Hue::Green)?;
    stage.named_vector(ORIGIN, scaled(axis, 1.8), r"$\hat{\boldsymbol 3}$", Hue::Ink)?;
    stage.named_vector(
        ORIGIN,
        scaled([space.sin(), 0.0, space.cos()], 1.75),
        r"$\boldsymbol\omega$",
        Hue::Orange,
    )?;
    draw(&stage, "fig:cones", "Body cone and space cone")
}

/// A flat body: its cone encloses the cone in space and rolls on it from outside.
fn nested() -> Result<Drawing, SpaceError> {
    let view = View { target: [0.2, 0.0, 0.7], ..view(-75.0, 22.0, at(190.0, 200.0), 115.0) };
    let mut stage = Stage::new(Camera::new(view)?);
    let (space, body) = (16.0_f64.to_radians(), 42.0_f64.to_radians());
    let lean = body - space;
    let axis = [-lean.sin(), 0.0, lean.cos()];
    stage.solid(Solid::cone(ORIGIN, UP, space, 1.5)?.edges(Edges::BehindOthers), Hue::Green)?;
    stage.solid(Solid::cone(ORIGIN, axis, body, 1.5)?.finish(Finish::Glass), Hue::Blue)?;
    stage.named_vector(ORIGIN, [0.0, 0.0, 1.9], r"$\boldsymbol L$", Hue::Green)?;
    stage.named_vector(ORIGIN, scaled(axis, 1.8), r"$\hat{\boldsymbol 3}$", Hue::Ink)?;
    stage.named_vector(
        ORIGIN,
        scaled([space.sin(), 0.0, space.cos()], 1.8),
        r"$\boldsymbol\omega$",
        Hue::Orange,
    )?;
    draw(&stage, "fig:nested", "A body cone about a space cone")
}

/// A Frisbee: a disc with a rim.
fn frisbee() -> Result<Drawing, SpaceError> {
    let mut stage = Stage::new(Camera::new(view(-60.0, 24.0, at(190.0, 215.0), 115.0))?);
    let (sin, cos) = 18.0_f64.to_radians().sin_cos();
    let axis = [sin, 0.0, cos];
    stage.solid(Solid::disc(scaled(axis, -0.12), axis, 0.9, 0.02)?, Hue::Blue)?;
    stage.solid(Solid::ring(ORIGIN, axis, 1.0, 0.9, 0.26)?, Hue::Blue)?;
    stage.named_vector(scaled(axis, -0.11), scaled(axis, 1.0), r"$\hat{\boldsymbol 3}$", Hue::Ink)?;
    stage.turning(scaled(axis, 0.7), axis, 0.2, Hue::Orange)?;
    draw(&stage, "fig:frisbee", "A Frisbee")
}

/// A sphere with meridians and parallels, and an opaque cone.
fn sphere() -> Result<Drawing, SpaceError> {
    let mut stage = Stage::new(Camera::new(view(-60.0, 24.0, at(190.0, 200.0), 115.0))?);
    stage.solid(Solid::sphere(ORIGIN, 1.0)?, Hue::Orange)?;
    for index in 0..6 {
        let (sin, cos) = (TAU * f64::from(index) / 12.0).sin_cos();
        stage.curve(Curve::circle(ORIGIN, [sin, cos, 0.0], 1.0)?, Stroke::Outline, Hue::Orange)?;
        let (height, radius) = (TAU * f64::from(index - 3) / 12.0).sin_cos();
        if index > 0 {
            stage.curve(Curve::circle([0.0, 0.0, height], UP, radius)?, Stroke::Outline, Hue::Orange)?;
        }
    }
    stage.solid(Solid::cone([1.2, -0.9, -0.9], [0.1, 0.0, 1.0], 0.35, 0.9)?, Hue::Purple)?;
    draw(&stage, "fig:sphere", "A sphere with its grid")
}

/// Curves on an ellipsoid: where spheres cut it.
fn ellipsoid() -> Result<Drawing, SpaceError> {
    let mut stage = Stage::new(Camera::new(view(-35.0, 25.0, at(190.0, 190.0), 100.0))?);
    let semi = [1.5, 1.15, 0.8];
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], UP];
    stage.solid(Solid::ellipsoid(ORIGIN, axes, semi)?, Hue::Blue)?;
    for (axis, radii, hue) in [(0, [1.45, 1.36, 1.25], Hue::Blue), (2, [0.83, 0.9, 1.0], Hue::Green)] {
        for radius in radii {
            for side in [-1.0, 1.0] {
                stage.curve(Curve::smooth(cut(semi, axis, radius, side))?, Stroke::Curve, hue)?;
            }
        }
    }
    for axis in 0..3 {
        let mut tip = [0.0; 3];
        tip[axis] = semi[axis] + 0.55;
        let mut foot = [0.0; 3];
        foot[axis] = semi[axis];
        stage.named_vector(
            foot,
            tip,
            ["$\\hat{\\boldsymbol 1}$", "$\\hat{\\boldsymbol 2}$", "$\\hat{\\boldsymbol 3}$"][axis],
            Hue::Ink,
        )?;
    }
    draw(&stage, "fig:ellipsoid", "Curves on an ellipsoid")
}

/// The line in which a sphere cuts an ellipsoid, about one of its axes.
fn cut(semi: [f64; 3], axis: usize, radius: f64, side: f64) -> Vec<[f64; 3]> {
    let (second, third) = ((axis + 1) % 3, (axis + 2) % 3);
    let [a, b, c] = [axis, second, third].map(|index| semi[index].powi(2));
    let square = radius * radius;
    (0..=240)
        .map(|index| {
            // With x² + y² + z² = r² and x²/a + y²/b + z²/c = 1 two combinations of y² and z² remain.
            let (sin, cos) = (TAU * f64::from(index % 240) / 240.0).sin_cos();
            let excess = square / a - 1.0;
            let y = cos * (excess / (1.0 / a - 1.0 / b)).sqrt();
            let z = sin * (excess / (1.0 / a - 1.0 / c)).sqrt();
            let mut point = [0.0; 3];
            point[axis] = side * (square - y * y - z * z).sqrt();
            (point[second], point[third]) = (y, z);
            point
        })
        .collect()
}

/// A wheel that rolls on a circle.
fn rolling() -> Result<Drawing, SpaceError> {
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, 0.4],
        distance: 9.0,
        ..view(-60.0, 22.0, at(205.0, 215.0), 62.0)
    })?);
    let lean = 20.0_f64.to_radians();
    let (track, radius) = (1.4, 0.75);
    let contact = [track, 0.0, 0.0];
    let up = [-lean.sin(), 0.0, lean.cos()];
    let normal = [lean.cos(), 0.0, lean.sin()];
    let centre = [contact[0] + radius * up[0], 0.0, radius * up[2]];
    stage.ground([-2.1, -2.1], [2.1, 2.1], 0.0, 0.35)?;
    stage.solid(Solid::ring(centre, normal, radius, 0.88 * radius, 0.14)?, Hue::Blue)?;
    stage.curve(Curve::circle(ORIGIN, UP, track)?, Stroke::Outline, Hue::Ink)?;
    stage.curve(Curve::circle([0.0, 0.0, centre[2]], UP, centre[0])?, Stroke::Reference, Hue::Muted)?;
    stage.curve(Curve::segment(ORIGIN, [0.0, 0.0, 1.5])?, Stroke::Dotted, Hue::Ink)?;
    stage.named_vector([0.0, 0.0, 1.5], [0.0, 0.0, 2.1], r"$\boldsymbol\Omega$", Hue::Orange)?;
    stage.turning([0.0, 0.0, 1.7], UP, 0.2, Hue::Orange)?;
    stage.arrow(Curve::segment([0.0, 0.0, centre[2]], centre)?, Stroke::Outline, Heads::Both, Hue::Ink)?;
    stage.label([0.5 * centre[0], 0.0, centre[2]], Side::Above, "$b$", Hue::Ink)?;
    let end = |length: f64| [0, 1, 2].map(|index| centre[index] + length * normal[index]);
    stage.named_vector(centre, end(0.9), r"$\hat{\boldsymbol 3}$", Hue::Ink)?;
    stage.dot_in_front(contact, 3.4, Hue::Pink)?;
    stage.label(contact, Side::BelowRight, "$P$", Hue::Pink)?;
    draw(&stage, "fig:rolling", "A wheel on a circle")
}

/// A pencil: a rod with a tip, and a sphere on a rod.
fn pencil() -> Result<Drawing, SpaceError> {
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, 0.8],
        ..view(-60.0, 22.0, at(180.0, 195.0), 92.0)
    })?);
    let lean = 25.0_f64.to_radians();
    let axis = [lean.sin(), 0.0, lean.cos()];
    stage.ground([-1.2, -1.2], [1.8, 1.2], 0.0, 0.3)?;
    stage.solid(Solid::cone(ORIGIN, axis, 0.25, 0.45)?, Hue::Orange)?;
    let neck = 0.45 * 0.25_f64.cos();
    stage.solid(Solid::rod(scaled(axis, neck), scaled(axis, 2.0), 0.45 * 0.25_f64.sin())?, Hue::Blue)?;
    stage.solid(
        Solid::rod([-0.7, -0.5, 0.0], [-0.7, 0.4, 1.7], 0.05)?.edges(Edges::BehindOthers),
        Hue::Muted,
    )?;
    stage.solid(Solid::sphere([-0.7, -0.05, 0.85], 0.35)?, Hue::Green)?;
    stage.solid(
        Solid::cuboid([1.1, -0.6, 0.2], [[0.8, 0.6, 0.0], [-0.6, 0.8, 0.0], UP], [0.3, 0.2, 0.2])?
            .edges(Edges::All),
        Hue::Purple,
    )?;
    stage.curve(Curve::segment(ORIGIN, [0.0, 0.0, 1.9])?, Stroke::Reference, Hue::Muted)?;
    stage.angle(ORIGIN, UP, axis, 1.2, r"$\theta$", Hue::Ink)?;
    draw(&stage, "fig:pencil", "A pencil on its tip")
}

/// Two rings that hold each other, and a rod through one.
fn links() -> Result<Drawing, SpaceError> {
    let mut stage = Stage::new(Camera::new(view(-62.0, 24.0, at(190.0, 200.0), 95.0))?);
    stage.solid(Solid::ring([-0.5, 0.0, 0.0], [0.2, -0.3, 1.0], 1.0, 0.8, 0.2)?, Hue::Blue)?;
    stage.solid(Solid::ring([0.6, 0.0, 0.0], [0.1, 1.0, 0.2], 1.0, 0.8, 0.2)?, Hue::Orange)?;
    stage.solid(Solid::rod([-1.2, -0.4, -1.2], [-0.6, 0.3, 1.3], 0.06)?, Hue::Ink)?;
    draw(&stage, "fig:links", "Two rings that hold each other")
}

/// A wobble plate with four pistons.
fn engine() -> Result<Drawing, SpaceError> {
    let mut stage = Stage::new(Camera::new(view(-66.0, 24.0, at(190.0, 215.0), 92.0))?);
    let alpha = 22.0_f64.to_radians();
    let normal = [alpha.sin(), 0.0, alpha.cos()];
    stage.solid(Solid::disc(ORIGIN, normal, 1.15, 0.1)?, Hue::Blue)?;
    stage
        .solid(Solid::rod([0.0, 0.0, -1.4], [0.0, 0.0, 1.7], 0.05)?.edges(Edges::BehindOthers), Hue::Muted)?;
    for index in 0..4 {
        let (sin, cos) = (TAU * (f64::from(index) + 0.5) / 4.0).sin_cos();
        let (x, y) = (0.8 * cos, 0.8 * sin);
        let foot = -x * alpha.tan() + 0.06;
        stage.solid(Solid::rod([x, y, foot], [x, y, foot + 0.5], 0.05)?, Hue::Ink)?;
        stage.solid(Solid::rod([x, y, foot + 0.5], [x, y, foot + 0.9], 0.2)?, Hue::Green)?;
    }
    draw(&stage, "fig:engine", "A wobble plate with four pistons")
}

fn draw(stage: &Stage, id: &str, title: &str) -> Result<Drawing, SpaceError> {
    let mut drawing = Drawing::new(id, 380.0, 400.0).titled(title, "A drawing to be looked at.");
    stage.write(&mut drawing);
    Ok(drawing)
}
