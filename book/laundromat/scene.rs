//! The scene of the chapter "Physics in the laundromat": a drum with its load, seen from above.

#[path = "scene/answer.rs"]
mod answer;
#[path = "scene/course.rs"]
mod course;
#[path = "scene/drum.rs"]
mod drum;

use course::{Course, Drive, State};
use drum::Drum;
use live::prelude::*;
use mechanics::InvalidQuantity;
use mechanics::scenes::laundromat::{Machine, MachineParameters, SteadyMotion};
use nalgebra::Complex;

pub(crate) const SCENE: Scene = Scene {
    file: file!(),
    name: "laundromat",
    title: "A drum with its load, from above",
    description: "Seen from above at a slant: a tub between four posts, held by a spring and a damper at each, and in it a drum with a heavy mat on one side. The shaft \
                  stands to one side of the fixed point O. Beside it three plots: the force on the floor against the spin, the angle from the shaft to the load against the \
                  spin, and the distance of the shaft from O against time.",
    question: "A flash shows the fast drum just when its centre is farthest to the right. Where is the load: on the right, on the left, or a quarter turn ahead?",
    size: [[640.0, 440.0], [380.0, 580.0]],
    view: Some([-FRAC_PI_2, 1.0]),
    still: 0.62,
    controls: &[
        Control::slider("spin", r"spin, $\Omega$", [0.0, MOST_SPIN, 0.1], "rad/s", 10.0),
        Control::slider("damping", r"damping, $\Gamma/\omega_0$", [0.0, 2.5, 0.01], "", 0.3),
        Control::choice("camera", "seen", &["in the room", "on the drum"]),
        Control::adding("kick", "Kick", &["push", "way"]),
        Control::KEEP,
        Control::slider("push", "kick, how strong", [0.0, MOST_PUSH, 0.01], "m/s", 0.4).when("kick", KICKED),
        Control::slider("way", "kick, which way", [-180.0, 180.0, 1.0], "°", 0.0).when("kick", KICKED),
        Control::choice("damper", "the damper feels", &["the whole velocity", "the radius only"]),
        Control::slider("board", r"friction on board, $\Gamma_i/\omega_0$", [0.0, 0.5, 0.01], "", 0.0),
        Control::choice("motor", "the drum", &["keeps its spin", "speeds up from rest", "has a weak motor"]),
        Control::slider("torque", "torque of the weak motor", [0.1, 12.0, 0.1], "N·m", 6.0)
            .when("motor", [2.0, 2.0]),
        Control::kept("phase"),
    ],
    presets: &[
        preset("slow", &[("spin", 5.0)]),
        preset("resonance", &[("spin", 10.0)]),
        preset("quietest", &[("spin", 24.9)]),
        preset("from rest to full spin", &[("spin", 32.0), ("motor", 1.0)]),
        preset(
            "a kick, seen on the drum",
            &[("spin", 22.0), ("damping", 0.2), ("camera", 1.0), ("kick", 0.5)],
        ),
        preset(
            "the same kick, two dampers",
            &[("spin", 22.0), ("damper", 1.0), ("kick", 0.5), ("kept", 1.0), ("kept.damper", 0.0)],
        ),
        preset(
            "a whirl: friction on board",
            &[("spin", 40.0), ("damping", 0.2), ("board", 0.15), ("kick", 0.5)],
        ),
        preset("a weak motor, caught", &[("spin", 40.0), ("damping", 0.15), ("motor", 2.0), ("torque", 4.5)]),
        preset("and through", &[("spin", 40.0), ("damping", 0.15), ("motor", 2.0), ("torque", 6.0)]),
    ],
    readings: &[
        reading("turns a minute", Form::Fixed(0), ""),
        reading("lead of the load", Form::Fixed(0), "°"),
        reading("shaft from $O$", Form::Fixed(1), "mm"),
        reading("centre of mass from $O$", Form::Fixed(1), "mm"),
        reading("force on the floor", Form::Fixed(0), "N"),
        reading("drift of the momentum balance", Form::Power(1), "N·s"),
    ],
    symbols: formulas![r"\Omega", r"\phi_0", r"O", r"F", r"\omega_0", r"\boldsymbol{F}"],
    start: |settings| Ok(Box::new(Washer::new(settings)?)),
};

/// The largest spin of the slider and the plots, rad/s.
const MOST_SPIN: f64 = 60.0;
/// How fast the drum speeds up, rad/s²; how long a motion goes on at its last spin, s, and how long with a weak motor.
const ACCELERATION: f64 = 2.5;
const LASTS: f64 = 8.0;
const WEAK_LASTS: f64 = 25.0;
/// The drum's own moment of inertia, kg·m², which a weak motor feels.
pub(super) const DRUM_INERTIA: f64 = 0.5;
/// The largest change of the shaft's velocity in a kick, m/s.
const MOST_PUSH: f64 = 0.8;
/// The times of a kick that has been given.
const KICKED: [f64; 2] = [0.0, 1e9];
/// Where the tub strikes its housing: the largest distance of the shaft from O, in units of b.
const LARGEST_SWING: f64 = 12.0;
/// What passes in a turn: the load and seven holes.
const PASSING: f64 = 8.0;

const SPIN_AXIS: Axis<'_> = Axis::linear(0.0, MOST_SPIN, 10.0).titled(r"spin $\Omega$, rad/s");
const FORCE_AXIS: Axis<'_> = Axis::linear(0.0, 400.0, 100.0).titled("force on the floor, N");
const LEAD_AXIS: Axis<'_> = Axis::linear(-45.0, 225.0, 90.0).titled(r"lead $\phi_0$, °");

/// The places and weights of Gauss's rule with six points, on the interval from 0 to 1.
const GAUSS: [(f64, f64); 6] = [
    (0.033_765_242_898_423_97, 0.085_662_246_189_585_17),
    (0.169_395_306_766_867_76, 0.180_380_786_524_069_3),
    (0.380_690_406_958_401_56, 0.233_956_967_286_345_52),
    (0.619_309_593_041_598_5, 0.233_956_967_286_345_52),
    (0.830_604_693_233_132_2, 0.180_380_786_524_069_3),
    (0.966_234_757_101_576, 0.085_662_246_189_585_17),
];

/// The chapter's machine at rest, with so much damping in units of ω₀.
pub(super) fn machine(damping: f64) -> Result<Machine, InvalidQuantity> {
    Machine::new(MachineParameters {
        drum_mass: 28.0,
        load_mass: 2.0,
        load_radius: 0.25,
        stiffness: 3000.0,
        damping: damping * 300.0,
        spin: 0.0,
    })
}

/// Points of a curve, (x, y).
type Values = Vec<(f64, f64)>;

/// The steady motion of a machine; none at resonance without damping on the circle.
fn steady(machine: &Machine, is_radial: bool) -> Option<SteadyMotion> {
    let damping = if is_radial { 0.0 } else { machine.parameters().damping };
    machine.with_damping(damping).and_then(|machine| machine.steady()).ok()
}

/// The steady force on the floor, N, and the lead of the load, °, over the spin.
fn over_spin(still: &Machine, is_radial: bool) -> (Values, Values) {
    // Closer together about the resonance.
    let spins = (0..=140).map(f64::from).map(|n| if n < 100.0 { 0.2 * n } else { n - 80.0 });
    let values = spins.map(|spin| {
        let found = still.with_spin(spin).ok().and_then(|machine| steady(&machine, is_radial));
        let force = |radius: f64| still.total_mass() * spin * spin * radius;
        let values = found.map(|steady| (force(steady.centre_of_mass_radius()), steady.phase().to_degrees()));
        let (force, lead) = values.unwrap_or((f64::NAN, f64::NAN));
        ((spin, force), (spin, lead))
    });
    values.unzip()
}

/// The drum in its suspension, for some settings.
struct Washer {
    course: Course,
    /// What is kept to compare, with its steady force on the floor over the spin.
    kept: Option<(Course, Values)>,
    on_drum: bool,
    /// The steady force on the floor and the lead over the spin.
    forces: Values,
    leads: Values,
    quietest: Option<(f64, f64)>,
    /// The steady points on the plot of forces, inside it, whatever the force.
    steady: Values,
    words: String,
}

/// How the shaft moves for some settings.
fn course(settings: &Settings<'_>) -> Result<Course, Cause> {
    let still = machine(settings.of("damping")?)?;
    let is_radial = settings.choice("damper")? == 1;
    let drive = match settings.choice("motor")? {
        0 => Drive::KeepsItsSpin,
        1 => Drive::SpeedsUp,
        _ => Drive::WeakMotor(settings.of("torque")?),
    };
    let on_board = settings.of("board")? * 300.0;
    let kick = |[time, push, way]: Press| (time, Complex::from_polar(push, way.to_radians()));
    let kicks = settings.presses("kick")?.into_iter().map(kick).collect();
    let phase = settings.of("phase")?;
    Course::new(still, on_board, settings.of("spin")?, is_radial, drive, (phase, kicks))
}

impl Washer {
    fn new(settings: &Settings<'_>) -> Result<Self, Cause> {
        let (course, on_drum) = (course(settings)?, settings.choice("camera")? == 1);
        let (still, is_radial) = (course.still, course.is_radial);
        let kept = settings.kept(|settings| {
            let course = self::course(settings)?;
            let (forces, _) = over_spin(&course.still, course.is_radial);
            Ok((course, forces))
        });
        let (forces, leads) = over_spin(&still, is_radial);
        let quietest = forces.windows(3).find(|at| at[0].0 > 12.0 && at[1].1 < at[0].1 && at[1].1 <= at[2].1);
        let quietest = quietest.map(|at| at[1]);
        let words = answer::answer(&course, quietest);
        let spins = course.driven.map_or_else(|| vec![course.machine.spin()], |driven| driven.steady_spins());
        let force = |spin: f64| {
            let steady = steady(&still.with_spin(spin).ok()?, is_radial)?;
            Some(still.total_mass() * spin * spin * steady.centre_of_mass_radius())
        };
        let point = |spin: f64| (spin, force(spin).unwrap_or(f64::INFINITY).min(FORCE_AXIS.scale.to));
        let steady = spins.into_iter().map(point).collect();
        Ok(Self { course, kept, on_drum, forces, leads, quietest, steady, words })
    }

    /// The largest distance of the shaft from O, m.
    fn widest(&self) -> f64 {
        let own = self.course.widest.1;
        self.kept.as_ref().map_or(own, |(kept, _)| own.max(kept.widest.1))
    }

    /// The drum in a state, as it is looked at.
    fn drum<'a>(&'a self, state: &'a State, moment: &Moment) -> Result<Drum<'a>, Cause> {
        Drum::new(&self.course, state, self.on_drum, self.widest(), moment)
    }

    /// What a hand does to the tub, which it kicks as hard as would have a drum that stands still swing out as far as the hand
    /// has drawn it, or else to the load, with which it turns the drum.
    fn pull(&self, is_load: bool, to: Point, moment: &Moment) -> Result<Vec<(&'static str, f64)>, Cause> {
        let (state, natural) = (self.course.at(moment.time)?, self.course.machine.natural_frequency());
        let drum = self.drum(&state, moment)?;
        if is_load {
            return Ok(vec![("phase", self.course.phase + drum.turned(to))]);
        }
        let (push, way) = (drum.pulled(to) * natural).to_polar();
        Ok(vec![("kick", moment.time), ("push", push), ("way", way.to_degrees())])
    }

    /// The plots of force, lead and swing.
    fn plots(&self, room: Room) -> [Plot<'static>; 3] {
        let [force, lead, swing] = room
            .of(
                [[438.0, 40.0, 188.0, 112.0], [438.0, 186.0, 188.0, 58.0], [438.0, 326.0, 188.0, 66.0]],
                [[46.0, 366.0, 190.0, 84.0], [46.0, 484.0, 190.0, 48.0], [284.0, 366.0, 86.0, 166.0]],
            )
            .map(|[left, top, width, height]| Rect::new(left, top, width, height));
        let end = self.course.end;
        let most = 100.0 * self.widest().max(0.02) * 1.25;
        let step = match most {
            12.0.. => 10.0,
            5.0.. => 5.0,
            _ => 2.0,
        };
        let time = Axis::linear(0.0, end, if end > 12.0 { 5.0 } else { 2.0 }).titled("time, s");
        let shaft = Axis::linear(0.0, most, step).titled(r"shaft from $O$, cm");
        [
            Plot { frame: force, x: SPIN_AXIS.unlabelled().titled(""), y: FORCE_AXIS },
            Plot { frame: lead, x: SPIN_AXIS, y: LEAD_AXIS },
            Plot { frame: swing, x: time, y: shaft },
        ]
    }

    /// Where the spin can be taken hold of, on the plot of forces: that at which a weak motor idles is not one of the
    /// machine.
    fn handle(&self) -> (f64, f64) {
        if self.course.driven.is_some() { (self.course.machine.spin(), 0.0) } else { self.steady[0] }
    }

    /// The numbers of the moment.
    fn draw_names(&self, state: &State, drawing: &mut Drawing) -> Result<(), Cause> {
        let force = self.course.force(state).norm();
        let lead = state.lead().to_degrees().round() + 0.0;
        let numbers = [
            (r"$\Omega$", state.spin, 1, " rad/s", Hue::Orange),
            (r"$F$", force, 0, " N", Hue::Purple),
            (r"$\phi_0$", lead, 0, "°", Hue::Ink),
        ];
        let mut place = at(8.0, 16.0);
        for (name, value, digits, unit, hue) in numbers {
            if value.is_finite() {
                let text = format!("{name} = {value:.digits$}{unit}").replace('-', "−");
                drawing.label(place, Side::Right, &text, hue)?;
            }
            place = place + at(0.0, 20.0);
        }
        if self.on_drum {
            drawing.label(place + at(0.0, 2.0), Side::Right, "seen on", Hue::Muted)?;
            drawing.label(place + at(0.0, 20.0), Side::Right, "the drum", Hue::Muted)?;
        }
        Ok(())
    }

    /// What the marks of the picture mean.
    fn draw_key(room: Room, drawing: &mut Drawing) -> Result<(), Cause> {
        let bottom = room.of(at(10.0, 424.0), at(10.0, 324.0));
        let mass = bottom + at(66.0, 0.0);
        kit::marker(drawing, bottom, Marker::Ring, Hue::Ink);
        drawing.label(bottom + at(4.0, 0.0), Side::Right, "shaft", Hue::Ink)?;
        kit::marker(drawing, mass, Marker::Mass, Hue::Ink);
        drawing.label(mass + at(4.0, 0.0), Side::Right, "centre of mass", Hue::Ink)?;
        let scale = bottom + at(186.0, 0.0);
        let text = room.of("swings drawn 5 times as large", "swings 5 times as large");
        drawing.label(scale, Side::Right, text, Hue::Muted)?;
        Ok(())
    }

    /// The plots: force and lead over the spin, and the swing over the time.
    fn draw_plots(&self, room: Room, drawing: &mut Drawing) -> Result<(), Cause> {
        let (course, [force, lead, swing]) = (&self.course, self.plots(room));
        let natural = course.machine.natural_frequency();
        let mut plot = force.on(drawing)?;
        plot.upright(natural, Stroke::Dotted, Hue::Muted);
        plot.label((natural, 350.0), Side::Left, r"$\omega_0$", Hue::Muted)?;
        plot.label((28.0, 380.0), Side::Right, "rigid bearings", Hue::Muted)?;
        let unbalance = course.machine.total_mass() * course.machine.offset();
        let rigid = (0..=60).map(|n| (f64::from(n), unbalance * f64::from(n * n)));
        plot.curve(rigid, Stroke::Reference, Hue::Muted);
        if let Some((_, forces)) = &self.kept {
            plot.curve(forces.iter().copied(), Stroke::Pale, Hue::Purple);
        }
        plot.curve(self.forces.iter().copied(), Stroke::Curve, Hue::Purple);
        if let Some((spin, force)) = self.quietest {
            plot.curve([(spin, force), (spin, 170.0)], Stroke::Dotted, Hue::Muted);
            let (place, side) =
                if spin < 40.0 { (spin - 2.5, Side::Right) } else { (spin + 2.5, Side::Left) };
            plot.label((place, 185.0), side, "quietest", Hue::Muted)?;
        }
        for &steady in self.steady.iter().filter(|_| course.driven.is_some()) {
            let ring = plot.at(steady);
            plot.drawing().circle(ring, 5.0, Role::Line(Stroke::Outline, Hue::Purple));
        }

        let mut plot = lead.on(drawing)?;
        plot.upright(natural, Stroke::Dotted, Hue::Muted);
        plot.answer(|plot| {
            plot.curve(self.leads.iter().copied(), Stroke::Curve, Hue::Blue);
            Ok(())
        })?;

        let mut plot = swing.on(drawing)?;
        if let Some((kept, _)) = &self.kept {
            let swings = kept.swings.iter().step_by(1 + kept.swings.len() / 800);
            plot.curve(swings.map(|(t, r)| (*t, 100.0 * r)), Stroke::Pale, Hue::Blue);
        }
        let swings = course.swings.iter().step_by(1 + course.swings.len() / 800);
        plot.curve(swings.map(|(t, r)| (*t, 100.0 * r)), Stroke::Outline, Hue::Blue);
        for (kick, _) in course.kicks.iter().filter(|kick| kick.0 < course.end) {
            plot.upright(*kick, Stroke::Outline, Hue::Pink);
        }
        Ok(())
    }

    /// Where the motion is on the plots, and what can be held there.
    fn draw_places(&self, moment: &Moment, state: &State, drawing: &mut Drawing) {
        let (course, [force, lead, swing]) = (&self.course, self.plots(moment.room));
        let mut plot = force.over(drawing);
        plot.dot((state.spin, course.force(state).norm()), 4.5, Hue::Purple);
        plot.grip(self.handle(), if course.driven.is_some() { Hue::Orange } else { Hue::Purple });
        lead.over(drawing).dot((state.spin, state.lead().to_degrees()), 4.5, Hue::Blue);
        let mut plot = swing.over(drawing);
        if let Some((kick, _)) = course.kicks.last().filter(|kick| kick.0 < course.end) {
            plot.grip((*kick, 0.0), Hue::Pink);
        }
        plot.dot((moment.time, 100.0 * state.shaft.position.norm()), 4.5, Hue::Blue);
    }
}

impl Motion for Washer {
    fn run(&self) -> Run {
        Run { duration: self.course.end, pace: if self.course.speeds_up { 1.0 } else { 0.15 }, repeats: true }
    }

    fn draw_behind(&self, room: Room, drawing: &mut Drawing) -> Result<(), Cause> {
        Self::draw_key(room, drawing)?;
        self.draw_plots(room, drawing)
    }

    fn draw(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let state = self.course.at(moment.time)?;
        let drum = self.drum(&state, moment)?;
        drum.draw(drawing)?;
        if let Some((kept, _)) = &self.kept {
            drum.draw_kept(&kept.at(moment.time)?, drawing);
        }
        self.draw_names(&state, drawing)?;
        self.draw_places(moment, &state, drawing);
        Ok(())
    }

    /// The spin on the plot of forces, and the kick on that of swings.
    fn grips(&self, moment: &Moment) -> Vec<Point> {
        let [force, _, swing] = self.plots(moment.room);
        let mut grips = vec![force.point(self.handle())];
        let last = self.course.kicks.last().filter(|kick| kick.0 < self.course.end);
        grips.extend(last.map(|kick| swing.point((kick.0, 0.0))));
        grips
    }

    /// The tub and the load.
    fn bodies(&self, moment: &Moment) -> Vec<(Point, f64)> {
        let state = self.course.at(moment.time);
        state.and_then(|state| Ok(self.drum(&state, moment)?.bodies())).unwrap_or_default()
    }

    fn drag(&self, grip: usize, to: Point, moment: &Moment) -> Vec<(&'static str, f64)> {
        let ([force, _, swing], grips) = (self.plots(moment.room), self.grips(moment));
        let mut places = grips.iter().copied().chain(self.bodies(moment).into_iter().map(|body| body.0));
        let moved =
            |from: Point| if grip < grips.len() { (to.x - from.x).abs() } else { (to - from).length() };
        match places.nth(grip) {
            Some(from) if moved(from) >= 0.25 => (),
            _ => return Vec::new(), // a touch
        }
        if grip >= grips.len() {
            return self.pull(grip > grips.len(), to, moment).unwrap_or_default();
        }
        if grip == 0 {
            return vec![("spin", force.value(to).0)];
        }
        let before = self.course.kicks.iter().rev().nth(1).map_or(0.0, |kick| kick.0);
        vec![("kick", swing.value(to).0.min(self.course.end - 0.1).max(before))]
    }

    fn readings(&self, time: f64) -> Result<Vec<f64>, Cause> {
        let time = time.min(self.course.end);
        let state = self.course.at(time)?;
        let mass = state.shaft.position + state.load() * self.course.machine.offset();
        Ok(vec![
            state.spin * 60.0 / TAU,
            state.lead().to_degrees(),
            1e3 * state.shaft.position.norm(),
            1e3 * mass.norm(),
            self.course.force(&state).norm(),
            self.course.imbalance(time)?,
        ])
    }

    /// Never from below the floor.
    fn lowest_eye(&self) -> f64 {
        10_f64.to_radians()
    }

    /// The hum of the drum, in which the load and seven holes pass eight times a turn: as loud as the force on the floor.
    fn sound(&self, time: f64) -> Option<Sound> {
        let state = self.course.at(time).ok()?;
        let loudness = self.course.force(&state).norm() / FORCE_AXIS.scale.to;
        Some(Sound { frequency: PASSING * state.spin / TAU, loudness })
    }

    /// The drum does not leap when its spin is changed.
    fn kept(&self, time: f64) -> Result<Vec<(&'static str, f64)>, Cause> {
        let is_kept = !self.course.speeds_up; // from rest every spin is reached on another way
        Ok(if is_kept { vec![("phase", self.course.at(time)?.azimuth)] } else { Vec::new() })
    }

    fn words(&self, _time: f64) -> String {
        self.words.clone()
    }
}
