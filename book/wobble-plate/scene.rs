//! The scene of the chapter "The wobble plate": an engine on soft springs, and what shakes it.

#[path = "scene/answer.rs"]
mod answer;
#[path = "scene/painter.rs"]
mod painter;

use live::prelude::*;
use mechanics::scenes::wobble_plate::{Engine, PistonParameters, Pistons, Plate, PlateParameters};
use nalgebra::{UnitQuaternion, Vector3};
use painter::Painter;

pub(crate) const SCENE: Scene = Scene {
    file: file!(),
    name: "wobble-plate",
    title: "An engine with a wobble plate, on soft springs",
    description: "A tilted round plate on an upright shaft. Four rods with pistons hang under it, and the frame below them stands on springs; it leans a little, and the end \
                  of the shaft draws a circle. Beside it a view along the shaft, with the angular momentum of the plate and that of the pistons. Below, the torque on the \
                  frame against the mass of the pistons.",
    question: "How many pistons does it take until the frame stands still, and how heavy must they be? Does it stay still at another speed, and at another tilt?",
    size: [[640.0, 440.0], [380.0, 560.0]],
    view: Some([-1.15, 0.24]),
    still: 0.006,
    controls: &[
        Control::slider("pistons", r"number of pistons, $N$", [1.0, 7.0, 1.0], "", 4.0),
        Control::slider("mass", r"mass of all of them, $Nm$", [0.0, 3.4, 0.004], "kg", 0.8),
        Control::slider("spin", r"spin, $\omega$", [0.0, 150.0, 1.0], "rad/s", 100.0),
        Control::slider("tilt", r"tilt of the plate, $\alpha$", [0.0, 45.0, 0.5], "°", 25.0),
        Control::slider("thickness", r"thickness of the plate, $h$", [0.0, 24.0, 0.02], "cm", 0.0),
        Control::choice("camera", "seen", &["in the room", "from the turning shaft"]),
    ],
    presets: &[
        preset("no pistons", &[("mass", 0.0)]),
        preset("two, at the balancing mass", &[("pistons", 2.0), ("mass", 1.676)]),
        preset("three, balanced", &[("pistons", 3.0), ("mass", 1.676)]),
        preset("twice too heavy", &[("mass", 3.352)]),
        preset("the plate that needs none", &[("mass", 0.0), ("thickness", 17.32)]),
    ],
    readings: &[
        reading("turns of the shaft", Form::Fixed(2), ""),
        reading("torque on the frame", Form::Fixed(2), "N·m"),
        reading("without pistons", Form::Fixed(2), "N·m"),
        reading("lean of the frame", Form::Fixed(2), "°"),
        reading("force along the shaft", Form::Fixed(1), "N"),
        reading(r"energy of the pistons, $T_\text{p}$", Form::Fixed(2), "J"),
        reading("its change since the start", Form::Digits(2), "J"),
    ],
    symbols: formulas![r"\boldsymbol{\omega}", r"\boldsymbol{L}"],
    start: |settings| Ok(Box::new(Shaking::new(settings)?)),
};

/// The chapter's plate and pistons, SI units. Lengths are drawn in units of the plate's radius.
const PLATE_MASS: f64 = 2.0;
const RADIUS: f64 = 0.1;
const DISTANCE: f64 = 0.07;
const ROD: f64 = 0.115;
/// The frame hangs free: its moment about a line across the shaft, kg·m², and its mass, kg. Its centre of mass is the
/// plate's centre.
const FRAME_MOMENT: f64 = 0.02;
const FRAME_MASS: f64 = 6.0;
/// It is drawn to lean and to hop by no more than this, rad and radii of the plate.
const LEAN_LIMIT: f64 = 0.24;
const HOP_LIMIT: f64 = 0.3;
/// The momentum across the shaft of the chapter's plate at 1 rad/s, kg·m²/s.
const USUAL_MOMENTUM: f64 = 0.0019;
/// The radius of the shaft.
const SHAFT: f64 = 0.045;
/// A thin plate is drawn no thinner, radii.
const THINNEST: f64 = 0.07;
/// Steps in a turn for what is sampled once.
const STEPS: u32 = 72;
/// Where things stand on the shaft, in radii of the plate: its upper end, the frame, the floor.
const TOP: f64 = 1.15;
const FRAME: f64 = -2.05;
const FLOOR: f64 = -2.75;

/// The engine with its settings.
struct Shaking {
    engine: Engine,
    spin: f64,
    from_shaft: bool,
    /// Mass of all pistons, and that which balances three and more, if any does, kg.
    mass: f64,
    balancing: Option<f64>,
    /// Thickness of the plate, m.
    thickness: f64,
    /// The part of the momentum across the shaft at each step of a turn, for a spin of 1 rad/s, kg·m².
    momenta: Vec<Vector3<f64>>,
    /// Torque on the frame against the mass of all pistons: least and greatest of a turn, N·m.
    torques: Vec<(f64, [f64; 2])>,
}

/// Where the torque is plotted.
fn torques(room: Room) -> Plot<'static> {
    let frame = room.of(Rect::new(414.0, 286.0, 206.0, 98.0), Rect::new(218.0, 396.0, 148.0, 118.0));
    let y = Axis::linear(0.0, 50.0, 20.0).titled("torque on the frame, N·m");
    Plot { frame, x: Axis::linear(0.0, 3.4, 1.0).titled("all pistons, kg"), y }
}

fn plate(tilt: f64, thickness: f64) -> Result<Plate, Cause> {
    let parameters = PlateParameters { mass: PLATE_MASS, radius: RADIUS, thickness, tilt };
    Ok(Plate::new(parameters)?)
}

/// So many pistons, this heavy together, on a plate.
fn engine(plate: Plate, count: u32, mass: f64) -> Result<Engine, Cause> {
    let mass = mass / f64::from(count);
    let pistons = PistonParameters { count, mass, distance: DISTANCE, rod: ROD };
    Ok(Engine::new(plate, Pistons::new(pistons)?))
}

/// A vector shortened so that it stays below a length, and hardly changed if it is far below.
fn limited(vector: Vector3<f64>, limit: f64) -> Vector3<f64> {
    let length = vector.norm();
    if length > 1e-12 { vector * (limit * (length / limit).tanh() / length) } else { vector }
}

/// How far the frame leans at a phase, as it hangs free: a small rotation, rad. The torque that the engine takes from
/// it goes to and fro once a turn, so its lean is that over its moment and `ω²`: the same at every speed.
fn lean(engine: &Engine, phase: f64) -> Vector3<f64> {
    engine.frame_torque(phase, 1.0) / FRAME_MOMENT
}

/// The least and the greatest torque on the frame in a turn, N·m.
fn torque_range(engine: &Engine, spin: f64) -> [f64; 2] {
    // For three pistons and more it is the same all the time, for fewer the same every half turn.
    let steps = if engine.pistons().count() < 3 { STEPS / 2 } else { 1 };
    let phases = (0..steps).map(|step| TAU * f64::from(step) / f64::from(STEPS));
    let torques = phases.map(|phase| engine.frame_torque(phase, spin).norm());
    torques.fold([f64::MAX, 0.0], |[least, most], torque| [least.min(torque), most.max(torque)])
}

impl Shaking {
    fn new(settings: &Settings<'_>) -> Result<Self, Cause> {
        let (tilt, mass) = (settings.of("tilt")?.to_radians(), settings.of("mass")?);
        let (count, spin) = (settings.of("pistons")? as u32, settings.of("spin")?);
        let thickness = 0.01 * settings.of("thickness")?;
        let plate = plate(tilt, thickness)?;
        let engine = engine(plate, count, mass)?;
        let across = |phase: f64| engine.angular_momentum(phase, 1.0).xy().push(0.0);
        let momenta = linear_steps(0.0, TAU, STEPS).map(across).collect();
        let mut torques = Vec::new();
        for mass in linear_steps(0.0, 3.4, 68) {
            torques.push((mass, torque_range(&self::engine(plate, count, mass)?, spin)));
        }
        let three = Pistons::new(PistonParameters { count: 3, mass: 0.0, distance: DISTANCE, rod: ROD })?;
        let balancing = plate.balancing_mass(&three).ok().map(|mass| 3.0 * mass);
        let from_shaft = settings.choice("camera")? == 1;
        Ok(Self { engine, spin, from_shaft, mass, balancing, thickness, momenta, torques })
    }

    fn count(&self) -> u32 {
        self.engine.pistons().count()
    }

    /// How far the frame is drawn below its usual place, radii, so that the rods reach under a thick plate.
    fn drop(&self) -> f64 {
        0.5 * self.thickness / (RADIUS * self.engine.plate().tilt().cos())
    }

    /// How the frame of an engine is drawn at a phase: it leans and, as the force along the shaft asks it to, hops.
    fn stands(&self, engine: &Engine, phase: f64) -> (UnitQuaternion<f64>, Vector3<f64>) {
        if self.spin == 0.0 {
            return (UnitQuaternion::identity(), Vector3::zeros());
        }
        let hop = Vector3::z() * (engine.shaking_force(phase, 1.0) / (FRAME_MASS * RADIUS));
        let lean = limited(lean(engine, phase), LEAN_LIMIT);
        (UnitQuaternion::from_scaled_axis(lean), limited(hop, HOP_LIMIT))
    }

    /// From the room to what the reader sees, who may turn with the shaft.
    fn seen(&self, phase: f64) -> UnitQuaternion<f64> {
        UnitQuaternion::from_axis_angle(&Vector3::z_axis(), if self.from_shaft { -phase } else { 0.0 })
    }

    /// The high end of the plate, in the picture's space, at a tilt.
    fn high_end(&self, tilt: f64, phase: f64) -> Result<Vector3<f64>, Cause> {
        let engine = engine(plate(tilt, self.thickness)?, self.count(), self.mass)?;
        let (lean, hop) = self.stands(&engine, phase);
        let end = Vector3::new(tilt.cos() * phase.cos(), tilt.cos() * phase.sin(), tilt.sin());
        Ok(self.seen(phase) * (lean * end + hop))
    }

    /// Where the high end of the plate, at a tilt in degrees, is in the picture of a moment.
    fn rim(&self, degrees: f64, moment: &Moment) -> Result<Point, Cause> {
        let end = self.high_end(degrees.to_radians(), self.phase(moment.time))?;
        Ok(self.camera(moment)?.0.on_page(end)?)
    }

    /// The camera, where its eye is, and its scale: a frame that hangs lower, under a thick plate, is seen from farther away.
    fn camera(&self, moment: &Moment) -> Result<(Camera, Vector3<f64>, f64), Cause> {
        let (drop, (centre, scale)) =
            (self.drop(), moment.room.of((at(172.0, 217.0), 81.0), (at(190.0, 182.0), 70.0)));
        let (target, scale) = (Vector3::z() * (-0.5 - 0.2 * drop), scale / (1.0 + 0.36 * drop));
        let eye = target + Vector3::from(moment.towards_eye()) * 12.0;
        Ok((moment.camera(target, 12.0, centre, scale)?, eye, scale))
    }

    /// The engine on its springs, part by part from back to front: the plane of the plate parts the upper shaft from
    /// what hangs below, the top of the frame parts that from the frame.
    fn draw_engine(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let ((camera, eye, scale), phase) = (self.camera(moment)?, self.phase(moment.time));
        let (seen, (lean, hop)) = (self.seen(phase), self.stands(&self.engine, phase));
        let place = |x: f64, y: f64, z: f64| seen * (lean * Vector3::new(x, y, z) + hop);
        let way = |x: f64, y: f64, z: f64| seen * (lean * Vector3::new(x, y, z));
        let (axis, (sin, cos)) = (way(0.0, 0.0, 1.0), self.engine.plate().tilt().sin_cos());
        let normal = way(-sin * phase.cos(), -sin * phase.sin(), cos);
        let half = (0.5 * self.thickness / RADIUS).max(0.5 * THINNEST);
        let height = (eye - place(0.0, 0.0, 0.0)).dot(&normal);
        let drop = self.drop();
        let (frame, ground, top) = (FRAME - drop, FLOOR - drop, TOP.max(drop + 0.4));
        let over_frame = (eye - place(0.0, 0.0, frame + 0.07)).dot(&axis) > 0.0;
        let mut floor = Stage::new(camera);
        floor.ground([-1.0, -1.0], [1.0, 1.0], ground, 0.5)?;
        floor.write(drawing);
        for quarter in 0..4 {
            let (sin, cos) = (TAU * (f64::from(quarter) + 0.35) / 4.0).sin_cos();
            let (x, y) = (0.85 * cos, 0.85 * sin);
            let foot = camera.on_page(seen * Vector3::new(x, y, ground))?;
            let head = camera.on_page(place(x, y, frame - 0.07))?;
            kit::spring(drawing, foot, head, 5, 15.0, 2.0, Hue::Ink);
        }
        // Above the plate: what the end of the shaft draws in the room, the spin, and the angular momentum.
        let mut above = Stage::new(camera);
        let path = linear_steps(0.0, TAU, STEPS).map(|phase| {
            let (lean, hop) = self.stands(&self.engine, phase % TAU);
            lean * (Vector3::z() * top) + hop
        });
        let path: Vec<Vector3<f64>> = path.collect();
        if path.iter().any(|point| (point - path[0]).norm() > 0.01) {
            let path = path.into_iter().map(|point| seen * point);
            above.curve(Curve::smooth(path)?, Stroke::Curve, Hue::Ink)?;
        }
        let about = place(0.0, 0.0, top - 0.35);
        above.turning(about, axis, 0.2, Hue::Orange)?;
        above.label_shifted(about, at(18.0, -2.0), Side::Right, r"$\boldsymbol{\omega}$", Hue::Orange)?;
        let momentum = seen * self.engine.angular_momentum(phase, 1.0).normalize();
        // It comes out of the upper face, or of the side of a thick plate.
        let rises = momentum.dot(&normal);
        let out = (half / rises).min(1.0 / (1.0 - rises * rises).max(1e-12).sqrt());
        above.vector(place(0.0, 0.0, 0.0) + momentum * out, momentum * (top + 0.6), Hue::Green)?;
        above.label(momentum * (top + 0.6), Side::Above, r"$\boldsymbol{L}$", Hue::Green)?;
        let along = |from: f64, to: f64| [place(0.0, 0.0, from), place(0.0, 0.0, to)];
        let plate = [-half, half].map(|along| normal * along).map(|step| place(0.0, 0.0, 0.0) + step);
        let mut painter = Painter { camera, eye, scale, drawing: &mut *drawing };
        if over_frame {
            painter.cylinder(along(frame - 0.07, frame + 0.07), 0.95, Hue::Muted)?;
        }
        // Rods would miss a thick plate, and get a light face. From between its faces nothing hides the plate.
        let face = [-0.05, -0.02].map(|along| place(0.0, 0.0, -drop) + normal * along);
        let has_face = self.thickness > THINNEST * RADIUS;
        if height > -half {
            self.draw_pistons(&mut painter, phase)?;
        }
        if height > -half && has_face {
            painter.cylinder(face, 0.95, Hue::Muted)?;
        }
        if height < half {
            painter.cylinder(along(drop, top), SHAFT, Hue::Muted)?;
            above.write(painter.drawing);
        }
        painter.cylinder(plate, 1.0, Hue::Blue)?;
        if height >= half {
            painter.cylinder(along(drop, top), SHAFT, Hue::Muted)?;
            above.write(painter.drawing);
        }
        if height <= -half {
            if has_face {
                painter.cylinder(face, 0.95, Hue::Muted)?;
            }
            self.draw_pistons(&mut painter, phase)?;
        }
        if !over_frame {
            painter.cylinder(along(frame - 0.07, frame + 0.07), 0.95, Hue::Muted)?;
        }

        kit::grip(drawing, self.rim(self.engine.plate().tilt().to_degrees(), moment)?, Hue::Blue);
        Ok(())
    }

    /// What hangs below the plate, the farthest from the eye first: all of it stands upright.
    fn draw_pistons(&self, painter: &mut Painter<'_>, phase: f64) -> Result<(), Cause> {
        let (seen, (lean, hop)) = (self.seen(phase), self.stands(&self.engine, phase));
        let place = |point: Vector3<f64>| seen * (lean * point + hop);
        let along = |point: Vector3<f64>, from: f64, to: f64| {
            [from, to].map(|height| place(Vector3::new(point.x, point.y, height)))
        };
        // A piston is as thick as it is heavy.
        let thickness = 0.05 + 0.15 * (self.mass / f64::from(self.count())).sqrt().min(1.0);
        let drop = self.drop();
        let mut uprights = vec![vec![(along(Vector3::zeros(), FRAME - drop + 0.07, -drop - 0.02), SHAFT)]];
        for n in 1..=self.count() {
            let contact = self.engine.contact(n, phase) / RADIUS - Vector3::z() * drop;
            let height = self.engine.centre(n, phase).z / RADIUS - drop;
            let rod = (along(contact, height + 0.15, contact.z - 0.05), 0.028);
            let piston = (along(contact, height - 0.15, height + 0.15), thickness);
            let rod_first = (painter.eye - rod.0[0]).dot(&(rod.0[1] - rod.0[0])) < 0.0;
            uprights.push(if rod_first { vec![rod, piston] } else { vec![piston, rod] });
        }
        let axis = place(Vector3::z()) - place(Vector3::zeros());
        let distance = |parts: &Vec<([Vector3<f64>; 2], f64)>| {
            let sight = painter.eye - parts[0].0[0];
            (sight - axis * sight.dot(&axis)).norm()
        };
        uprights.sort_by(|one, other| distance(other).total_cmp(&distance(one)));
        for (ends, radius) in uprights.into_iter().flatten() {
            painter.cylinder(ends, radius, Hue::Muted)?;
        }
        Ok(())
    }

    /// The angular momenta across the shaft, seen along it.
    fn draw_momenta(&self, room: Room, phase: f64, drawing: &mut Drawing) -> Result<(), Cause> {
        let (ring, radius) = room.of((at(500.0, 134.0), 92.0), (at(86.0, 466.0), 70.0));
        let seen = self.seen(phase);
        let pistons = self.engine.piston_momentum(phase, 1.0);
        let sum = self.engine.angular_momentum(phase, 1.0).xy().push(0.0);
        let plate = sum - pistons;
        // The chapter's plate alone takes three quarters of the ring, unless something needs more room.
        let longest = self.momenta.iter().chain([&plate, &pistons]).map(Vector3::norm).fold(0.0, f64::max);
        let scale = f64::min(0.75 / USUAL_MOMENTUM, 0.9 / longest) * radius;
        let tip = |momentum: &Vector3<f64>| {
            let momentum = seen * momentum * scale;
            ring + at(momentum.x, -momentum.y)
        };
        drawing.note(ring - at(0.0, radius + 14.0), Side::Above, "momentum across the shaft", Hue::Ink)?;
        drawing.circle(ring, radius, Role::Line(Stroke::Grid, Hue::Ink));
        for n in 1..=self.count() {
            let place = seen * self.engine.contact(n, phase);
            let place = ring + at(place.x, -place.y) * (radius / DISTANCE);
            drawing.circle(place, 5.0, Role::Area(Fill::Page, Hue::Muted));
            drawing.circle(place, 5.0, Role::Line(Stroke::Outline, Hue::Muted));
        }
        if !self.from_shaft {
            let path: Vec<Point> = self.momenta.iter().map(tip).collect();
            drawing.polyline(&path, Stroke::Pale, Hue::Green);
        }
        drawing.dot(ring, 2.0, Hue::Ink);
        let [of_plate, of_pistons, of_both] = [&plate, &pistons, &sum].map(tip);
        let parts = [(of_plate, "plate"), (of_pistons, "pistons")];
        for (end, word) in parts {
            let way = end - ring;
            if way.length() < 2.0 {
                continue;
            }
            drawing.line(end, of_both, Stroke::Dotted, Hue::Green);
            if word == "plate" {
                kit::arrow(drawing, ring, end, Hue::Green);
            } else {
                kit::dimension(drawing, ring, end, Heads::End, Hue::Green);
            }
            // Beside the arrow, so far that the word clears it whichever way it points.
            let turned = way.unit().quarter_turned();
            let side = if word == "pistons" && plate.dot(&pistons) > 0.0 { turned * -1.0 } else { turned };
            let beside = side * (11.0 + side.x.abs() * if word == "plate" { 13.0 } else { 20.0 });
            drawing.note(ring.towards(end, 0.7) + beside, Side::Over, word, Hue::Green)?;
        }
        drawing.dot(of_both, 4.5, Hue::Green);
        if longest > 0.0 {
            // With three and more it lies on the two arrows, and no word stands at the side of its end.
            let side = (of_plate - ring).unit().quarter_turned() * -sum.dot(&plate).signum();
            let outwards = if (of_both - ring).length() < 0.55 * radius { 1.0 } else { -1.0 };
            let side = if self.count() < 3 { (of_both - ring).unit() * outwards } else { side };
            let place = of_both + side * (12.0 + side.x.abs() * 8.0);
            drawing.note(place, Side::Over, "sum", Hue::Green)?;
        }
        Ok(())
    }

    /// The torque on the frame against the mass of the pistons.
    fn draw_torque(&self, room: Room, phase: f64, drawing: &mut Drawing) -> Result<(), Cause> {
        let mut graph = torques(room).on(drawing)?;
        let least = self.torques.iter().map(|&(mass, [least, _])| (mass, least));
        let most = self.torques.iter().map(|&(mass, [_, most])| (mass, most));
        graph.answer(|graph| {
            if self.count() < 3 {
                graph.area(least.clone().chain(most.clone().rev()), Fill::Ground, Hue::Purple);
                graph.curve(least, Stroke::Outline, Hue::Purple);
                graph.curve(most, Stroke::Outline, Hue::Purple);
            } else {
                graph.curve(most, Stroke::Curve, Hue::Purple);
            }
            let Some(balancing) = self.balancing else { return Ok(()) };
            graph.upright(balancing, Stroke::Dotted, Hue::Muted);
            let side = if balancing < 1.5 { Side::Right } else { Side::Left };
            graph.label((balancing, 46.0), side, "balance", Hue::Muted)
        })?;
        let alone = self.engine.plate().bearing_torque_rotating(self.spin).norm();
        graph.level(alone, Stroke::Reference, Hue::Muted);
        if (4.0..36.0).contains(&alone) {
            let above = graph.at((0.0, alone)) - at(-2.0, 9.0);
            graph.drawing().label(above, Side::Right, "no pistons", Hue::Muted)?;
        }
        kit::grip(drawing, self.mass_grip(room, phase), Hue::Purple);
        Ok(())
    }

    /// Where the torque on the frame stands in the graph, or the place above it that the graph still shows.
    fn mass_grip(&self, room: Room, phase: f64) -> Point {
        let (plot, torque) = (torques(room), self.engine.frame_torque(phase, self.spin).norm());
        plot.point((self.mass, torque.min(plot.y.scale.to)))
    }

    fn phase(&self, time: f64) -> f64 {
        self.spin * time
    }
}

impl Motion for Shaking {
    fn run(&self) -> Run {
        // Whole turns, so that the end meets the beginning.
        let turns = (0.25 * self.spin / TAU).round().max(1.0);
        let duration = if self.spin > 0.0 { (turns * TAU / self.spin).min(1.0) } else { 0.25 };
        Run { duration, pace: 0.03, repeats: true }
    }

    fn draw(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let phase = self.phase(moment.time);
        self.draw_engine(moment, drawing)?;
        self.draw_momenta(moment.room, phase, drawing)?;
        self.draw_torque(moment.room, phase, drawing)
    }

    fn readings(&self, time: f64) -> Result<Vec<f64>, Cause> {
        let (phase, spin) = (self.phase(time), self.spin);
        let energy = self.engine.piston_energy(phase, spin);
        Ok(vec![
            phase / TAU,
            self.engine.frame_torque(phase, spin).norm(),
            self.engine.plate().bearing_torque_rotating(spin).norm(),
            if spin == 0.0 { 0.0 } else { lean(&self.engine, phase).norm().to_degrees() },
            self.engine.shaking_force(phase, spin),
            energy,
            energy - self.engine.piston_energy(0.0, spin),
        ])
    }

    fn words(&self, _time: f64) -> String {
        answer::answer(self)
    }

    fn grips(&self, moment: &Moment) -> Vec<Point> {
        let rim = self.rim(self.engine.plate().tilt().to_degrees(), moment);
        [self.mass_grip(moment.room, self.phase(moment.time))].into_iter().chain(rim.ok()).collect()
    }

    fn drag(&self, grip: usize, to: Point, moment: &Moment) -> Vec<(&'static str, f64)> {
        if grip == 0 {
            return vec![("mass", torques(moment.room).value(to).0)];
        }
        let tilt = nearest(linear_steps(0.0, 45.0, 90), to, |tilt| self.rim(tilt, moment));
        tilt.map(|tilt| vec![("tilt", tilt)]).unwrap_or_default()
    }
}
