//! The scene of the chapter "Physics in the laundromat": a drum with its load, seen from above.

use crate::{
    Axis, Cause, Control, Form, Graph, Moment, Motion, Preset, Reading, Room, Run, Scene, Settings, value_at,
};
use drawing::kit::{self, Marker};
use drawing::space::{Camera, SpaceError, View};
use drawing::{Drawing, Fill, Hue, Point, Rect, Side, Stroke, at};
use mechanics::integrate::{Dop853, rk4_step};
use mechanics::scenes::laundromat::{Machine, Parameters, Ramp, Shaft, SteadyMotion, Transient};
use nalgebra::{Complex, Matrix4};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

pub(crate) const SCENE: Scene = Scene {
    name: "laundromat",
    title: "A drum with its load, from above",
    description: "Seen from above at a slant: a tub between four posts, held by a spring and a damper at each, and \
                  in it a drum with a heavy mat on one side. The drum turns at its natural frequency. The shaft \
                  stands to one side of the fixed point O, and the load leads it by a quarter turn. Beside it three \
                  plots: the force on the floor against the spin, with a peak of 176 newtons at the natural \
                  frequency and its least at 25 radians a second; the lead of the load, from 0 to 180 degrees; and \
                  the distance of the shaft from O against time.",
    question: "Where does the load go while the spin $\\Omega$ passes $\\omega_0$? At which spin is the floor quietest? \
               And why does a kick die with one damper and grow with the other?",
    size: [[640.0, 440.0], [380.0, 864.0]],
    view: Some([-FRAC_PI_2, 1.0]),
    still: 0.62,
    controls: &[
        Control::slider("spin", r"spin, $\Omega$", [0.0, MOST_SPIN, 0.1], "rad/s", 10.0),
        Control::slider("damping", r"damping, $\Gamma/\omega_0$", [0.0, 2.5, 0.01], "", 0.3),
        Control::choice("damper", "the damper feels", &["the whole velocity", "the radius only"]),
        Control::choice("motor", "the drum", &["keeps its spin", "speeds up from rest"]),
        Control::choice("camera", "seen", &["in the room", "on the drum"]),
        Control::button("kick", "Kick"),
    ],
    presets: &[
        Preset { words: "slow", settings: &[("spin", 5.0)] },
        Preset { words: "resonance", settings: &[("spin", 10.0)] },
        Preset { words: "quietest", settings: &[("spin", 24.9)] },
        Preset { words: "from rest to full spin", settings: &[("spin", 32.0), ("motor", 1.0)] },
        Preset {
            words: "a kick, seen on the drum",
            settings: &[("spin", 22.0), ("damping", 0.2), ("camera", 1.0), ("kick", 0.5)],
        },
        Preset {
            words: "a kick with the other damper",
            settings: &[("spin", 22.0), ("damper", 1.0), ("kick", 0.5)],
        },
    ],
    readings: &[
        Reading { words: "turns a minute", form: Form::Fixed(0), unit: "" },
        Reading { words: "lead of the load", form: Form::Fixed(0), unit: "°" },
        Reading { words: "shaft from $O$", form: Form::Fixed(1), unit: "mm" },
        Reading { words: "centre of mass from $O$", form: Form::Fixed(1), unit: "mm" },
        Reading { words: "force on the floor", form: Form::Fixed(0), unit: "N" },
        Reading { words: "momentum, less what floor and kick gave", form: Form::Power(1), unit: "N s" },
    ],
    symbols: crate::symbols::LAUNDROMAT,
    start: |settings| Ok(Box::new(Washer::new(settings)?)),
};

/// The largest spin of the slider and the plots, rad/s, and the largest force of the plot, N.
const MOST_SPIN: f64 = 60.0;
const MOST_FORCE: f64 = 400.0;
/// How fast the drum speeds up, rad/s²; how long a motion goes on at its last spin, s.
const ACCELERATION: f64 = 2.5;
const LASTS: f64 = 8.0;
/// The change of the shaft's velocity in a kick, m/s, along x.
const KICK: Complex<f64> = Complex::new(0.4, 0.0);
/// Where the tub strikes its housing: the largest distance of the shaft from O, in units of b.
const LARGEST_SWING: f64 = 12.0;

/// The picture's unit is the radius of the drum. In it, the place of the load, and the length of a metre of swing: five
/// times that of a metre of the drum.
const LOAD: f64 = 0.82;
const METRE: f64 = 5.0 * LOAD / 0.25;
/// The length of a newton in it.
const FORCE: f64 = 0.01;
/// The outer radius of the tub; the heights of its upper rim, of springs, and of the floor.
const TUB: f64 = 1.17;
const RIM: f64 = 0.02;
const MOUNT: f64 = -0.25;
const FLOOR: f64 = -0.55;

/// Points of a curve, (x, y).
type Values = Vec<(f64, f64)>;

/// How the shaft moves through a part of the motion, in a frame in which the load starts at azimuth zero.
enum Way {
    Steady(Transient),
    Ramp(Box<Ramp>),
    /// With the damper that feels only the radius there is no closed form: states at equal steps.
    Stepped {
        machine: Machine,
        step: f64,
        states: Vec<[f64; 4]>,
    },
}

/// A part of the motion: from a time on, with the drum at an azimuth, a spin and an angular acceleration.
struct Part {
    from: f64,
    azimuth: f64,
    spin: f64,
    acceleration: f64,
    way: Way,
}

/// The machine at a time: its shaft, the azimuth of the load and the spin of the drum.
struct State {
    shaft: Shaft,
    azimuth: f64,
    spin: f64,
}

/// Rates of a shaft whose damper feels only the radius, while the drum speeds up (`eq:ramp-equation`): those for the
/// whole velocity, with the one damper in the place of the other.
fn radial_rates(machine: &Machine, acceleration: f64, time: f64, state: &[f64; 4]) -> [f64; 4] {
    let radial = machine.radial_damping_rates(time, state);
    if acceleration == 0.0 {
        return radial;
    }
    let (whole, ramp) = (machine.cartesian_rates(time, state), machine.ramp_rates(acceleration, time, state));
    [radial[0], radial[1], ramp[2] + (radial[2] - whole[2]), ramp[3] + (radial[3] - whole[3])]
}

impl Part {
    fn new(
        machine: Machine,
        is_radial: bool,
        before: &State,
        acceleration: f64,
        span: [f64; 2],
    ) -> Result<Self, Cause> {
        let State { shaft, azimuth, spin } = *before;
        let machine = machine.with_spin(spin)?;
        let back = Complex::from_polar(1.0, -azimuth);
        let start = Shaft { position: shaft.position * back, velocity: shaft.velocity * back };
        let way = if is_radial {
            let length = span[1] - span[0];
            let fastest = (spin + acceleration * length).max(machine.natural_frequency());
            let steps = (length * fastest / 0.1).ceil().max(1.0);
            let times: Vec<f64> = (0..=steps as u32).map(|n| length * f64::from(n) / steps).collect();
            let rates = |t: f64, state: &[f64; 4]| radial_rates(&machine, acceleration, t, state);
            let (states, _) =
                Dop853::with_tolerances(1e-8, 1e-9)?.sample(rates, 0.0, start.to_array(), &times)?;
            Way::Stepped { machine, step: length / steps, states }
        } else if acceleration == 0.0 {
            Way::Steady(machine.transient(start)?)
        } else {
            Way::Ramp(Box::new(machine.ramp(acceleration, start)?))
        };
        Ok(Self { from: span[0], azimuth, spin, acceleration, way })
    }

    fn at(&self, time: f64) -> Result<State, Cause> {
        let since = time - self.from;
        let shaft = match &self.way {
            Way::Steady(motion) => motion.at(since)?,
            Way::Ramp(motion) => motion.at(since)?,
            Way::Stepped { machine, step, states } => {
                let index = ((since / step) as usize).min(states.len() - 1);
                let begun = *step * index as f64;
                let mut rates = |t: f64, state: &[f64; 4]| radial_rates(machine, self.acceleration, t, state);
                Shaft::from_array(rk4_step(&mut rates, begun, &states[index], since - begun))
            }
        };
        let azimuth = self.azimuth + (self.spin + 0.5 * self.acceleration * since) * since;
        let turned = Complex::from_polar(1.0, self.azimuth);
        let shaft = Shaft { position: shaft.position * turned, velocity: shaft.velocity * turned };
        Ok(State { shaft, azimuth, spin: self.spin + self.acceleration * since })
    }
}

impl State {
    /// The direction from the shaft to the load.
    fn load(&self) -> Complex<f64> {
        Complex::from_polar(1.0, self.azimuth)
    }

    /// The angle by which the load leads the shaft, from −π/2 to 3π/2; none with the shaft at O.
    fn lead(&self) -> f64 {
        let position = self.shaft.position;
        if position.norm() < 1e-9 {
            return f64::NAN;
        }
        let lead = (self.load() * position.conj()).arg();
        if lead < -FRAC_PI_2 { lead + TAU } else { lead }
    }
}

/// The drum in its suspension, for some settings.
struct Washer {
    machine: Machine,
    /// The same machine while its drum does not turn.
    still: Machine,
    is_radial: bool,
    on_drum: bool,
    kick: Option<f64>,
    parts: Vec<Part>,
    /// When the motion ends, s, and whether it does because the tub strikes its housing.
    end: f64,
    strikes: bool,
    /// Times, and what the floor has been given until then, N s.
    given: Vec<(f64, Complex<f64>)>,
    /// Times, and how far the shaft is from O, m; the time and size of the largest distance.
    swings: Values,
    widest: (f64, f64),
    /// The steady force on the floor and the lead over the spin.
    forces: Values,
    leads: Values,
    quietest: Option<(f64, f64)>,
    words: String,
}

/// The places and weights of Gauss's rule with six points, on the interval from 0 to 1.
const GAUSS: [(f64, f64); 6] = [
    (0.033_765_242_898_423_97, 0.085_662_246_189_585_17),
    (0.169_395_306_766_867_76, 0.180_380_786_524_069_3),
    (0.380_690_406_958_401_56, 0.233_956_967_286_345_52),
    (0.619_309_593_041_598_5, 0.233_956_967_286_345_52),
    (0.830_604_693_233_132_2, 0.180_380_786_524_069_3),
    (0.966_234_757_101_576, 0.085_662_246_189_585_17),
];

impl Washer {
    fn new(settings: &Settings<'_>) -> Result<Self, Cause> {
        let spin = settings.of("spin")?;
        let still = Machine::new(Parameters {
            drum_mass: 28.0,
            load_mass: 2.0,
            load_radius: 0.25,
            stiffness: 3000.0,
            damping: settings.of("damping")? * 300.0,
            spin: 0.0,
        })?;
        let (machine, is_radial) = (still.with_spin(spin)?, settings.choice("damper")? == 1);
        let run_up = if settings.choice("motor")? == 1 { spin / ACCELERATION } else { 0.0 };
        let end = run_up + LASTS;
        let kick = settings.pressed("kick")?.filter(|time| *time < end);
        let (forces, leads) = over_spin(&still, is_radial);
        let quietest = forces.windows(3).find(|at| at[0].0 > 12.0 && at[1].1 < at[0].1 && at[1].1 <= at[2].1);
        let mut washer = Self {
            quietest: quietest.map(|at| at[1]),
            on_drum: settings.choice("camera")? == 1,
            parts: Vec::new(),
            given: Vec::new(),
            swings: Vec::new(),
            widest: (0.0, 0.0),
            strikes: false,
            words: String::new(),
            machine,
            still,
            is_radial,
            kick,
            end,
            forces,
            leads,
        };
        washer.move_on(run_up)?;
        washer.keep_book()?;
        washer.words = washer.answer(run_up);
        Ok(washer)
    }

    /// The steady motion, with the damper that is fitted: none, on a circle, if it feels only the radius.
    fn steady(&self) -> Option<SteadyMotion> {
        steady(&self.machine, self.is_radial)
    }

    /// Computes the motion: from rest if the drum has to speed up or there is no steady motion in the housing, and from
    /// the steady motion otherwise.
    fn move_on(&mut self, run_up: f64) -> Result<(), Cause> {
        let largest = (LARGEST_SWING - 1.0) * self.machine.offset();
        let steady = self.steady().filter(|steady| run_up == 0.0 && steady.radius() < largest);
        let shaft = steady.map_or(Shaft::AT_REST, |steady| Shaft {
            position: steady.amplitude(),
            velocity: Complex::new(0.0, self.machine.spin()) * steady.amplitude(),
        });
        let mut cuts = vec![0.0, run_up, self.kick.unwrap_or(0.0)];
        cuts.sort_by(f64::total_cmp);
        cuts.dedup();
        let mut now =
            State { shaft, azimuth: 0.0, spin: if run_up > 0.0 { 0.0 } else { self.machine.spin() } };
        for (index, &from) in cuts.iter().enumerate() {
            if let Some(part) = self.parts.last() {
                now = part.at(from)?;
            }
            if self.kick == Some(from) {
                now.shaft.velocity += KICK;
            }
            let acceleration = if from < run_up { ACCELERATION } else { 0.0 };
            if from == run_up {
                now.spin = self.machine.spin();
            }
            let until = cuts.get(index + 1).copied().unwrap_or(self.end);
            self.parts.push(Part::new(self.machine, self.is_radial, &now, acceleration, [from, until])?);
        }
        Ok(())
    }

    /// Writes down how far the shaft swings and what the floor is given, until the tub strikes its housing.
    fn keep_book(&mut self) -> Result<(), Cause> {
        let mut given = Complex::new(0.0, 0.0);
        let ends: Vec<f64> = self.parts.iter().skip(1).map(|part| part.from).chain([self.end]).collect();
        'parts: for (part, until) in self.parts.iter().zip(ends) {
            let mut from = part.from;
            while from < until {
                // Two radians of drum and spring together: there Gauss's rule has eleven digits.
                let spin = part.spin + part.acceleration * (from - part.from);
                let mut to = until.min(from + 2.0 / (spin + self.machine.natural_frequency()));
                if self.is_radial {
                    // The force turns with the radius, and quickly as the shaft passes O.
                    let Shaft { position, velocity } = part.at(from)?.shaft;
                    to = to.min(from + (1.5 * position.norm() / velocity.norm().max(1e-9)).max(2e-3));
                }
                self.given.push((from, given));
                for (place, weight) in GAUSS {
                    let time = from + place * (to - from);
                    let shaft = part.at(time)?.shaft;
                    let distance = shaft.position.norm();
                    if distance > LARGEST_SWING * self.machine.offset() {
                        (self.end, self.strikes) = (time, true);
                        break 'parts;
                    }
                    if distance > self.widest.1 {
                        self.widest = (time, distance);
                    }
                    self.swings.push((time, distance));
                    given += self.force(&shaft) * (weight * (to - from));
                }
                from = to;
            }
        }
        Ok(())
    }

    /// What the floor has been given by a time, N s.
    fn given(&self, time: f64) -> Result<Complex<f64>, Cause> {
        let index = self.given.partition_point(|(from, _)| *from <= time).saturating_sub(1);
        let (from, mut given) = self.given[index];
        for (place, weight) in GAUSS {
            given += self.force(&self.at(from + place * (time - from))?.shaft) * (weight * (time - from));
        }
        Ok(given)
    }

    /// The momentum of tub, drum and load, N s: that of their mass at its centre.
    fn momentum(&self, state: &State) -> Complex<f64> {
        let turning = Complex::new(0.0, state.spin * self.machine.offset()) * state.load();
        (state.shaft.velocity + turning) * self.machine.total_mass()
    }

    fn at(&self, time: f64) -> Result<State, Cause> {
        let part = self.parts.iter().rev().find(|part| part.from <= time).unwrap_or(&self.parts[0]);
        part.at(time.min(self.end))
    }

    /// The force of springs and dampers on the floor, N: minus what they do to a drum that does not turn.
    fn force(&self, shaft: &Shaft) -> Complex<f64> {
        let rates = if self.is_radial { Machine::radial_damping_rates } else { Machine::cartesian_rates };
        let [_, _, x, y] = rates(&self.still, 0.0, &shaft.to_array());
        Complex::new(x, y) * -self.machine.total_mass()
    }
    /// The answer to the chapter's question for these settings.
    fn answer(&self, run_up: f64) -> String {
        let (machine, spin) = (&self.machine, self.machine.spin());
        let mut words = Vec::new();
        match self.steady() {
            _ if spin == 0.0 => words.push(format!(
                "The drum stands still: the shaft rests at O, the centre of mass {:.0} mm beside it, \
                 and the floor feels nothing.",
                1e3 * machine.offset()
            )),
            None => words.push(
                "At its natural frequency, with nothing to resist the way round, there is no steady motion: \
                 the swing grows at every turn."
                    .into(),
            ),
            Some(steady) => {
                let lead = steady.phase().to_degrees();
                let place = match lead {
                    ..85.0 => "on the outside",
                    ..95.0 => "a quarter turn ahead of the shaft",
                    _ => "on the inside",
                };
                let [shaft, mass] = [steady.radius(), steady.centre_of_mass_radius()];
                let force = mass * machine.total_mass() * spin * spin;
                let rigid = machine.total_mass() * machine.offset() * spin * spin;
                words.push(format!(
                    "At {spin:.1} rad/s the load is {place}, with a lead of {lead:.0}°: the shaft goes round O at {}, \
                     the centre of mass at {}.",
                    millimetres(shaft),
                    millimetres(mass)
                ));
                let quietest = self.quietest.map_or(String::new(), |(spin, force)| {
                    format!("; at {spin:.0} rad/s it would be quietest, with {force:.0} N")
                });
                words.push(format!(
                    "The floor feels {force:.0} N, where rigid bearings would give it {rigid:.0} N{quietest}."
                ));
            }
        }
        if run_up > 0.0 {
            let (time, distance) = self.widest;
            let spin = self.at(time).map_or(f64::NAN, |state| state.spin);
            words.push(format!(
                "On its way from rest it swings out furthest, {:.0} mm, at {spin:.1} rad/s.",
                1e3 * distance
            ));
        }
        if self.steady().is_some() {
            words.push(self.fate_of_a_kick());
        }
        if self.strikes {
            words.push(format!("After {:.1} s the tub strikes its housing, and the scene ends.", self.end));
        }
        words.join(" ")
    }

    /// Whether a kick dies out or grows, and how fast.
    fn fate_of_a_kick(&self) -> String {
        let rate = if self.is_radial {
            largest_rate(&self.machine.radial_damping_matrix())
        } else {
            let rates = self.machine.modes().map(|mode| mode.frequency.im);
            -rates.into_iter().fold(f64::INFINITY, f64::min)
        };
        let time = 1.0 / rate.abs();
        match rate {
            1e-3.. => format!("Unstable: with this damper a kick grows by a factor e in {time:.2} s."),
            ..-1e-3 => format!("Stable: a kick dies out by a factor e in {time:.2} s."),
            _ => "A kick neither dies out nor grows.".into(),
        }
    }
}

/// A length, m, in words.
fn millimetres(length: f64) -> String {
    let length = 1e3 * length;
    if length < 9.95 { format!("{length:.1} mm") } else { format!("{length:.0} mm") }
}

/// The largest real part of the eigenvalues of a matrix: the rate at which what grows fastest grows, from the size of
/// e^{At} after a very long time t, by squaring.
fn largest_rate(matrix: &Matrix4<f64>) -> f64 {
    let step = 0.5 / matrix.norm().max(1e-300);
    let (mut term, mut grown) = (Matrix4::identity(), Matrix4::identity());
    for n in 1..=16 {
        term = term * matrix * (step / f64::from(n));
        grown += term;
    }
    let (mut time, mut size) = (step, 0.0);
    for _ in 0..26 {
        grown = grown * grown;
        let norm = grown.norm();
        (time, size, grown) = (2.0 * time, 2.0 * size + norm.ln(), grown / norm);
    }
    size / time
}

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

/// Where the picture and its plots stand on the page.
struct Layout {
    /// The place of O and the reach of the floor, px.
    centre: Point,
    reach: f64,
    force: Rect,
    lead: Rect,
    swing: Rect,
}

impl Layout {
    fn new(room: Room) -> Self {
        match room {
            Room::Wide => Self {
                centre: at(196.0, 216.0),
                reach: 186.0,
                force: Rect::new(438.0, 40.0, 188.0, 112.0),
                lead: Rect::new(438.0, 186.0, 188.0, 58.0),
                swing: Rect::new(438.0, 326.0, 188.0, 66.0),
            },
            Room::Narrow => Self {
                centre: at(190.0, 204.0),
                reach: 178.0,
                force: Rect::new(52.0, 466.0, 312.0, 110.0),
                lead: Rect::new(52.0, 612.0, 312.0, 56.0),
                swing: Rect::new(52.0, 750.0, 312.0, 66.0),
            },
        }
    }
}

const SPIN_AXIS: [f64; 3] = [0.0, MOST_SPIN, 10.0];
const FORCE_AXIS: [f64; 3] = [0.0, MOST_FORCE, 100.0];

impl Washer {
    /// How far the posts stand from O, in radii of the drum: room for the widest swing and for springs.
    fn posts(&self) -> f64 {
        (TUB + 0.4 + self.widest.1 * METRE).max(2.5)
    }

    /// The azimuth of the eye: a rider's turns with the drum.
    fn eye(&self, moment: &Moment, state: &State) -> f64 {
        moment.azimuth + if self.on_drum { state.azimuth } else { 0.0 }
    }

    fn camera(&self, moment: &Moment, layout: &Layout, state: &State) -> Result<Camera, SpaceError> {
        let azimuth = self.eye(moment, state);
        let view = View {
            target: [0.0; 3],
            azimuth,
            elevation: moment.elevation,
            distance: 14.0,
            centre: layout.centre,
            scale: layout.reach / self.posts(),
        };
        Moment { azimuth, elevation: moment.elevation.max(0.2), ..*moment }.camera(view) // never from below the floor
    }

    fn time_axis(&self) -> Axis<'static> {
        Axis::linear([0.0, self.end, if self.end > 12.0 { 5.0 } else { 2.0 }], "time, s")
    }

    fn swing_axis(&self) -> Axis<'static> {
        let most = 100.0 * self.widest.1.max(0.02) * 1.25;
        let step = if most > 12.0 {
            10.0
        } else if most > 5.0 {
            5.0
        } else {
            2.0
        };
        Axis::linear([0.0, most, step], r"shaft from $O$, cm")
    }

    /// The steady point of the plot of forces: inside it, whatever the force.
    fn steady_force(&self) -> (f64, f64) {
        let spin = self.machine.spin();
        let radius = self.steady().map_or(f64::INFINITY, |steady| steady.centre_of_mass_radius());
        (spin, (self.machine.total_mass() * spin * spin * radius).min(MOST_FORCE))
    }

    fn draw_room(&self, camera: &Camera, drawing: &mut Drawing) -> Result<(), Cause> {
        let posts = self.posts();
        let floor = posts + 0.12;
        let rim = (0..72).map(|n| Complex::from_polar(floor, TAU * f64::from(n) / 72.0));
        let rim: Vec<Point> = rim.map(|z| camera.on_page([z.re, z.im, FLOOR])).collect::<Result<_, _>>()?;
        drawing.polygon(rim, Fill::Floor, Hue::Ink);
        let lines = (floor / 0.6) as i32;
        for n in -lines..=lines {
            let x = 0.6 * f64::from(n);
            let half = (floor * floor - x * x).sqrt();
            for ends in [[[x, -half, FLOOR], [x, half, FLOOR]], [[-half, x, FLOOR], [half, x, FLOOR]]] {
                drawing.line(camera.on_page(ends[0])?, camera.on_page(ends[1])?, Stroke::Grid, Hue::Ink);
            }
        }
        Ok(())
    }

    /// The posts, and between them and the tub springs and, if they resist the whole velocity, dampers.
    fn draw_suspension(
        &self,
        camera: &Camera,
        shaft: Complex<f64>,
        drawing: &mut Drawing,
    ) -> Result<(), Cause> {
        for side in 0..4 {
            let way = Complex::from_polar(1.0, FRAC_PI_4 + FRAC_PI_2 * f64::from(side));
            let post = way * self.posts();
            let [foot, head] = [FLOOR, MOUNT + 0.1].map(|z| camera.on_page([post.re, post.im, z]));
            let (foot, head) = (foot?, head?);
            drawing.dot(foot, 4.5, Hue::Muted);
            drawing.line(foot, head, Stroke::Curve, Hue::Ink);
            drawing.dot(head, 3.0, Hue::Ink);
            let wall = shaft + way * TUB;
            for (aside, is_spring) in [(0.13, true), (-0.13, false)] {
                let aside = way * Complex::new(0.0, aside);
                let ends = [post, wall].map(|z| z + aside);
                let [from, to] = ends.map(|z| camera.on_page([z.re, z.im, MOUNT]));
                let (from, to) = (from?, to?);
                let length = (to - from).length();
                if is_spring {
                    kit::spring(drawing, from, to, 5, 8.0, 0.06 * length, Hue::Ink);
                } else if !self.is_radial {
                    kit::damper(drawing, from, to, 0.42 * length, 8.0, Hue::Ink);
                }
            }
        }
        Ok(())
    }
}

/// Where a pair of values lies in a plot that is drawn in a frame with these axes.
fn place(frame: Rect, x: &Axis<'_>, y: &Axis<'_>, (at_x, at_y): (f64, f64)) -> Point {
    let part = |axis: &Axis<'_>, value: f64| (value - axis.from) / (axis.to - axis.from);
    at(frame.left + part(x, at_x) * frame.width(), frame.bottom - part(y, at_y) * frame.height())
}

impl Washer {
    /// The tub, with the drum in it, seen from an eye at an azimuth.
    fn draw_tub(
        &self,
        camera: &Camera,
        eye: f64,
        shaft: Complex<f64>,
        drawing: &mut Drawing,
    ) -> Result<(), Cause> {
        let [rim, foot] = [RIM, FLOOR + 0.1].map(|z| [shaft.re, shaft.im, z]);
        // The wall is seen between the near half of its foot and the far half of its rim.
        let mut wall = arc(camera, foot, TUB, eye - FRAC_PI_2, PI)?;
        wall.extend(arc(camera, rim, TUB, eye + FRAC_PI_2, PI)?);
        let faces = [
            (wall, Fill::Side, Hue::Muted),
            (arc(camera, rim, TUB, 0.0, TAU)?, Fill::Face, Hue::Muted),
            (arc(camera, rim, 1.07, 0.0, TAU)?, Fill::Side, Hue::Muted),
            (arc(camera, rim, 1.0, 0.0, TAU)?, Fill::Face, Hue::Blue),
        ];
        for (mut face, fill, hue) in faces {
            drawing.polygon(face.clone(), Fill::Page, hue);
            drawing.polygon(face.clone(), fill, hue);
            face.extend(face.first().copied());
            drawing.polyline(&face, Stroke::Outline, hue);
        }
        Ok(())
    }

    /// What lies on the drum: the load, the shaft's path and angle, the centre of mass, the force on the floor.
    fn draw_motion(
        &self,
        time: f64,
        state: &State,
        camera: &Camera,
        eye: f64,
        drawing: &mut Drawing,
    ) -> Result<(), Cause> {
        let land = |z: Complex<f64>| camera.on_page([z.re, z.im, RIM]);
        let arc = |centre: Complex<f64>, radius: f64, from: f64, sweep: f64| {
            arc(camera, [centre.re, centre.im, RIM], radius, from, sweep)
        };
        let (origin, shaft, load) = (Complex::new(0.0, 0.0), state.shaft.position * METRE, state.load());
        let mass = shaft + load * (self.machine.offset() * METRE);

        // The load, a mat on the rim of the drum, and holes by which one sees it turn.
        for hole in 1..8 {
            let hole = shaft + load * Complex::from_polar(LOAD, TAU * f64::from(hole) / 8.0);
            drawing.polygon(arc(hole, 0.05, 0.0, TAU)?, Fill::Side, Hue::Blue);
        }
        let mut mat = arc(shaft, 0.97, state.azimuth - 0.36, 0.72)?;
        mat.extend(arc(shaft, 0.67, state.azimuth + 0.36, -0.72)?);
        drawing.polygon(mat, Fill::Solid, Hue::Blue);

        // The steady circle, and the ways of shaft and centre of mass.
        if let Some(steady) = self.steady().filter(|_| self.parts.len() < 3) {
            let radius = steady.radius() * METRE;
            if radius > 0.05 && radius < self.posts() {
                drawing.polyline(&arc(origin, radius, 0.0, TAU)?, Stroke::Reference, Hue::Muted);
            }
        }
        let turns = if self.kick.is_some_and(|kick| kick < time) { 1.8 } else { 0.8 };
        let length =
            if self.on_drum { 2.0 } else { turns * TAU / state.spin.max(self.machine.natural_frequency()) };
        let steps = (length * state.spin.max(10.0) / 0.2).ceil();
        let (mut way, mut mass_way) = (Vec::new(), Vec::new());
        for n in 0..=steps as u32 {
            let then = time - length * (1.0 - f64::from(n) / steps);
            if then >= 0.0 {
                let then = self.at(then)?;
                let turned = if self.on_drum { load * then.load().conj() } else { Complex::new(1.0, 0.0) };
                way.push(land(then.shaft.position * METRE * turned)?);
                let mass = then.shaft.position + then.load() * self.machine.offset();
                mass_way.push(land(mass * METRE * turned)?);
            }
        }
        if !self.on_drum {
            drawing.polyline(&mass_way, Stroke::Orbit, Hue::Ink);
        }
        drawing.polyline(&way, Stroke::Vector, Hue::Blue);

        // From O through the shaft, and from the shaft to the load, which leads by an angle.
        let lead = state.lead();
        let radius = [land(origin)?, land(shaft)?];
        if self.is_radial && (radius[1] - radius[0]).length() > 30.0 {
            let length = 0.5 * (radius[1] - radius[0]).length();
            kit::damper(drawing, radius[0], radius[1], length, 9.0, Hue::Ink);
        }
        if shaft.norm() > 0.1 {
            let beyond = shaft * (1.0 + 0.62 / shaft.norm());
            drawing.line(land(origin)?, land(beyond)?, Stroke::Outline, Hue::Ink);
            let azimuth = shaft.arg();
            drawing.polyline(&arc(shaft, 0.42, azimuth, lead)?, Stroke::Outline, Hue::Ink);
            let name = land(shaft + Complex::from_polar(0.58, azimuth + 0.72 * lead))?;
            drawing.label(name, Side::Over, r"$\phi_0$", Hue::Ink)?;
        }
        drawing.line(land(shaft)?, land(shaft + load * 0.67)?, Stroke::Vector, Hue::Blue);
        let force = self.force(&state.shaft) * FORCE;
        let force = force * (0.94 * self.posts() / force.norm().max(1e-9)).min(1.0);
        if force.norm() > 0.05 {
            let tip = land(force)?;
            kit::arrow(drawing, land(origin)?, tip, Hue::Purple);
            let aside = (tip - land(origin)?).unit() * 12.0;
            drawing.label(tip + aside, Side::Over, r"$\boldsymbol{F}$", Hue::Purple)?;
        }
        kit::marker(drawing, land(mass)?, Marker::Mass, Hue::Ink);
        kit::marker(drawing, land(shaft)?, Marker::Ring, Hue::Ink);
        let (x, y) = (Complex::new(0.09, 0.0), Complex::new(0.0, 0.09));
        for arm in [x, y] {
            drawing.line(land(-arm)?, land(arm)?, Stroke::Curve, Hue::Ink);
        }
        drawing.label(land(origin)? + at(-10.0, 12.0), Side::Over, "$O$", Hue::Ink)?;

        // How the drum turns, outside the tub; and the kick, for a moment.
        if state.spin > 0.0 {
            let turn = arc(shaft, TUB + 0.13, eye + FRAC_PI_2 + 0.25, 0.5)?;
            if let [line @ .., neck, tip] = &turn[..] {
                drawing.polyline(line, Stroke::Vector, Hue::Orange);
                kit::head(drawing, *tip, *tip - *neck, 1.0, Hue::Orange);
            }
        }
        if self.kick.is_some_and(|kick| (kick..kick + 0.12).contains(&time)) {
            let wall = shaft - TUB;
            kit::arrow(drawing, land(wall - 0.8)?, land(wall)?, Hue::Pink);
            drawing.label(land(wall - 0.9)?, Side::Over, "kick", Hue::Pink)?;
        }
        Ok(())
    }

    /// The numbers of the moment, and what the marks mean.
    fn draw_names(&self, room: Room, state: &State, drawing: &mut Drawing) -> Result<(), Cause> {
        let corner = at(8.0, 16.0);
        let spin = format!("{} = {:.1} rad/s", r"$\Omega$", state.spin);
        let lead = format!("{} = {:.0}°", r"$\phi_0$", state.lead().to_degrees()).replace('-', "−");
        let force = format!("{} = {:.0} N", r"$F$", self.force(&state.shaft).norm());
        let lines = [(spin, Hue::Orange), (lead, Hue::Ink), (force, Hue::Purple)];
        for (line, (text, hue)) in lines.iter().filter(|(text, _)| !text.contains("NaN")).enumerate() {
            drawing.label(corner + at(0.0, 20.0 * line as f64), Side::Right, text, *hue)?;
        }
        if self.on_drum {
            drawing.label(corner + at(0.0, 62.0), Side::Right, "seen on", Hue::Muted)?;
            drawing.label(corner + at(0.0, 80.0), Side::Right, "the drum", Hue::Muted)?;
        }
        let bottom = room.of(at(10.0, 424.0), at(10.0, 402.0));
        kit::marker(drawing, bottom, Marker::Ring, Hue::Ink);
        drawing.label(bottom + at(4.0, 0.0), Side::Right, "shaft", Hue::Ink)?;
        kit::marker(drawing, bottom + at(66.0, 0.0), Marker::Mass, Hue::Ink);
        drawing.label(bottom + at(70.0, 0.0), Side::Right, "centre of mass", Hue::Ink)?;
        drawing.label(
            bottom + room.of(at(186.0, 0.0), at(-10.0, 21.0)),
            Side::Right,
            "swings drawn 5 times as large",
            Hue::Muted,
        )?;
        Ok(())
    }

    /// The plots: force and lead over the spin, and the swing over the time.
    fn draw_plots(
        &self,
        time: f64,
        state: &State,
        layout: &Layout,
        drawing: &mut Drawing,
    ) -> Result<(), Cause> {
        let natural = self.machine.natural_frequency();
        let spin = Axis::linear(SPIN_AXIS, "").unnumbered();
        let mut plot =
            Graph::new(drawing, layout.force, spin, Axis::linear(FORCE_AXIS, "force on the floor, N"))?;
        plot.upright(natural, Stroke::Dotted, Hue::Muted);
        plot.label((natural, 350.0), Side::Left, r"$\omega_0$", Hue::Muted)?;
        plot.label((28.0, 380.0), Side::Right, "rigid bearings", Hue::Muted)?;
        let unbalance = self.machine.total_mass() * self.machine.offset();
        let rigid = (0..=60).map(|n| (f64::from(n), unbalance * f64::from(n * n)));
        plot.curve(rigid, Stroke::Reference, Hue::Muted);
        plot.curve(self.forces.iter().copied(), Stroke::Curve, Hue::Purple);
        if let Some((spin, force)) = self.quietest {
            plot.curve([(spin, force), (spin, 170.0)], Stroke::Dotted, Hue::Muted);
            let (place, side) =
                if spin < 40.0 { (spin - 2.5, Side::Right) } else { (spin + 2.5, Side::Left) };
            plot.label((place, 185.0), side, "quietest", Hue::Muted)?;
        }
        let ring = plot.at(self.steady_force());
        kit::marker(plot.drawing(), ring, Marker::Ring, Hue::Ink);
        plot.dot((state.spin, self.force(&state.shaft).norm()), 4.5, Hue::Purple);

        let spin = Axis::linear(SPIN_AXIS, r"spin $\Omega$, rad/s");
        let mut plot =
            Graph::new(drawing, layout.lead, spin, Axis::linear([-45.0, 225.0, 90.0], r"lead $\phi_0$, °"))?;
        plot.upright(natural, Stroke::Dotted, Hue::Muted);
        plot.curve(self.leads.iter().copied(), Stroke::Curve, Hue::Blue);
        plot.dot((state.spin, state.lead().to_degrees()), 4.5, Hue::Blue);

        let mut plot = Graph::new(drawing, layout.swing, self.time_axis(), self.swing_axis())?;
        let swings = self.swings.iter().step_by(1 + self.swings.len() / 800);
        plot.curve(swings.map(|(t, r)| (*t, 100.0 * r)), Stroke::Outline, Hue::Blue);
        if let Some(kick) = self.kick.filter(|kick| *kick < self.end) {
            plot.upright(kick, Stroke::Outline, Hue::Pink);
            plot.dot((kick, 0.0), 4.5, Hue::Pink);
        }
        plot.dot((time, 100.0 * state.shaft.position.norm()), 4.5, Hue::Blue);
        Ok(())
    }
}

/// The points of an arc on the page, closer together on a large one: a circle of the world, level, at a height.
fn arc(
    camera: &Camera,
    centre: [f64; 3],
    radius: f64,
    from: f64,
    sweep: f64,
) -> Result<Vec<Point>, SpaceError> {
    let [x, y, z] = centre;
    let count = (2.0 + 8.0 * sweep.abs() * radius.sqrt()).ceil();
    let point = |n: u32| {
        let way = Complex::from_polar(radius, from + sweep * f64::from(n) / count);
        camera.on_page([x + way.re, y + way.im, z])
    };
    (0..=count as u32).map(point).collect()
}

impl Motion for Washer {
    fn run(&self) -> Run {
        let pace = if self.parts[0].acceleration > 0.0 { 1.0 } else { 0.15 };
        Run { duration: self.end, pace, repeats: true }
    }

    fn draw(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let state = self.at(moment.time)?;
        let layout = Layout::new(moment.room);
        let camera = self.camera(moment, &layout, &state)?;
        let shaft = state.shaft.position * METRE;
        self.draw_room(&camera, drawing)?;
        self.draw_suspension(&camera, shaft, drawing)?;
        let eye = self.eye(moment, &state);
        self.draw_tub(&camera, eye, shaft, drawing)?;
        self.draw_motion(moment.time, &state, &camera, eye, drawing)?;
        self.draw_names(moment.room, &state, drawing)?;
        self.draw_plots(moment.time, &state, &layout, drawing)
    }

    fn grips(&self, moment: &Moment) -> Vec<Point> {
        let layout = Layout::new(moment.room);
        let spin = Axis::linear(SPIN_AXIS, "");
        let steady = place(layout.force, &spin, &Axis::linear(FORCE_AXIS, ""), self.steady_force());
        let kick =
            place(layout.swing, &self.time_axis(), &self.swing_axis(), (self.kick.unwrap_or(0.0), 0.0));
        if self.kick.is_some() { vec![steady, kick] } else { vec![steady] }
    }

    fn drag(&self, grip: usize, to: Point, moment: &Moment) -> Vec<(&'static str, f64)> {
        let layout = Layout::new(moment.room);
        let Some(from) = self.grips(moment).get(grip).copied() else { return Vec::new() };
        if (to.x - from.x).abs() < 0.25 {
            return Vec::new(); // a touch
        }
        if grip == 0 {
            let spin = Axis::linear(SPIN_AXIS, "");
            vec![("spin", value_at(layout.force, &spin, &Axis::linear(FORCE_AXIS, ""), to).0)]
        } else {
            let time = value_at(layout.swing, &self.time_axis(), &self.swing_axis(), to).0;
            vec![("kick", time.clamp(0.0, self.end - 0.1))]
        }
    }

    fn readings(&self, time: f64) -> Result<Vec<f64>, Cause> {
        let time = time.min(self.end);
        let (start, state) = (self.at(0.0)?, self.at(time)?);
        let mass = state.shaft.position + state.load() * self.machine.offset();
        let kicked = self.kick.is_some_and(|kick| 0.0 < kick && kick <= time);
        let kick = if kicked { KICK * self.machine.total_mass() } else { Complex::new(0.0, 0.0) };
        let left = self.momentum(&state) - self.momentum(&start) - kick + self.given(time)?;
        Ok(vec![
            state.spin * 60.0 / TAU,
            state.lead().to_degrees(),
            1e3 * state.shaft.position.norm(),
            1e3 * mass.norm(),
            self.force(&state.shaft).norm(),
            left.norm(),
        ])
    }

    fn words(&self, _time: f64) -> String {
        self.words.clone()
    }
}
