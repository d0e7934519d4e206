//! The equations of motion as rates, for any stepping method.

use super::machine::Machine;
use nalgebra::Complex;

impl Machine {
    /// Rates of `[x, y, ẋ, ẏ]` at `time`, s (`eq:cartesian-motion`). SI units, frame of the laboratory.
    ///
    /// The right-hand side to integrate: smooth everywhere, and linear.
    #[must_use]
    pub fn cartesian_rates(&self, time: f64, &[x, y, vx, vy]: &[f64; 4]) -> [f64; 4] {
        let spin = self.spin();
        let [stiffness, damping] = [self.stiffness_rate().rounded(), self.damping_rate()];
        let push = self.offset() * (spin * spin) * self.load_direction(time);
        [vx, vy, push.re - stiffness * x - damping * vx, push.im - stiffness * y - damping * vy]
    }

    /// Rates of `[r, θ, ṙ, θ̇]` at `time`, s (`eq:radial-motion`, `eq:azimuthal-motion`). SI units.
    ///
    /// For teaching and for tests. It divides by r: at r = 0 the last rate is infinite or not a number, and near
    /// it every stepping method suffers. Use [`Machine::cartesian_rates`] for work.
    #[must_use]
    pub fn polar_rates(&self, time: f64, &[r, theta, r_dot, theta_dot]: &[f64; 4]) -> [f64; 4] {
        let spin = self.spin();
        let [stiffness, damping] = [self.stiffness_rate().rounded(), self.damping_rate()];
        // The load's azimuth from the shaft's, φ − θ, as a direction.
        let lead = self.load_direction(time) * Complex::new(theta.cos(), -theta.sin());
        let push = self.offset() * (spin * spin) * lead;
        [
            r_dot,
            theta_dot,
            r * theta_dot * theta_dot + push.re - stiffness * r - damping * r_dot,
            (push.im - 2.0 * r_dot * theta_dot) / r - damping * theta_dot,
        ]
    }

    /// Rates of `[x, y, ẋ, ẏ]` at `time`, s, of another machine, whose damper resists only the radial velocity
    /// ṙ. SI units, frame of the laboratory.
    ///
    /// That is the source's wording taken literally; it makes steady motion unstable above the natural frequency
    /// (`eq:radial-damping-quartic`). At O the radial direction is taken as that of the velocity, which makes the
    /// damping continuous along a path straight through O.
    #[must_use]
    pub fn radial_damping_rates(&self, time: f64, state: &[f64; 4]) -> [f64; 4] {
        let &[x, y, vx, vy] = state;
        let r = x.hypot(y);
        let (radial_x, radial_y) = if r > 0.0 {
            let r_dot = vx * (x / r) + vy * (y / r);
            (r_dot * (x / r), r_dot * (y / r))
        } else {
            (vx, vy)
        };
        let damping = self.damping_rate();
        let [_, _, ax, ay] = self.cartesian_rates(time, state);
        // Take off the damping of what is not radial.
        [vx, vy, ax + damping * (vx - radial_x), ay + damping * (vy - radial_y)]
    }
}
