//! The small scene of three speeds against the balance of forces along the radius and across it.

use crate::hand::{Hand, number_behind};

#[test]
fn leads_and_circles_are_those_of_the_two_balances() {
    for damping in [0.02, 0.3, 1.0, 2.0] {
        let hand = Hand::with("speeds", &[("damping", damping)]);
        let words = hand.words();
        let mut radii = [0.0; 3];
        for (place, (ratio, name)) in
            [(0.5, "lead"), (1.0, "at resonance"), (3.0, "fast")].into_iter().enumerate()
        {
            // In units of ω₀ and b: along the radius (1 − Ω²) r = Ω² cos φ, across it Γ r = Ω sin φ.
            let lead = f64::atan2(damping * ratio, 1.0 - ratio * ratio);
            let read = hand.reading(1.0, name);
            assert!((read - lead.to_degrees()).abs() < 1e-9, "{damping}, {name}: {read}");
            radii[place] = ratio * lead.sin() / damping;
        }
        let first = number_behind(&words, "circles of");
        assert!((first - radii[0]).abs() < 6e-3, "{damping}: {words}");
        for radius in radii {
            assert!(words.contains(&format!("{radius:.2}")), "{damping}: {words}, {radius}");
        }
    }
}
