//! The machine in polar coordinates: what the program there gets wrong, and its eigenvalues.

use super::{Values, washing_machine};
use drawing::kit::{self, Heads, Marker};
use drawing::{Drawing, Hue, Rect, Side, Stroke, at};
use figures::{Axis, Look, Outcome, Plot, Room, in_both, linear_steps, log_steps};
use mechanics::InvalidQuantity;
use mechanics::integrate::rk4;
use mechanics::scenes::laundromat::{Machine, Polar, Shaft};
use nalgebra::{Complex, Matrix4};

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
        let mut drawing = Drawing::new(id, room.of(660.0, 400.0), 360.0).titled(
            "Error of the polar and the Cartesian program after one pass near O",
            "Both scales are logarithmic. Along x the distance at which the shaft passes O, from ten micrometres to ten centimetres; along \
             y the error of the position after the pass, in metres, by the Runge-Kutta method with steps of a millisecond. In polar \
             coordinates the error grows from below 1e-9 at ten centimetres to almost 1e-2 at half a millimetre; nearer to O the \
             program returned no number. In x and y it is 3e-11 at every distance.",
        );
        let distance = Axis::log(1e-5, 1e-1, 1).titled("distance of the pass from $O$, m");
        let error = Axis::log(1e-12, 1.0, 2).titled("error of the position after the pass, m");
        let mut plot =
            Plot::new(&mut drawing, Rect::new(62.0, 34.0, room.of(576.0, 312.0), 274.0), distance, error)?;
        plot.upright(speed * step, Stroke::Dotted);
        plot.series("polar", &polar, Look::RK4.marker, Look::RK4.hue);
        plot.series("cartesian", &cartesian, Marker::Ring, Look::RK4.hue);
        plot.label(
            (1e-3, 1e-1),
            Side::Right,
            room.of("distance covered in one step", "covered in one step"),
            Hue::Muted,
        )?;
        plot.label((5e-3, 1e-6), Side::AboveRight, r"in $r$ and $\theta$", Hue::Orange)?;
        plot.label((1e-4, 3e-11), Side::Above, r"in $x$ and $y$", Look::RK4.hue)?;
        Ok(drawing)
    })
}

/// Four eigenvalues as the spin grows: a damper on the whole velocity, and one on ṙ only.
pub(crate) fn eigenvalues(id: &str) -> Outcome {
    let panels: [(&str, &str, MatrixOf, &str); 2] = [
        (
            "whole",
            r"damping $-\gamma\dot{\boldsymbol{r}}$",
            Machine::stability_matrix,
            "The damper resists the whole velocity. All four paths run along the vertical line at minus one half Gamma, in the half where motions \
             decay: from plus one the first goes up to plus 4 and the third down to minus 2, from minus one the second goes up to plus 2 and \
             the fourth down to minus 4.",
        ),
        (
            "radial",
            r"damping $-\gamma\dot{r}\,\hat{\boldsymbol{r}}$",
            Machine::radial_damping_matrix,
            "The damper resists the radial velocity only. Two paths stay on the left, and two pass through zero when the spin equals the natural \
             frequency and go on in the tinted right half, where motions grow.",
        ),
    ];
    let mut drawn = Vec::new();
    for (panel, name, matrix, words) in panels {
        let mut drawing = Drawing::new("", 350.0, 440.0).titled("Eigenvalues as the spin grows", words);
        let real = Axis::linear(-0.4, 0.2, 0.2).minor(0.1).titled(r"$\text{Re}\,\lambda/\omega_0$");
        let imaginary = Axis::linear(-4.2, 4.2, 2.0).minor(1.0).titled(r"$\text{Im}\,\lambda/\omega_0$");
        let mut plot = Plot::new(&mut drawing, Rect::new(48.0, 54.0, 246.0, 334.0), real, imaginary)?;
        plot.region((0.0, -4.2), (0.2, 4.2), Hue::Orange);
        plot.reference((0.0, -4.2), (0.0, 4.2), Stroke::Outline);
        plot.reference((-0.4, 0.0), (0.0, 0.0), Stroke::Dotted);
        for (index, path) in eigenvalue_paths(0.3, 3.0, matrix)?.iter().enumerate() {
            plot.curve(&format!("path-{panel}-{index}"), path.iter().copied(), Stroke::Curve, Hue::Blue);
            let (Some(&first), Some(&last)) = (path.first(), path.last()) else { continue };
            plot.markers(&[first], Marker::Ring, Hue::Blue);
            plot.markers(&[last], Marker::Disc, Hue::Blue);
            let number = match (last.1 / first.1.abs()).round() as i32 {
                4.. => "$1$",
                0..4 => "$2$",
                -3..0 => "$3$",
                _ => "$4$",
            };
            if panel == "whole" {
                // All on one line: beside it, how each runs.
                let aside = at(if matches!(number, "$1$" | "$3$") { 14.0 } else { -14.0 }, 0.0);
                let [from, to] = [plot.at(first) + aside, plot.at(last) + aside];
                kit::dimension(plot.drawing(), from, to, Heads::End, Hue::Blue);
                let side = if aside.x > 0.0 { Side::Right } else { Side::Left };
                plot.drawing().label(from.towards(to, 0.62), side, number, Hue::Blue)?;
            } else {
                // Which way it goes as the spin grows.
                let [before, after] = [path[2300], path[2310]].map(|value| plot.at(value));
                kit::head(plot.drawing(), after, after - before, 0.8, Hue::Blue);
                let side = if last.0 > 0.0 { Side::Right } else { Side::Left };
                plot.label(last, side, number, Hue::Blue)?;
            }
        }
        let grows = plot.at((0.1, -3.0));
        plot.drawing().label_on_face(grows, Side::Over, "grows", Hue::Orange)?;
        if panel == "radial" {
            let crossing = plot.at((0.03, 0.0));
            plot.drawing().label_on_face(crossing, Side::Right, r"$\Omega = \omega_0$", Hue::Ink)?;
        }
        let top = at(plot.frame().centre().x + 16.0, 16.0);
        plot.drawing().label(top, Side::Over, name, Hue::Ink)?;
        drawn.push(drawing);
    }
    Ok(Drawing::panels(id, drawn))
}

/// The paths of four eigenvalues over ω₀ while Ω/ω₀ grows from 0, each value joined to the nearest of the step before.
fn eigenvalue_paths(damping: f64, to: f64, matrix: MatrixOf) -> Result<[Values; 4], InvalidQuantity> {
    let mut paths: [Values; 4] = Default::default();
    for ratio in linear_steps(0.0, to, 3000) {
        let machine = washing_machine(damping, ratio)?;
        let found = matrix(&machine).complex_eigenvalues();
        let mut free: Vec<Complex<f64>> = found.iter().map(|s| s / machine.natural_frequency()).collect();
        for path in &mut paths {
            // Straight on from the last two values, so that paths that cross do not swap.
            let expected = match path.as_slice() {
                [.., (x0, y0), (x1, y1)] => Complex::new(2.0 * x1 - x0, 2.0 * y1 - y0),
                [(x, y)] => Complex::new(*x, *y),
                [] => free[0],
            };
            let nearest = (0..free.len())
                .min_by(|&i, &j| (free[i] - expected).norm().total_cmp(&(free[j] - expected).norm()));
            if let Some(index) = nearest {
                let s = free.swap_remove(index);
                path.push((s.re, s.im));
            }
        }
    }
    Ok(paths)
}
