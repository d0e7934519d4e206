//! The machine in polar coordinates: what the program there gets wrong, and its eigenvalues.

use super::washing_machine;
use drawing::kit::Marker;
use drawing::{Drawing, Hue, Rect, Side, Stroke, at};
use figures::{Axis, Look, Outcome, Plot, Room, in_both, linear_steps, log_steps};
use mechanics::InvalidQuantity;
use mechanics::integrate::rk4;
use mechanics::scenes::laundromat::{Machine, Polar, Shaft};
use nalgebra::{Complex, Matrix4};

/// Two eigenvalues at each Ω/ω₀.
type Rates = Vec<(f64, [Complex<f64>; 2])>;

/// The matrix of the small motions of a machine.
type MatrixOf = fn(&Machine) -> Matrix4<f64>;

/// The naive program near O, in polar and in Cartesian coordinates.
pub(crate) fn polar_fault(id: &str) -> Outcome {
    let machine = washing_machine(0.3, 3.0)?;
    let (speed, steps) = (1.0, 100);
    let step = 1e-3;
    // Pass O in the middle of a step: nothing is special about the instant.
    let (before, after) = (-50.3 * step, 49.7 * step);
    let (mut polar, mut cartesian) = (Vec::new(), Vec::new());
    for distance in log_steps(1e-5, 1e-1, 40) {
        let pass = Shaft { position: Complex::new(0.0, distance), velocity: Complex::new(speed, 0.0) };
        let motion = machine.transient(pass)?;
        let [start, exact] = [motion.at(before)?, motion.at(after)?];
        let error = |end: Shaft| (end.position - exact.position).norm();
        if let Ok(end) = rk4(
            |t, y: &[f64; 4]| machine.polar_rates(t, y),
            before,
            start.to_polar().to_array(),
            after,
            steps,
        ) {
            polar.push((distance, error(Shaft::from_polar(Polar::from_array(end)))));
        }
        let end =
            rk4(|t, y: &[f64; 4]| machine.cartesian_rates(t, y), before, start.to_array(), after, steps)?;
        cartesian.push((distance, error(Shaft::from_array(end))));
    }
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(580.0, 400.0), 360.0).titled(
            "Error of the polar and the Cartesian program after one pass near O",
            "Both scales are logarithmic. Along x the distance at which the shaft passes O, from ten micrometres to ten centimetres; along \
             y the error of the position after the pass, in metres, by the Runge-Kutta method with steps of a millisecond. In polar \
             coordinates the error grows from below 1e-9 at ten centimetres to almost 1e-2 at half a millimetre; nearer to O the \
             program returned no number. In x and y it is 3e-11 at every distance.",
        );
        let distance = Axis::log(1e-5, 1e-1, 1).titled("distance of the pass from $O$, m");
        let error = Axis::log(1e-12, 1.0, 2).titled("error of the position after the pass, m");
        let mut plot =
            Plot::new(&mut drawing, Rect::new(62.0, 34.0, room.of(504.0, 312.0), 274.0), distance, error)?;
        plot.upright(speed * step, Stroke::Dotted);
        plot.series("polar", &polar, Look::RK4.marker, Look::RK4.hue);
        plot.series("cartesian", &cartesian, Marker::Ring, Look::RK4.hue);
        plot.label(
            (1e-3, 1e-1),
            Side::Right,
            room.of("distance covered in one step", "covered in one step"),
            Hue::Muted,
        )?;
        plot.label((5e-3, 1e-6), Side::AboveRight, r"in $r$ and $\theta$", Look::RK4.hue)?;
        plot.label((1e-4, 3e-11), Side::Above, r"in $x$ and $y$", Look::RK4.hue)?;
        Ok(drawing)
    })
}

/// Growth and frequency of small motions as the spin grows: a damper on the whole velocity, and one on ṙ only.
pub(crate) fn eigenvalues(id: &str) -> Outcome {
    let panels: [(&str, &str, MatrixOf, &str); 2] = [
        (
            "whole",
            r"damping $-\gamma\dot{\boldsymbol{r}}$",
            Machine::stability_matrix,
            "The damper resists the whole velocity. Above, the rate of growth is a level line at minus 0.15 for all spins. Below, one frequency \
             rises from 1 to 4, the other falls from 1 to zero at the natural frequency and rises again to 2.",
        ),
        (
            "radial",
            r"damping $-\gamma\dot{r}\,\hat{\boldsymbol{r}}$",
            Machine::radial_damping_matrix,
            "The damper resists the radial velocity only. Above, from spins of nearly zero on, one rate of growth falls from minus 0.075 to minus 0.3. \
             The other, drawn heavily, rises from there, passes zero at the natural frequency and goes on in the tinted half, where motions grow, \
             to 0.15. Below, the frequencies are as before, and the one of the growing motion is zero where its growth begins.",
        ),
    ];
    let mut drawn = Vec::new();
    for (panel, name, matrix, words) in panels {
        let mut drawing =
            Drawing::new("", 280.0, 480.0).titled("Growth and frequency as the spin grows", words);
        let spin = Axis::linear(0.0, 3.0, 1.0).minor(0.5);
        let rate = Axis::linear(-0.4, 0.2, 0.2).minor(0.1).titled(r"growth $\text{Re}\,\lambda/\omega_0$");
        let rates = matrix_rates(0.3, 3.0, matrix)?;
        let mut plot = Plot::new(&mut drawing, Rect::new(48.0, 64.0, 218.0, 150.0), spin.unlabelled(), rate)?;
        plot.region((0.0, 0.0), (3.0, 0.2), Hue::Muted);
        plot.reference((0.0, 0.0), (3.0, 0.0), Stroke::Outline);
        plot.upright(1.0, Stroke::Dotted);
        let draw = |plot: &mut Plot<'_>, what: &str, of: &dyn Fn(&Complex<f64>) -> f64| {
            for (which, stroke) in [("least", Stroke::Outline), ("most", Stroke::Heavy)] {
                let values =
                    rates.iter().map(|(ratio, found)| (*ratio, of(&found[usize::from(which == "most")])));
                plot.curve(&format!("{what}-{panel}-{which}"), values, stroke, Hue::Ink);
            }
        };
        draw(&mut plot, "growth", &|rate| rate.re);
        let grows = plot.at((0.12, 0.15));
        plot.drawing().label_on_face(grows, Side::Right, "grows", Hue::Muted)?;
        let top = at(plot.frame().centre().x, 16.0);
        plot.drawing().label(top, Side::Over, name, Hue::Ink)?;

        let turns = Axis::linear(0.0, 4.0, 1.0).minor(0.5).titled(r"frequency $\text{Im}\,\lambda/\omega_0$");
        let spin = spin.titled(r"spin $\Omega/\omega_0$");
        let mut plot = Plot::new(&mut drawing, Rect::new(48.0, 266.0, 218.0, 150.0), spin, turns)?;
        plot.upright(1.0, Stroke::Dotted);
        draw(&mut plot, "frequency", &|rate| rate.im.abs());
        drawn.push(drawing);
    }
    Ok(Drawing::panels(id, drawn))
}

/// Two of the four eigenvalues over ω₀ while Ω/ω₀ grows from 0, one of each pair: the one that decays fastest, and the
/// one that decays least. Of two that decay alike the first turns faster.
fn matrix_rates(damping: f64, to: f64, matrix: MatrixOf) -> Result<Rates, InvalidQuantity> {
    let mut rates = Vec::new();
    for ratio in linear_steps(0.0, to, 1500) {
        let machine = washing_machine(damping, ratio)?;
        let found = matrix(&machine).complex_eigenvalues() / Complex::from(machine.natural_frequency());
        let mut found: Vec<Complex<f64>> = found.iter().copied().collect();
        let alike = |a: f64, b: f64| (a - b).abs() < 1e-6;
        found.sort_by(|a, b| match alike(a.re, b.re) {
            true => b.im.abs().total_cmp(&a.im.abs()),
            false => a.re.total_cmp(&b.re),
        });
        rates.push((ratio, [found[0], found[3]]));
    }
    Ok(rates)
}
