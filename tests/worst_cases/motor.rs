//! The growth of a disturbance beside the steady speeds of a driven machine, against the signs of Routh's array in 32
//! digits.

use crate::long::{Long, long};
use crate::search::{Case, is_long, keeps_its_promise, worse};
use mechanics::scenes::laundromat::{DrivenMachine, Machine, MachineParameters, Motor};
use std::f64::consts::TAU;

/// The documented error, in units in the last place of what the documentation names.
const UNITS: f64 = 250.0;

type Matrix = [[Long; 5]; 5];

/// A machine with m + M = ω₀ = b = 1: its other numbers.
#[derive(Debug, Clone, Copy)]
struct Own {
    load: f64,
    damping: f64,
    inertia: f64,
    idle: f64,
    spin: f64,
}

impl Own {
    /// What a disturbance does, by Newton's law for the centre of mass in axes that turn with the drum: its place c and
    /// rate ċ there, and the spin. c̈ + 2iφ̇ċ + iφ̈c − φ̇²c = −z − Γ(ċ + iφ̇z) with z = c − 1, and about the centre of
    /// mass I φ̈ = τ + Im(z + Γ(ċ + iφ̇z)).
    fn matrix(&self) -> Matrix {
        let Self { load, damping, inertia, idle, spin } = *self;
        let [zero, one, g, u] = [0.0, 1.0, damping, spin].map(long);
        let inertia = (one - load) / load + inertia;
        // The steady place of the shaft, u²/(1 − u² + iΓu), and what the motor then gives, −Im((1 + iΓu)z).
        let [re, im] = [(one - u) * (one + u), g * u];
        let size = re * re + im * im;
        let z = [u * u * re / size, -(u * u * im / size)];
        let c = [z[0] + 1.0, z[1]];
        let torque = -(z[1] + g * u * z[0]);
        let slope = -(torque / (one - u / idle) / idle);
        // φ̈ for changes of c, ċ and the spin.
        let turning = [g * u, one, zero, g, g * z[0] + slope].map(|part| part / inertia);
        let mut matrix = [[zero; 5]; 5];
        (matrix[0][2], matrix[1][3]) = (one, one);
        // u²c + 2uc φ̇ − 2iuċ − z − Γ(ċ + iuz + iz₀φ̇), and −iφ̈c.
        matrix[2] = [u * u - one, g * u, -g, u * 2.0, u * c[0] * 2.0 + g * z[1]];
        matrix[3] = [-(g * u), u * u - one, -(u * 2.0), -g, u * c[1] * 2.0 - g * z[0]];
        for (column, turning) in turning.into_iter().enumerate() {
            matrix[2][column] = matrix[2][column] + c[1] * turning;
            matrix[3][column] = matrix[3][column] - c[0] * turning;
        }
        matrix[4] = turning;
        matrix
    }

    /// The library's growth rate for this machine in other units.
    fn growth(&self, [mass, length, time]: [f64; 3]) -> Option<f64> {
        let Self { load, damping, inertia, idle, spin } = *self;
        let machine = Machine::new(MachineParameters {
            drum_mass: (1.0 - load) * mass,
            load_mass: load * mass,
            load_radius: length / load,
            stiffness: mass / (time * time),
            damping: damping * mass / time,
            spin: 0.0,
        });
        let motor = Motor {
            stall_torque: 1.0, // it plays no part
            idle_spin: idle / time,
            drum_inertia: inertia * mass * length * length,
        };
        let driven = machine.and_then(|machine| machine.driven(motor)).ok()?; // or an inertia out of range
        Some(driven.growth_rate(spin / time).expect("a rate") * time)
    }
}

/// The coefficients of the characteristic polynomial from x⁵ down, by Faddeev and Le Verrier.
fn polynomial(matrix: &Matrix) -> [Long; 6] {
    let mut coefficients = [long(1.0); 6];
    let mut product = *matrix;
    for (k, coefficient) in coefficients.iter_mut().enumerate().skip(1) {
        let trace: Long = (0..5).map(|i| product[i][i]).sum();
        *coefficient = -(trace / k as f64);
        for (i, row) in product.iter_mut().enumerate() {
            row[i] = row[i] + *coefficient;
        }
        let before = product;
        product = std::array::from_fn(|i| {
            std::array::from_fn(|j| (0..5).map(|l| matrix[i][l] * before[l][j]).sum())
        });
    }
    coefficients
}

/// Whether all roots lie to the left of `x`: the first column of Routh's array of the polynomial in the variable less
/// x.
fn all_left_of(polynomial: &[Long; 6], x: Long) -> bool {
    let mut shifted = *polynomial;
    for last in (1..6).rev() {
        for k in 1..=last {
            shifted[k] = shifted[k] + shifted[k - 1] * x;
        }
    }
    let mut upper = [shifted[0], shifted[2], shifted[4], long(0.0)];
    let mut lower = [shifted[1], shifted[3], shifted[5], long(0.0)];
    for _ in 0..5 {
        if lower[0] <= long(0.0) {
            return false;
        }
        let next = std::array::from_fn(|k| match k {
            3 => long(0.0),
            _ => upper[k + 1] - upper[0] * lower[k + 1] / lower[0],
        });
        (upper, lower) = (lower, next);
    }
    true
}

/// The largest real part of a root, to some 25 digits of the largest root.
fn abscissa(matrix: &Matrix) -> (Long, f64) {
    let polynomial = polynomial(matrix);
    // Fujiwara's bound of all roots.
    let size = (1..6).map(|k| polynomial[k].abs().rounded().powf(1.0 / k as f64)).fold(0.0, f64::max);
    let (mut low, mut high) = (long(-2.0 * size), long(2.0 * size));
    for _ in 0..90 {
        let middle = (low + high) * 0.5;
        if all_left_of(&polynomial, middle) { high = middle } else { low = middle }
    }
    (high, size)
}

/// The units in which rows and columns are alike in size.
fn balance(matrix: &Matrix) -> [f64; 5] {
    let mut scales = [1.0; 5];
    for n in 0..200 {
        let i = n % 5;
        let of = |entry: &dyn Fn(usize) -> f64| {
            (0..5).filter(|&j| j != i).map(|j| entry(j).powi(2)).sum::<f64>().sqrt()
        };
        let row = of(&|j| matrix[i][j].rounded() * scales[j] / scales[i]);
        let column = of(&|j| matrix[j][i].rounded() * scales[i] / scales[j]);
        scales[i] *= (row / column).sqrt();
    }
    scales
}

/// A machine in units of mass, length and time, unless its inertia is out of range there.
fn judged(own: Own, units: [f64; 3]) -> Option<Case> {
    let matrix = own.matrix();
    let (truth, size) = abscissa(&matrix);
    let ours = own.growth(units)?;
    let error = (truth - ours).abs().rounded();
    // What a change of each number by a unit in its last place does, and of each entry of the matrix by one of the
    // largest root.
    let beside = |matrix: &Matrix| (abscissa(matrix).0 - truth).abs().rounded();
    let up = 1.0 + f64::EPSILON;
    let numbers = beside(&Own { damping: own.damping * up, ..own }.matrix())
        + beside(&Own { inertia: own.inertia * up, ..own }.matrix())
        + beside(&Own { spin: own.spin * up, ..own }.matrix())
        + beside(&Own { idle: own.idle * up, ..own }.matrix())
        + beside(&Own { load: own.load / up, ..own }.matrix());
    let scales = balance(&matrix);
    let mut random = fastrand::Rng::with_seed(7);
    let entries = (0..8)
        .map(|_| {
            let mut changed = matrix;
            for (i, row) in changed.iter_mut().enumerate() {
                for (j, entry) in row.iter_mut().enumerate() {
                    let sign = if random.bool() { 1.0 } else { -1.0 };
                    *entry = *entry + sign * f64::EPSILON * size * scales[i] / scales[j];
                }
            }
            beside(&changed)
        })
        .fold(0.0, worse);
    let hardly_damped = own.damping < 1e-5;
    let rounding = if hardly_damped { 1e-6 * size } else { UNITS * (f64::EPSILON * size + entries) };
    let promised = UNITS * numbers + rounding;
    let said = format!("{own:?}, {units:?}: {ours:?}, true {truth:?}; off {error:e}, promised {promised:e}");
    let way = match truth > long(0.0) {
        _ if hardly_damped => "hardly damped",
        true => "grows",
        false => "dies out",
    };
    Some(Case { ratio: error / promised, way, said })
}

#[test]
fn a_growth_rate_is_what_a_change_of_the_last_places_leaves_of_it() {
    keeps_its_promise("growth rate", 300, &["grows", "dies out", "hardly damped"], |draw| {
        let spin = if draw.below(2) == 0 { draw.beside(1.0) } else { draw.decades(1e-2, 1e2) };
        let own = Own {
            load: if draw.below(2) == 0 { draw.decades(1e-6, 0.5) } else { 1.0 - draw.decades(1e-3, 0.5) },
            damping: if draw.below(3) == 0 { draw.beside(2.0) } else { draw.decades(1e-14, 1e2) },
            inertia: if draw.below(3) == 0 { 0.0 } else { draw.decades(1e-3, 1e6) },
            idle: spin * (1.0 + draw.decades(1e-3, 1e3)),
            spin,
        };
        judged(own, std::array::from_fn(|_| draw.binary_unit(66)))
    });
}

#[test]
fn the_search_for_the_roots_ends_where_from_the_plain_axes_it_goes_round_in_a_circle() {
    // Heavy damping and a slow drum: the roots are two pairs, each as good as double.
    for own in [
        Own {
            load: 1.592_805_232_770_905_4e-5,
            damping: 5.492_462_400_579_813_5,
            inertia: 0.033_199_719_951_088_45,
            idle: 0.808_930_730_048_592_4,
            spin: 0.013_978_360_274_908_574,
        },
        Own {
            load: 0.018_056_087_167_121_655,
            damping: 5.912_779_047_949_392,
            inertia: 34_445.551_337_108_99,
            idle: 0.013_346_781_692_040_724,
            spin: 0.013_332_766_273_131_012,
        },
    ] {
        for time in [1.0, 128.0, 2.0_f64.powi(62)] {
            let case = judged(own, [1.0, 1.0, time]).expect("a machine");
            assert!(case.ratio < 1.0, "{}", case.said);
        }
    }
}

/// The page's machine with a motor of 6 N·m, in other units of time and length.
fn washer(time: f64, length: f64) -> DrivenMachine {
    let parameters = MachineParameters {
        drum_mass: 28.0,
        load_mass: 2.0,
        load_radius: 0.25 * length,
        stiffness: 3000.0 / (time * time),
        damping: 45.0 / time,
        spin: 0.0,
    };
    let square = length * length;
    let motor = Motor {
        stall_torque: 6.0 * square / (time * time),
        idle_spin: 40.0 / time,
        drum_inertia: 0.5 * square,
    };
    Machine::new(parameters).and_then(|machine| machine.driven(motor)).expect("a machine")
}

#[test]
fn a_growth_rate_knows_no_units() {
    // By mpmath with 60 digits from the matrix of the machine in SI units: it was 271.7 for times × 1e-9.
    let truth = -0.259_377_55;
    for power in -20..=20 {
        for (time, length) in [(10_f64.powi(power), 1.0), (1.0, 10_f64.powi(power))] {
            let growth = washer(time, length).growth_rate(36.4546 / time).expect("a rate") * time;
            assert!((growth - truth).abs() < 1e-8, "times × {time:e}, lengths × {length:e}: {growth}");
            let here = washer(1.0, 1.0).growth_rate(36.4546).expect("a rate");
            assert!((growth - here).abs() < 1e-12, "times × {time:e}, lengths × {length:e}: {growth} {here}");
        }
    }
    // A rotor of a thousandth of a milligram that swings ten thousand times a second.
    let natural = TAU * 1e4;
    let machine = Machine::new(MachineParameters {
        drum_mass: 1e-9,
        load_mass: 1e-12,
        load_radius: 5e-5,
        stiffness: 1e-9 * natural * natural,
        damping: 1e-9 * 6e4 * 0.01,
        spin: 0.0,
    });
    let motor = Motor { stall_torque: 1e-12, idle_spin: 2e5, drum_inertia: 1e-18 };
    let growth = machine.and_then(|machine| machine.driven(motor)?.growth_rate(1e5)).expect("a rate");
    assert!((growth - 0.00246).abs() < 5e-6, "{growth}");
}

#[test]
fn no_growth_rate_is_no_number_and_none_is_searched_for_ever() {
    if !is_long() {
        return; // machines of no scene: for the night
    }
    keeps_its_promise("hostile growth rate", 2000, &["answered", "refused"], |draw| {
        let mut any = || draw.decades(1e-50, 1e50);
        let parameters = MachineParameters {
            drum_mass: any(),
            load_mass: any(),
            load_radius: any(),
            stiffness: any(),
            damping: any(),
            spin: 0.0,
        };
        let motor = Motor { stall_torque: any(), idle_spin: any(), drum_inertia: any() };
        let driven = Machine::new(parameters).and_then(|machine| machine.driven(motor)).ok()?;
        let spin = motor.idle_spin * draw.between(0.0, 1.0);
        let growth = driven.growth_rate(spin);
        let (way, ratio) = match growth {
            Ok(growth) => ("answered", if growth.is_finite() { 0.0 } else { f64::INFINITY }),
            Err(_) => ("refused", 0.0),
        };
        Some(Case { ratio, way, said: format!("{driven:?} at {spin:e}: {growth:?}") })
    });
}
