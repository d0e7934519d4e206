//! The scene of the chapter "The pendulum": a mass that can be pulled aside.

use live::prelude::*;
use pendulum::Pendulum;

pub const SCENE: Scene = Scene {
    file: file!(),
    name: "pendulum",
    title: "A pendulum",
    description: "A mass on a rod, pulled aside by sixty degrees from its lowest point.",
    question: r"Does a wide swing take as long as a narrow one?",
    size: [[320.0, 320.0], [320.0, 320.0]],
    view: None,
    still: 0.0,
    controls: &[Control::slider("amplitude", r"amplitude $\theta_0$", [1.0, 179.0, 1.0], "°", 60.0)],
    presets: &[
        preset("narrow", &[("amplitude", 10.0)]),
        preset("nearly to the top", &[("amplitude", 175.0)]),
    ],
    readings: &[reading("period", Form::Fixed(2), "s"), reading(r"angle $\theta$", Form::Fixed(0), "°")],
    symbols: formulas!["l"],
    start: |settings| {
        let pendulum = Pendulum { length: 1.0, gravity: 9.81 };
        Ok(Box::new(Swing { pendulum, amplitude: settings.of("amplitude")?.to_radians() }))
    },
};

/// Where the rod hangs, and its length, px.
const PIVOT: Point = at(160.0, 160.0);
const ROD: f64 = 120.0;

struct Swing {
    pendulum: Pendulum,
    amplitude: f64,
}

impl Swing {
    fn mass(&self, time: f64) -> Point {
        PIVOT + Point::polar(ROD, self.pendulum.angle(self.amplitude, time) - FRAC_PI_2)
    }
}

impl Motion for Swing {
    fn run(&self) -> Run {
        Run { duration: self.pendulum.period(self.amplitude), pace: 1.0, repeats: true }
    }

    fn draw(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        drawing.line(PIVOT, PIVOT + at(0.0, ROD), Stroke::Reference, Hue::Muted);
        drawing.arc(PIVOT, ROD, -FRAC_PI_2 - self.amplitude, 2.0 * self.amplitude, Stroke::Orbit, Hue::Muted);
        let mass = self.mass(moment.time);
        drawing.line(PIVOT, mass, Stroke::Outline, Hue::Ink);
        drawing.dot(PIVOT, 3.0, Hue::Ink);
        drawing.dot(mass, 9.0, Hue::Blue);
        let rod = mass - PIVOT;
        let beside = at(rod.y, -rod.x).unit() * 14.0;
        drawing.label(PIVOT + rod * 0.5 + beside, Side::Over, r"$l$", Hue::Ink)?;
        Ok(())
    }

    fn readings(&self, time: f64) -> Result<Vec<f64>, Cause> {
        let angle = self.pendulum.angle(self.amplitude, time);
        Ok(vec![self.pendulum.period(self.amplitude), angle.to_degrees()])
    }

    fn words(&self, _time: f64) -> String {
        let longer = self.pendulum.period(self.amplitude) / self.pendulum.period(0.0) - 1.0;
        format!("A swing takes {:.1} % longer than a narrow one.", 100.0 * longer)
    }

    fn grips(&self, moment: &Moment) -> Vec<Point> {
        vec![self.mass(moment.time)]
    }

    fn drag(&self, _grip: usize, to: Point, _moment: &Moment) -> Vec<(&'static str, f64)> {
        let aside = to - PIVOT;
        vec![("amplitude", aside.x.abs().atan2(aside.y).to_degrees())]
    }
}
