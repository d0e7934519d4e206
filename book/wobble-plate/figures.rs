//! The figures of the chapter "The wobble plate".

use drawing::kit::{self, Heads};
use drawing::space::{Camera, Curve, Solid, Stage, View};
use drawing::{Drawing, Fill, Hue, Point, Rect, Side, Stroke, at};
use figures::{Axis, Cause, Figure, Outcome, Plot, figures, in_both, linear_steps};
use mechanics::InvalidQuantity;
use mechanics::inertia::SymmetricMoments;
use mechanics::scenes::wobble_plate::{
    Engine, Piston, PistonParameters, Pistons, Plate, PlateParameters, Unbalance, in_room,
};
use nalgebra::Vector3;

/// All figures of this chapter.
pub(crate) const FIGURES: &[Figure] =
    figures![wobble_plate, opposition, engine, residual, sharing, lean, any_thickness, any_faults];

/// The spin of the chapter's shaft, rad/s, and the tilt of its plate, degrees.
const SPIN: f64 = 100.0;
const TILT: f64 = 25.0;

/// The chapter's plate: 2 kg, 10 cm, with a tilt in degrees.
fn plate(degrees: f64) -> Result<Plate, InvalidQuantity> {
    Plate::new(PlateParameters { mass: 2.0, radius: 0.1, thickness: 0.0, tilt: degrees.to_radians() })
}

/// So many pistons on the chapter's plate, all of them together with a multiple of the mass that balances three and
/// more.
fn with_pistons(plate: Plate, count: u32, part: f64) -> Result<Engine, Cause> {
    let three = PistonParameters { count: 3, mass: 0.0, distance: 0.07, rod: 0.2 };
    let needed = 3.0 * plate.balancing_mass(&Pistons::new(three)?)?;
    let pistons = PistonParameters { count, mass: part * needed / f64::from(count), ..three };
    Ok(Engine::new(plate, Pistons::new(pistons)?))
}

/// The plate on its shaft, with its own axes and those that turn with the shaft.
pub(crate) fn wobble_plate(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 500.0, 470.0).titled(
        "The wobble plate on its shaft",
        "A round plate on an upright shaft that stands on the floor, tilted so that its right side is high. Axis 1 lies in the plate and \
         rises to the right, axis 2 lies in it and points level away from the reader, axis 3 is its normal and leans to the left of the \
         shaft by the angle alpha. The angular velocity omega points up along the shaft. A radius of the plate is marked R. Beside it \
         stand the axes that turn with the shaft: x prime to the right, under axis 1, y prime away from the reader, along axis 2, and z \
         upwards.",
    );
    let plate = plate(32.0)?;
    let (sin, cos) = plate.tilt().sin_cos();
    let (first, second) = (Vector3::new(cos, 0.0, sin), Vector3::y());
    let normal = first.cross(&second);
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, 0.35],
        azimuth: -1.25,
        elevation: 0.34,
        distance: 9.0,
        centre: at(250.0, 255.0),
        scale: 108.0,
    })?);
    let floor = -1.15;
    stage.ground([-0.9, -0.6], [0.9, 0.6], floor, 0.3)?;
    stage.solid(Solid::disc([0.0; 3], normal, 1.0, 0.07)?, Hue::Blue)?;
    let shaft = Solid::rod([0.0, 0.0, floor], [0.0, 0.0, 1.45], 0.045)?;
    stage.solid(shaft.dashed(), Hue::Muted)?;
    stage.named_vector([0.0, 0.0, 1.45], [0.0, 0.0, 2.0], r"$\boldsymbol{\omega}$", Hue::Orange)?;
    stage.turning([0.0, 0.0, 1.68], [0.0, 0.0, 1.0], 0.2, Hue::Orange)?;
    for (tip, name) in [
        (first * 1.5, r"$\hat{\mathbf{1}}$"),
        (second * 1.6, r"$\hat{\mathbf{2}}$"),
        (normal * 1.75, r"$\hat{\mathbf{3}}$"),
    ] {
        stage.named_vector([0.0; 3], tip, name, Hue::Ink)?;
    }
    stage.angle([0.0; 3], [0.0, 0.0, 1.0], normal, 1.2, r"$\alpha$", Hue::Ink)?;
    // A radius on the upper face.
    let across = -second;
    let towards = across * 0.8 - first * 0.6;
    let face = normal * 0.036;
    stage.curve(Curve::segment(face, face + towards)?, Stroke::Outline, Hue::Ink)?;
    stage.label(face - first * 0.5 - across * 0.05, Side::Over, "$R$", Hue::Ink)?;
    // The axes that turn with the shaft.
    let corner = Vector3::new(-2.15, 0.0, -0.2);
    for (axis, name) in [
        (Vector3::x(), r"$\hat{\mathbf{x}}'$"),
        (Vector3::y(), r"$\hat{\mathbf{y}}'$"),
        (Vector3::z(), r"$\hat{\mathbf{z}}$"),
    ] {
        stage.named_vector(corner, corner + axis * 0.55, name, Hue::Muted)?;
    }
    stage.write(&mut drawing);
    Ok(drawing)
}

/// A side view in the plane of x′ and z, in radii of the plate: where the plate's centre stands on the page, and how
/// long a radius is, px.
struct SideView {
    centre: Point,
    scale: f64,
}

impl SideView {
    fn at(&self, x: f64, z: f64) -> Point {
        self.centre + at(x, -z) * self.scale
    }

    /// The tilted plate, edge on, with its shaft from a height to another.
    fn plate(&self, drawing: &mut Drawing, plate: &Plate, heights: [f64; 2]) {
        let (sin, cos) = plate.tilt().sin_cos();
        let (along, across) = (at(cos, -sin) * self.scale, at(-sin, -cos) * (0.045 * self.scale));
        let rod = |from: f64, to: f64| {
            let x = 0.04;
            vec![self.at(-x, from), self.at(x, from), self.at(x, to), self.at(-x, to)]
        };
        let disc = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        let disc = disc.map(|(a, b)| self.centre + along * a + across * b);
        let bodies =
            [(rod(heights[0], heights[1]), Fill::Side, Hue::Muted), (disc.into(), Fill::Face, Hue::Blue)];
        for (points, fill, hue) in bodies {
            outlined(drawing, points, fill, hue);
        }
    }

    /// How far out a point is and how high, as two thin lines with their letters.
    fn arms(&self, drawing: &mut Drawing, x: f64, z: f64, aside: f64) -> Result<(), Cause> {
        kit::dimension(drawing, self.at(0.0, 0.0), self.at(x, 0.0), Heads::Both, Hue::Ink);
        drawing.label(self.at(0.55 * x, 0.0), Side::Below, "$x'$", Hue::Ink)?;
        kit::dimension(drawing, self.at(x + aside, 0.0), self.at(x + aside, z), Heads::Both, Hue::Ink);
        drawing.label(self.at(x + aside, 0.5 * z), Side::Right, "$z$", Hue::Ink)?;
        Ok(())
    }
}

/// A filled shape with its outline.
fn outlined(drawing: &mut Drawing, points: Vec<Point>, fill: Fill, hue: Hue) {
    let mut border = points.clone();
    border.push(points[0]);
    drawing.polygon(points, fill, hue);
    drawing.polyline(&border, Stroke::Outline, hue);
}

/// Why plate and pistons are opposed: centrifugal pulls lay the plate flat, the pistons' inertia makes it steeper.
pub(crate) fn opposition(id: &str) -> Outcome {
    Ok(Drawing::panels(id, vec![plate_pulls()?, pistons_push()?]))
}

fn plate_pulls() -> Outcome {
    let mut drawing = Drawing::new("", 400.0, 372.0).titled(
        "The plate alone",
        "Side view of the tilted plate on its upright shaft, its right end high. Specks of its right half are pulled outwards to the right, \
         specks of its left half outwards to the left, the harder the farther out they are: together the pulls would turn the plate flat, \
         clockwise as it is seen. For one speck its distance x prime from the shaft and its height z above the centre are marked. The \
         upper bearing holds the shaft with a force to the left, the lower one with an equal force to the right.",
    );
    let (plate, side) = (plate(TILT)?, SideView { centre: at(200.0, 186.0), scale: 104.0 });
    side.plate(&mut drawing, &plate, [-1.42, 1.42]);
    let (sin, cos) = plate.tilt().sin_cos();
    for place in [-0.92, -0.5, 0.5, 0.92] {
        // A pull in proportion to the distance from the shaft.
        let (x, z) = (place * cos, place * sin);
        kit::dimension(&mut drawing, side.at(x, z), side.at(1.5 * x, z), Heads::End, Hue::Purple);
        drawing.dot(side.at(x, z), 2.6, Hue::Blue);
    }
    drawing.label(side.at(1.5 * 0.92 * cos, 0.92 * sin), Side::AboveLeft, "pull", Hue::Purple)?;
    side.arms(&mut drawing, 0.92 * cos, 0.92 * sin, 0.0)?;
    // A pair of forces at ±h along the shaft with the torque that is wanted: 2h z × F = τ.
    let force = plate.bearing_torque_rotating(SPIN).cross(&Vector3::z()).normalize();
    for (end, name) in [(1.0, r"$\boldsymbol{F}$"), (-1.0, r"$-\boldsymbol{F}$")] {
        let (height, way) = (1.18 * end, force.x * end);
        for x in [-0.13, 0.05] {
            let corners = [(x, -0.07), (x + 0.08, -0.07), (x + 0.08, 0.07), (x, 0.07)];
            let corners = corners.map(|(x, z)| side.at(x, height + z));
            outlined(&mut drawing, corners.into(), Fill::Face, Hue::Muted);
        }
        kit::arrow(&mut drawing, side.at(-0.75 * way, height), side.at(-0.17 * way, height), Hue::Purple);
        drawing.label(side.at(-0.55 * way, height), Side::Above, name, Hue::Purple)?;
    }
    drawing.label(side.at(-0.2, 1.18), Side::Left, "bearing", Hue::Ink)?;
    drawing.label(side.at(0.2, -1.18), Side::Right, "bearing", Hue::Ink)?;
    // The low end is turned up.
    kit::angle(&mut drawing, side.centre, 1.13 * side.scale, 3.30, -0.42, Heads::End, Hue::Purple);
    drawing.label(side.at(-1.13, 0.26), Side::Above, "flatter", Hue::Purple)?;
    Ok(drawing)
}

fn pistons_push() -> Outcome {
    let mut drawing = Drawing::new("", 400.0, 372.0).titled(
        "The pistons",
        "The same side view with two pistons that hang by upright rods under the plate, one under its high right end, one under its low left \
         end. The inertia of the right one, at the top of its stroke, pushes upwards, that of the left one, at the bottom of its stroke, \
         downwards: together they would turn the plate steeper, counter-clockwise as it is seen. The distance x prime of the right rod \
         from the shaft and the height z of its end are marked.",
    );
    let side = SideView { centre: at(200.0, 186.0), scale: 104.0 };
    let tilt = TILT.to_radians();
    let plate = Plate::new(PlateParameters { mass: 2.0, radius: 1.0, thickness: 0.0, tilt })?;
    let pistons = PistonParameters { count: 4, mass: 0.4, distance: 0.72, rod: 0.86 };
    let engine = Engine::new(plate, Pistons::new(pistons)?);
    side.plate(&mut drawing, &plate, [-1.42, 0.75]);
    // At the phase 0 piston 1 is highest and piston 3 lowest.
    for n in [1, 3] {
        let (contact, centre) = (engine.contact(n, 0.0), engine.centre(n, 0.0));
        let upright = |half: f64, from: f64, to: f64| {
            let x = contact.x;
            [(x - half, from), (x + half, from), (x + half, to), (x - half, to)].map(|(x, z)| side.at(x, z))
        };
        let rod = upright(0.028, centre.z + 0.17, contact.z - 0.055);
        let piston = upright(0.15, centre.z - 0.17, centre.z + 0.17);
        for points in [rod, piston] {
            outlined(&mut drawing, points.into(), Fill::Side, Hue::Muted);
        }
        let push = -engine.acceleration(n, 0.0, 1.0) * 1.25;
        let (x, from) = (contact.x + 0.24 * contact.x.signum(), centre.z - 0.5 * push);
        kit::arrow(&mut drawing, side.at(x, from), side.at(x, from + push), Hue::Purple);
        let beside = if n == 1 { Side::Right } else { Side::Left };
        drawing.label(side.at(x, centre.z), beside, "push", Hue::Purple)?;
    }
    let contact = engine.contact(1, 0.0);
    side.arms(&mut drawing, contact.x, contact.z, 0.09)?;
    // The high end is turned up.
    kit::angle(&mut drawing, side.centre, 1.13 * side.scale, 0.42, 0.42, Heads::End, Hue::Purple);
    drawing.label(side.at(0.95, 0.78), Side::AboveRight, "steeper", Hue::Purple)?;
    Ok(drawing)
}

/// The engine with four pistons, and their heights during a turn.
pub(crate) fn engine(id: &str) -> Outcome {
    Ok(Drawing::panels(id, vec![pistons_under_the_plate()?, heights()?]))
}

fn pistons_under_the_plate() -> Outcome {
    let mut drawing = Drawing::new("", 330.0, 400.0).titled(
        "The plate with four pistons",
        "A tilted plate of radius R on an upright shaft, with its normal at the angle alpha to the shaft. Four rods, a quarter turn \
         apart, stand upright below it at the distance r from the shaft and touch its lower side, each with a cylindrical piston at its lower \
         end. The pistons, numbered 1 to 4 counter-clockwise from above, stand at different heights, lowest where the plate is low.",
    );
    let tilt = 24_f64.to_radians();
    let plate = Plate::new(PlateParameters { mass: 2.0, radius: 1.0, thickness: 0.0, tilt })?;
    let pistons = PistonParameters { count: 4, mass: 0.4, distance: 0.72, rod: 1.15 };
    let engine = Engine::new(plate, Pistons::new(pistons)?);
    let phase = 0.45_f64;
    let (s, c) = phase.sin_cos();
    let normal = Vector3::new(-tilt.sin() * c, -tilt.sin() * s, tilt.cos());
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, -0.3],
        azimuth: -1.15,
        elevation: 0.3,
        distance: 9.0,
        centre: at(160.0, 215.0),
        scale: 106.0,
    })?);
    stage.solid(Solid::disc([0.0; 3], normal, 1.0, 0.07)?, Hue::Blue)?;
    let shaft = Solid::rod([0.0, 0.0, -1.75], [0.0, 0.0, 0.75], 0.045)?;
    stage.solid(shaft.dashed(), Hue::Muted)?;
    for n in 1..=4 {
        let (contact, centre) = (engine.contact(n, phase), engine.centre(n, phase));
        let half = Vector3::new(0.0, 0.0, 0.17);
        let touch = contact - Vector3::new(0.0, 0.0, 0.05);
        stage.solid(Solid::rod(centre + half, touch, 0.028)?, Hue::Muted)?;
        stage.solid(Solid::rod(centre - half, centre + half, 0.14)?, Hue::Muted)?;
        let line = Curve::segment(centre - half * 1.2, centre - half * 2.6)?;
        stage.curve(line, Stroke::Dotted, Hue::Muted)?;
        stage.label_shifted(centre, at(0.0, 2.0), Side::Over, &format!("${n}$"), Hue::Ink)?;
    }
    // The normal and its angle, a radius of the plate, and the distance of a rod from the shaft.
    stage.vector([0.0; 3], normal * 1.1, Hue::Ink)?;
    stage.label(normal * 1.1, Side::Left, r"$\hat{\mathbf{3}}$", Hue::Ink)?;
    stage.angle([0.0; 3], [0.0, 0.0, 1.0], normal, 0.68, r"$\alpha$", Hue::Ink)?;
    let face = normal * 0.037;
    let rim = normal.cross(&Vector3::new(-0.35, 1.0, 0.0)).normalize();
    stage.curve(Curve::segment(face, face + rim)?, Stroke::Outline, Hue::Ink)?;
    stage.label(face + rim * 0.5, Side::Above, "$R$", Hue::Ink)?;
    let centre = engine.centre(1, phase) - Vector3::z() * 0.17;
    let foot = Vector3::new(0.0, 0.0, centre.z);
    stage.arrow(Curve::segment(foot, centre)?, Stroke::Outline, Heads::Both, Hue::Ink)?;
    stage.label(foot + (centre - foot) * 0.25, Side::Below, "$r$", Hue::Ink)?;
    stage.named_vector([0.0, 0.0, 0.75], [0.0, 0.0, 1.25], r"$\boldsymbol{\omega}$", Hue::Orange)?;
    stage.turning([0.0, 0.0, 0.97], [0.0, 0.0, 1.0], 0.2, Hue::Orange)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

fn heights() -> Outcome {
    let mut drawing = Drawing::new("", 340.0, 400.0).titled(
        "The heights of the pistons during a turn",
        "The heights of four pistons above the middle, in units of r tan alpha, against the phase from 0 to 360 degrees: four sines, each a \
         quarter turn after the one before. Pistons 1 and 3, and 2 and 4, are mirror images of each other, so the sum is zero all the time.",
    );
    let engine = with_pistons(plate(TILT)?, 4, 1.0)?;
    let stroke = engine.pistons().distance() * engine.plate().tilt().tan();
    let phase = Axis::linear(0.0, 360.0, 90.0).minor(30.0).titled(r"phase $\omega t$, degrees");
    let height = Axis::linear(-1.2, 1.2, 0.5).minor(0.1).titled(r"height over $r\tan\alpha$");
    let mut plot = Plot::new(&mut drawing, Rect::new(48.0, 70.0, 250.0, 240.0), phase, height)?;
    plot.level(0.0, Stroke::Reference);
    for (n, place, side) in [
        (1, (360.0, 1.0), Side::Right),
        (2, (90.0, 1.0), Side::Above),
        (3, (180.0, 1.0), Side::Above),
        (4, (270.0, 1.0), Side::Above),
    ] {
        let values = linear_steps(0.0, 360.0, 360)
            .map(|degrees| (degrees, engine.contact(n, degrees.to_radians()).z / stroke));
        plot.curve(&format!("height-{n}"), values, Stroke::Curve, Hue::Ink);
        plot.label(place, side, &format!("${n}$"), Hue::Ink)?;
    }
    plot.label((360.0, 0.0), Side::Right, "sum", Hue::Muted)?;
    Ok(drawing)
}

/// Torque on the frame against the mass of the pistons: three and more, and the band of one or two.
pub(crate) fn residual(id: &str) -> Outcome {
    let plate = plate(TILT)?;
    let alone = plate.bearing_torque_rotating(SPIN).norm();
    let [mut many, mut least, mut most] = [(); 3].map(|()| Vec::new());
    for part in linear_steps(0.0, 2.0, 200) {
        many.push((part, with_pistons(plate, 4, part)?.frame_torque(0.3, SPIN).norm()));
        let pair = with_pistons(plate, 2, part)?;
        let torques = linear_steps(0.0, 180.0, 72)
            .map(|degrees| pair.frame_torque(f64::to_radians(degrees), SPIN).norm());
        let (low, high) = torques.fold((f64::MAX, 0.0_f64), |(low, high), t| (low.min(t), high.max(t)));
        least.push((part, low));
        most.push((part, high));
    }
    // The tip of the torque in the room, during a turn, with two pistons.
    let paths = [0.25, 0.5, 1.0, 1.5].map(|part| -> Result<(f64, Vec<(f64, f64)>), Cause> {
        let pair = with_pistons(plate, 2, part)?;
        let torques =
            linear_steps(0.0, 360.0, 120).map(|degrees| pair.frame_torque(degrees.to_radians(), SPIN));
        Ok((part, torques.map(|torque| (torque.x, torque.y)).collect()))
    });
    let paths = paths.into_iter().collect::<Result<Vec<_>, Cause>>()?;
    in_both(|room| {
        let mut drawing = Drawing::new(id, room.of(580.0, 400.0), 460.0).titled(
            "Torque on the frame against the mass of the pistons",
            "The torque on the frame, in newton metres, against the mass of all pistons in units of the mass that balances, from 0 to 2. The plate \
             alone, marked by a dot, gives 19. With three pistons or more a heavy line runs straight down to zero at the balancing mass and \
             straight up again, to 19 at twice the mass. With one piston, or two, the torque swings during each turn between two lines, \
             and the band between them is tinted; its upper edge is never below the plate alone, its lower edge touches zero at half the balancing \
             mass, and at the balancing mass the band is pinched to a point on the level of the plate alone. Above, small pictures of the path of the \
             torque’s tip in one turn with two pistons: an ellipse at a quarter of the mass, a line at a half, a circle at the whole, an ellipse at one and a \
             half.",
        );
        let mass =
            Axis::linear(0.0, 2.0, 0.5).minor(0.1).titled("mass of all pistons, in units of what balances");
        let torque = Axis::linear(0.0, 60.0, 20.0).minor(5.0).titled("torque on the frame, N·m");
        let frame = Rect::new(52.0, 142.0, room.of(514.0, 320.0), 260.0);
        let mut plot = Plot::new(&mut drawing, frame, mass, torque)?;
        let band = most.iter().chain(least.iter().rev()).map(|&value| plot.at(value)).collect();
        plot.drawing().polygon(band, Fill::Ground, Hue::Purple);
        plot.curve("pair-least", least.iter().copied(), Stroke::Outline, Hue::Purple);
        plot.curve("pair-most", most.iter().copied(), Stroke::Outline, Hue::Purple);
        plot.curve("torque", many.iter().copied(), Stroke::Heavy, Hue::Purple);
        plot.markers(&[(0.0, alone)], kit::Marker::Disc, Hue::Ink);
        let label = |plot: &mut Plot<'_>, value, side, text: &str, hue| {
            let place = plot.at(value);
            plot.drawing().label_on_face(place, side, text, hue)
        };
        let words = room.of(["greatest in a turn", "least in a turn"], ["greatest", "least"]);
        label(&mut plot, (1.5, 38.0), Side::AboveLeft, words[0], Hue::Purple)?;
        label(&mut plot, (1.98, alone), Side::AboveLeft, words[1], Hue::Purple)?;
        label(&mut plot, (1.62, 26.5), Side::Over, "one or two", Hue::Purple)?;
        label(&mut plot, (1.24, 2.2), Side::Right, "three or more", Hue::Purple)?;
        plot.label((0.02, alone), Side::AboveRight, "the plate alone", Hue::Ink)?;
        // The small pictures stand above their masses, all to one scale.
        let scale = 0.9;
        for (part, path) in &paths {
            let middle = at(plot.at((*part, 0.0)).x, 66.0);
            let path: Vec<Point> = path.iter().map(|&(x, y)| middle + at(x, -y) * scale).collect();
            plot.drawing().polyline(&path, Stroke::Outline, Hue::Purple);
            if *part != 0.5 {
                // Where the path is nearest to the middle: a slim one turns back at its ends.
                let distance = |n: &usize| (path[*n] - middle).length();
                let nearest = (1..path.len()).min_by(|n, other| distance(n).total_cmp(&distance(other)));
                let nearest = nearest.ok_or("a path without points")?;
                let [before, tip] = [path[nearest - 1], path[nearest]];
                kit::head(plot.drawing(), tip, tip - before, 0.8, Hue::Purple);
            }
            plot.drawing().dot(middle, 2.0, Hue::Ink);
        }
        drawing.label(
            at(12.0, 14.0),
            Side::Right,
            "path of the torque’s tip in a turn, one or two pistons",
            Hue::Ink,
        )?;
        Ok(drawing)
    })
}

/// What two pistons do for the plate during a turn, and what three do.
pub(crate) fn sharing(id: &str) -> Outcome {
    let mut panels = Vec::new();
    for (count, word, title, description) in [
        (
            2,
            "two",
            "Two pistons",
            "The torque that would make the plate steeper, in units of m r squared omega squared tan alpha, against the phase from 0 to 360 \
             degrees. Each of two opposite pistons has the same curve, which goes between 0 and 1 twice a turn, so that their sum goes \
             between 0 and 2 about its mean of 1.",
        ),
        (
            3,
            "three",
            "Three pistons",
            "The same for three pistons. Each goes between 0 and 1 twice a turn, one after the other, and their sum is a level line at 1.5.",
        ),
    ] {
        let engine = with_pistons(plate(TILT)?, count, 1.0)?;
        let (mass, distance) = (engine.pistons().mass(), engine.pistons().distance());
        let unit = mass * (distance * SPIN).powi(2) * engine.plate().tilt().tan();
        // Push times lever of piston n, about −y′.
        let part = |n: u32, phase: f64| {
            let uphill = in_room(&Vector3::x(), phase);
            let push = -mass * engine.acceleration(n, phase, SPIN);
            push * engine.contact(n, phase).dot(&uphill) / unit
        };
        let mut drawing = Drawing::new("", 280.0, 310.0).titled(title, description);
        let phase = Axis::linear(0.0, 360.0, 90.0).minor(30.0).titled(r"phase $\omega t$, degrees");
        let torque =
            Axis::linear(0.0, 2.2, 0.5).minor(0.1).titled(r"steepening over $mr^2\omega^2\tan\alpha$");
        let mut plot = Plot::new(&mut drawing, Rect::new(44.0, 52.0, 222.0, 190.0), phase, torque)?;
        let degrees = || linear_steps(0.0, 360.0, 240);
        for n in 1..=if count == 2 { 1 } else { count } {
            let values = degrees().map(|degrees| (degrees, part(n, degrees.to_radians())));
            plot.curve(&format!("{word}-{n}"), values, Stroke::Outline, Hue::Purple);
        }
        let sum = |degrees: f64| (1..=count).map(|n| part(n, degrees.to_radians())).sum::<f64>();
        plot.curve(word, degrees().map(|degrees| (degrees, sum(degrees))), Stroke::Heavy, Hue::Purple);
        let (place, each) =
            if count == 2 { ((90.0, 2.0), (90.0, 1.0)) } else { ((180.0, 1.5), (180.0, 1.0)) };
        let words = if count == 2 { ["both", "each"] } else { ["all three", "each"] };
        plot.label(place, Side::Above, words[0], Hue::Purple)?;
        plot.label(each, Side::Above, words[1], Hue::Purple)?;
        panels.push(drawing);
    }
    Ok(Drawing::panels(id, panels))
}

/// The angular momentum of the plate, its lean, and how the pistons' takes the lean away.
pub(crate) fn lean(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 330.0, 330.0).titled(
        "The momenta of plate and pistons in the plane of shaft and normal",
        "Arrows from the centre of the plate, whose edge is seen below, in the plane of x prime and z. The angular velocity omega points up \
         along the shaft. Axis 3 leans to the left by the angle alpha, and the angular momentum L of the plate, between the two, by the \
         angle beta. The angular momentum of the pistons, set at the tip of that arrow, points level to the right and ends on the shaft.",
    );
    let plate = plate(35.0)?;
    let engine = with_pistons(plate, 4, 1.0)?;
    let side = SideView { centre: at(165.0, 250.0), scale: 84.0 };
    side.plate(&mut drawing, &plate, [-0.5, 0.0]);
    let (sin, cos) = plate.tilt().sin_cos();
    let origin = side.at(0.0, 0.0);
    drawing.line(origin, side.at(0.0, 2.55), Stroke::Reference, Hue::Muted);
    kit::dimension(&mut drawing, origin, side.at(-2.3 * sin, 2.3 * cos), Heads::End, Hue::Ink);
    drawing.label(side.at(-2.3 * sin, 2.3 * cos), Side::AboveLeft, r"$\hat{\mathbf{3}}$", Hue::Ink)?;
    // The momenta in units of I₁ω, the spin in units of its own.
    let unit = plate.angular_momentum_body(1.0).x / sin;
    let of_plate = plate.angular_momentum_rotating(1.0) / unit * 1.3;
    let of_pistons = engine.piston_momentum(0.0, 1.0) / unit * 1.3;
    let tip = side.at(of_plate.x, of_plate.z);
    kit::arrow(&mut drawing, origin, side.at(0.0, 1.15), Hue::Orange);
    drawing.label(side.at(0.0, 1.0), Side::Right, r"$\boldsymbol{\omega}$", Hue::Orange)?;
    kit::arrow(&mut drawing, origin, tip, Hue::Green);
    drawing.label(tip, Side::AboveLeft, r"$\boldsymbol{L}_{\text{plate}}$", Hue::Green)?;
    let end = side.at(of_plate.x + of_pistons.x, of_plate.z + of_pistons.z);
    kit::arrow(&mut drawing, tip, end, Hue::Green);
    drawing.label(end, Side::Right, r"$\boldsymbol{L}_{\text{p}}$", Hue::Green)?;
    let upwards = std::f64::consts::FRAC_PI_2;
    kit::angle(&mut drawing, origin, 150.0, upwards, plate.tilt(), Heads::None, Hue::Ink);
    drawing.label(
        origin + Point::polar(154.0, upwards + 0.8 * plate.tilt()),
        Side::Above,
        r"$\alpha$",
        Hue::Ink,
    )?;
    kit::angle(&mut drawing, origin, 112.0, upwards, plate.momentum_angle(), Heads::None, Hue::Green);
    let beside = origin + Point::polar(114.0, upwards + 0.5 * plate.momentum_angle());
    drawing.label(beside, Side::Above, r"$\beta$", Hue::Green)?;
    Ok(drawing)
}

/// The mass of all pistons that balances a plate of any thickness, with four such plates.
pub(crate) fn any_thickness(id: &str) -> Outcome {
    // eq:many-pistons, whether pistons can have that mass or not.
    let needed = |thickness: f64| -> Result<f64, InvalidQuantity> {
        let (radius, tilt) = (0.1, TILT.to_radians());
        let plate = Plate::new(PlateParameters { mass: 2.0, radius, thickness: thickness * radius, tilt })?;
        let SymmetricMoments { transverse, axial } = plate.moments().as_symmetric()?;
        Ok(2.0 * (axial - transverse) * (tilt.cos() / 0.07).powi(2))
    };
    let quiet = 3_f64.sqrt();
    let curve = |from: f64, to: f64| {
        linear_steps(from, to, 120)
            .map(|thickness| Ok((thickness, needed(thickness)?)))
            .collect::<Result<Vec<_>, InvalidQuantity>>()
    };
    in_both(|room| {
        let mut drawing = Drawing::new(id, room.of(580.0, 400.0), 430.0).titled(
            "The balancing mass against the thickness of the plate",
            "The mass of all pistons that balances the chapter's plate, in kilograms, against its thickness in units of its radius, from 0 to 2.4. A parabola falls \
             from 1.68 kilograms to nothing at the root of three, 1.73, where a dot marks it, and runs on below zero as a dashed curve. Above it \
             four tilted plates from the side: a thin one, one as thick as its radius, one of 1.73 radii, and one of 2.3, on their shafts.",
        );
        let thickness = Axis::linear(0.0, 2.4, 0.4).minor(0.1).titled(r"thickness of the plate, $h/R$");
        let mass = Axis::linear(-1.5, 2.0, 0.5).titled("mass of all pistons, kg");
        let frame = Rect::new(56.0, 134.0, room.of(508.0, 316.0), 240.0);
        let mut plot = Plot::new(&mut drawing, frame, thickness, mass)?;
        plot.level(0.0, Stroke::Reference);
        plot.curve("balancing", curve(0.0, quiet)?, Stroke::Curve, Hue::Ink);
        plot.curve("impossible", curve(quiet, 2.4)?, Stroke::Reference, Hue::Ink);
        plot.markers(&[(quiet, 0.0)], kit::Marker::Disc, Hue::Ink);
        plot.label((quiet, 0.1), Side::AboveRight, r"$\sqrt3$", Hue::Ink)?;
        let (sin, cos) = TILT.to_radians().sin_cos();
        for thickness in [0.12, 1.0, quiet, 2.25] {
            let radius = room.of(21.0, 15.0);
            // Above the frame, each at its thickness.
            let middle = at(plot.at((thickness, 0.0)).x, 48.0);
            // Axis 1 runs up to the right, axis 3 up to the left.
            let corner = |along: f64, height: f64| {
                let (x, y) = (along * cos - height * sin, along * sin + height * cos);
                middle + at(x, -y) * radius
            };
            let half = 0.5 * thickness;
            let corners =
                vec![corner(-1.0, -half), corner(1.0, -half), corner(1.0, half), corner(-1.0, half)];
            let shaft = at(0.0, 1.9 * radius);
            plot.drawing().line(middle - shaft, middle + shaft, Stroke::Outline, Hue::Muted);
            outlined(plot.drawing(), corners, Fill::Face, Hue::Blue);
        }
        Ok(drawing)
    })
}

/// Paths of the torque on the frame for three faults of a balanced engine with three pistons.
pub(crate) fn any_faults(id: &str) -> Outcome {
    let plate = plate(TILT)?;
    let alone = plate.bearing_torque_rotating(SPIN).norm();
    let even = with_pistons(plate, 3, 1.0)?.pistons();
    let path = |spoil: &dyn Fn(&mut [Piston; 3])| -> Result<Vec<(f64, f64)>, InvalidQuantity> {
        let azimuths = [0.0, 120.0, 240.0].map(f64::to_radians);
        let mut pistons =
            azimuths.map(|azimuth| Piston { mass: even.mass(), distance: even.distance(), azimuth });
        spoil(&mut pistons);
        let left = Unbalance::of(&plate, &pistons)?;
        let torques = linear_steps(0.0, 360.0, 360).map(|degrees| left.torque(degrees.to_radians(), SPIN));
        Ok(torques.map(|torque| (100.0 * torque.x / alone, 100.0 * torque.y / alone)).collect())
    };
    let all = path(&|pistons| pistons.iter_mut().for_each(|piston| piston.mass *= 1.1))?;
    let one = path(&|pistons| pistons[0].mass *= 1.1)?;
    let aside = path(&|pistons| pistons[0].azimuth += 6_f64.to_radians())?;
    let mut drawing = Drawing::new(id, 340.0, 340.0).titled(
        "Paths of the torque on the frame for three faults",
        "The two components of the torque on the frame across the shaft, in hundredths of the torque of the plate alone. With all three pistons a tenth too heavy its tip runs \
         round a circle of radius ten, counter-clockwise. With one of them a tenth too heavy it goes to and fro on an upright line through the middle, to 6.7 on either side. With one 6 degrees from its place it runs \
         clockwise round a circle of radius seven.",
    );
    let side = Axis::linear(-12.0, 12.0, 4.0).minor(1.0);
    let (x, y) = (side.titled(r"$\tau_x$, % of the plate’s"), side.titled(r"$\tau_y$, % of the plate’s"));
    let mut plot = Plot::new(&mut drawing, Rect::new(44.0, 34.0, 254.0, 254.0), x, y)?;
    for (name, values) in [("all-heavy", &all), ("one-heavy", &one), ("one-aside", &aside)] {
        plot.curve(name, values.iter().copied(), Stroke::Curve, Hue::Purple);
        // Two heads on each way: round the circles, and out to both ends of the line.
        let extreme = |up: bool| {
            let heights = values.iter().map(|value| if up { value.1 } else { -value.1 });
            let highest = heights.enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
            highest.map_or(0, |(index, _)| index.clamp(6, values.len() - 1))
        };
        let places = if name == "one-heavy" { [extreme(true), extreme(false)] } else { [45, 225] };
        for place in places {
            let [from, to] = [values[place - 6], values[place]].map(|value| plot.at(value));
            kit::head(plot.drawing(), to, to - from, 1.0, Hue::Purple);
        }
    }
    plot.label((7.4, 7.4), Side::AboveRight, "all heavy", Hue::Purple)?;
    plot.label((3.4, 0.8), Side::Over, "one", Hue::Purple)?;
    plot.label((3.4, -0.8), Side::Over, "heavy", Hue::Purple)?;
    plot.label((0.0, -8.4), Side::Over, "one aside", Hue::Purple)?;
    Ok(drawing)
}
