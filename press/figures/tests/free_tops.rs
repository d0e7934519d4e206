//! The curves of the wobble plate and of the free tops, read back from the SVG, lie on formulas that are written out here.

use figures::all;
use roxmltree::Document;
use std::f64::consts::{PI, TAU};

/// Thinning may move a curve by 0.06 px; reading two decimals costs 0.005 px, the coordinates 0.001 px, sampling the rest.
const PIXELS: f64 = 0.08;

/// The frame of a plot, px, and the ranges of its axes: left, top, width, height, x from and to, y from and to.
struct Frame {
    place: [f64; 4],
    x: (f64, f64),
    y: (f64, f64),
    logarithmic: bool,
}

impl Frame {
    fn at(&self, (x, y): (f64, f64)) -> (f64, f64) {
        let [left, top, width, height] = self.place;
        let part = |(from, to): (f64, f64), value: f64| (value - from) / (to - from);
        let (y, range) =
            if self.logarithmic { (y.ln(), (self.y.0.ln(), self.y.1.ln())) } else { (y, self.y) };
        (left + width * part(self.x, x), top + height * (1.0 - part(range, y)))
    }
}

/// The points of the path with this id.
fn path(figure: &str, name: &str) -> Vec<(f64, f64)> {
    let figures = all().expect("every figure can be drawn");
    let svg = &figures.iter().find(|other| other.id == format!("fig:{figure}")).expect("the figure").svg;
    let document = Document::parse(svg).expect("valid XML");
    let id = format!("fig-{figure}-{name}");
    let node = document.descendants().find(|node| node.attribute("id") == Some(&id));
    let data = node
        .unwrap_or_else(|| panic!("no path {id}"))
        .attribute("d")
        .expect("a path")
        .replace(['M', 'L'], " ");
    data.split_whitespace()
        .map(|pair| {
            let (x, y) = pair.split_once(',').expect("a pair");
            (x.parse().expect("a number"), y.parse().expect("a number"))
        })
        .collect()
}

/// The least distance of a point from a polyline, px.
fn distance(polyline: &[(f64, f64)], (x, y): (f64, f64)) -> f64 {
    polyline
        .windows(2)
        .map(|pair| {
            let [(x0, y0), (x1, y1)] = [pair[0], pair[1]];
            let (dx, dy) = (x1 - x0, y1 - y0);
            let part = (((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
            (x0 + part * dx - x).hypot(y0 + part * dy - y)
        })
        .fold(f64::INFINITY, f64::min)
}

fn lies_on(figure: &str, name: &str, frame: &Frame, formula: impl Fn(f64) -> f64) {
    let curve = path(figure, name);
    let mut checked = 0;
    for step in 1..400 {
        let x = frame.x.0 + (frame.x.1 - frame.x.0) * (f64::from(step) + 0.37) / 400.0;
        let y = formula(x);
        if y > frame.y.0 && y < frame.y.1 {
            let off = distance(&curve, frame.at((x, y)));
            assert!(off < PIXELS, "{figure} {name}: {off} px off at {x}");
            checked += 1;
        }
    }
    assert!(checked > 100, "{figure} {name}: only {checked} points");
}

#[test]
fn the_lean_of_the_momentum_follows_its_tangent() {
    let frame =
        Frame { place: [52.0, 34.0, 520.0, 286.0], x: (0.0, 90.0), y: (-10.0, 22.0), logarithmic: false };
    for thickness in [0.0, 0.5, 1.0, 2.0] {
        let lean = |degrees: f64| {
            let u = degrees.to_radians().tan();
            // I₃/I₁ of a disc of that thickness, and tan β = (I₃ − I₁)u/(I₃ + I₁u²).
            let across = 0.25 + thickness * thickness / 12.0;
            ((0.5 - across) * u / (0.5 + across * u * u)).atan().to_degrees()
        };
        lies_on("beta", &format!("thickness-{thickness}"), &frame, lean);
    }
}

#[test]
fn the_residual_torque_is_a_v_and_the_pair_swings() {
    let frame = Frame { place: [52.0, 34.0, 520.0, 234.0], x: (0.0, 2.5), y: (0.0, 1.6), logarithmic: false };
    lies_on("residual", "torque", &frame, |mass| (1.0 - mass).abs());
    let frame =
        Frame { place: [52.0, 34.0, 470.0, 254.0], x: (0.0, 360.0), y: (-0.1, 1.6), logarithmic: false };
    let frame = Frame { y: (0.0, 1.6), ..frame };
    lies_on("number", "pistons-2", &frame, |degrees| degrees.to_radians().cos().abs());
    let zero = frame.at((0.0, 0.0)).1;
    for count in [3, 5, 7] {
        assert!(
            path("number", &format!("pistons-{count}")).iter().all(|point| (point.1 - zero).abs() < PIXELS)
        );
    }
}

#[test]
fn the_height_of_the_normal_is_a_cosine() {
    let whole =
        Frame { place: [54.0, 34.0, 330.0, 262.0], x: (0.0, 2.0), y: (-0.8, 1.0), logarithmic: false };
    let part =
        Frame { place: [450.0, 34.0, 190.0, 262.0], x: (0.4, 0.6), y: (-0.04, 0.1), logarithmic: false };
    for (ratio, name) in [(0.2, "0.2"), (0.49, "0.49"), (0.5, "0.5"), (0.51, "0.51")] {
        let tangent: f64 = 1.0 / (2.0 * ratio);
        let sine = tangent * tangent / (1.0 + tangent * tangent);
        let height = |turns: f64| 1.0 - sine + sine * (TAU * turns).cos();
        lies_on("threshold", &format!("whole-{name}"), &whole, height);
        if ratio > 0.4 {
            lies_on("threshold", &format!("part-{name}"), &part, height);
        }
    }
}

#[test]
fn the_bias_is_an_inverse_sine() {
    let frame =
        Frame { place: [58.0, 34.0, 560.0, 262.0], x: (0.0, 90.0), y: (0.5, 1.0), logarithmic: false };
    lies_on("bias", "probability", &frame, |degrees| {
        let cotangent = 1.0 / degrees.to_radians().tan();
        if degrees <= 45.0 { 0.9999999 } else { 0.5 + (cotangent * cotangent).asin() / PI }
    });
}

#[test]
fn the_station_nods_faster_than_twice() {
    let frame = Frame { place: [48.0, 34.0, 420.0, 286.0], x: (0.0, 4.0), y: (0.0, 9.0), logarithmic: false };
    lies_on("nodding", "in-the-room", &frame, |turns| turns * (4.0 + 0.4_f64.powi(2)).sqrt());
    lies_on("nodding", "on-board", &frame, |turns| turns);
}

#[test]
fn the_tangent_falls_and_rises_exponentially_and_as_a_power_of_the_spin() {
    let frame = Frame { place: [58.0, 34.0, 470.0, 262.0], x: (0.0, 6.0), y: (1e-3, 1e3), logarithmic: true };
    for (ratio, name) in [(2.0, "2"), (1.0, "1"), (0.5, "0.5")] {
        lies_on("tangent", &format!("ratio-{name}"), &frame, |t: f64| 0.3 * (-(1.0 - 1.0 / ratio) * t).exp());
    }
    let frame = Frame { place: [58.0, 34.0, 470.0, 262.0], x: (0.0, 1.0), y: (0.0, 2.0), logarithmic: false };
    for (ratio, name) in [(2.0, "2"), (1.5, "1.5"), (1.0, "1"), (0.5, "0.5")] {
        lies_on("spin-tangent", &format!("ratio-{name}"), &frame, |spin: f64| spin.powf(ratio - 1.0));
    }
}

#[test]
fn the_spiral_makes_three_turns() {
    let curve = path("wobble-turns", "spiral");
    let centre = (212.0, 194.0);
    let mut turned = 0.0;
    for pair in curve.windows(2) {
        let [a, b] = [pair[0], pair[1]].map(|(x, y)| (x - centre.0, centre.1 - y));
        if a.0.hypot(a.1) > 0.5 && b.0.hypot(b.1) > 0.5 {
            turned += (a.0 * b.1 - a.1 * b.0).atan2(a.0 * b.0 + a.1 * b.1);
        }
    }
    // The size is e^{−Ct/I₁} and the phase 3(1 − e^{−Ct/I₃}) turns, with I₃ = 2I₁; the rest lies within half a pixel of the centre.
    let turns = turned / TAU;
    let expected = 3.0 * (1.0 - (0.5_f64 / 160.0).sqrt());
    assert!((turns - expected).abs() < 0.15, "{turns} turns for {expected}");
}
