//! The hues of figures and formulas, as people see them whose eyes lack one kind of cone.

use super::contrast::{THEMES, Theme};

/// The least distance of two hues in the space CIELAB, in which about two units can just be told apart.
const APART: f64 = 13.0;

/// What red, green and blue light, in linear measure, looks like without one kind of cone (G. M. Machado, M. M.
/// Oliveira and L. A. F. Fernandes, IEEE Trans. Vis. Comput. Graph. 15, 2009, table 1, severity 1).
const EYES: [(&str, [[f64; 3]; 3]); 4] = [
    ("all cones", [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
    (
        "no long cones",
        [
            [0.152_286, 1.052_583, -0.204_868],
            [0.114_503, 0.786_281, 0.099_216],
            [-0.003_882, -0.048_116, 1.051_998],
        ],
    ),
    (
        "no middle cones",
        [
            [0.367_322, 0.860_646, -0.227_968],
            [0.280_085, 0.672_501, 0.047_413],
            [-0.011_820, 0.042_940, 0.968_881],
        ],
    ),
    (
        "no short cones",
        [
            [1.255_528, -0.076_749, -0.178_779],
            [-0.078_411, 0.930_809, 0.147_602],
            [0.004_733, 0.691_367, 0.303_900],
        ],
    ),
];

fn product(matrix: &[[f64; 3]; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    matrix.map(|[a, b, c]| a * x + b * y + c * z)
}

/// Lightness and the two opponent coordinates of linear red, green and blue (CIE 1976, white D65).
fn lab(linear: [f64; 3]) -> [f64; 3] {
    const XYZ: [[f64; 3]; 3] = [
        [0.412_456_4, 0.357_576_1, 0.180_437_5],
        [0.212_672_9, 0.715_152_2, 0.072_175_0],
        [0.019_333_9, 0.119_192_0, 0.950_304_1],
    ];
    let [x, y, z] = product(&XYZ, linear.map(|channel| channel.clamp(0.0, 1.0)));
    let edge = 6.0_f64 / 29.0;
    let root =
        |part: f64| if part > edge.powi(3) { part.cbrt() } else { part / (3.0 * edge * edge) + 4.0 / 29.0 };
    let [x, y, z] = [x / 0.950_47, y, z / 1.088_83].map(root);
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

#[test]
fn hues_can_be_told_apart_by_every_eye_in_every_theme() {
    let hues = ["blue", "orange", "green", "pink", "purple"];
    let mut near = Vec::new();
    for name in THEMES {
        let theme = Theme::new(name);
        for (eye, matrix) in EYES {
            let seen = hues.map(|hue| lab(product(&matrix, theme.linear(&format!("var(--figure-{hue})")))));
            for (n, one) in seen.iter().enumerate() {
                for (m, other) in seen[..n].iter().enumerate() {
                    let apart = (0..3).map(|k| (one[k] - other[k]).powi(2)).sum::<f64>().sqrt();
                    if apart < APART {
                        near.push(format!("{name}, {eye}: {} and {}, {apart:.1}", hues[n], hues[m]));
                    }
                }
            }
        }
    }
    assert!(near.is_empty(), "{}", near.join("\n"));
}

#[test]
fn colours_are_measured_as_the_commission_says() {
    let close = |found: [f64; 3], expected: [f64; 3]| (0..3).all(|k| (found[k] - expected[k]).abs() < 0.02);
    assert!(close(lab([1.0; 3]), [100.0, 0.0, 0.0]));
    assert!(close(lab([1.0, 0.0, 0.0]), [53.24, 80.09, 67.20])); // the red of a screen
    assert!(close(lab([0.0; 3]), [0.0; 3]));
    for (_, matrix) in EYES {
        let grey = product(&matrix, [0.4; 3]); // looks the same to all
        assert!(grey.iter().all(|channel| (channel - 0.4).abs() < 1e-5), "{grey:?}");
    }
}
