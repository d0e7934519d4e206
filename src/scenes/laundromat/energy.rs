//! Torque, power and the conserved quantity: judges of a computed motion.

use super::machine::Machine;
use super::shaft::Shaft;
use nalgebra::Complex;

impl Machine {
    /// Position z + b e<sup>iΩt</sup> of the centre of mass of drum and load, m, in the laboratory
    /// (`eq:centre-of-mass-motion`).
    ///
    /// At high spin the two terms nearly cancel; [`super::Transient::centre_of_mass`] does not form them.
    #[must_use]
    pub fn centre_of_mass(&self, time: f64, shaft: &Shaft) -> Complex<f64> {
        shaft.position + self.offset() * self.load_direction(time)
    }

    /// Torque about the shaft that the motor must give at `time`, s, to keep the spin constant, N·m
    /// (`eq:motor-torque`). Counter-clockwise if positive.
    #[must_use]
    pub fn motor_torque(&self, time: f64, shaft: &Shaft) -> f64 {
        let [_, _, ax, ay] = self.cartesian_rates(time, &shaft.to_array());
        let unbalance = self.total_mass() * self.offset(); // ma
        unbalance * (Complex::new(ax, ay) * self.load_direction(time).conj()).im
    }

    /// Kinetic energy of drum and load and energy of the spring at `time`, s, in J.
    ///
    /// Without the energy of the drum's turning about its own shaft, which is constant.
    #[must_use]
    pub fn energy(&self, time: f64, shaft: &Shaft) -> f64 {
        let parameters = self.parameters();
        let swing = Complex::i() * (parameters.load_radius * parameters.spin) * self.load_direction(time);
        0.5 * (parameters.drum_mass * shaft.velocity.norm_sqr()
            + parameters.load_mass * (shaft.velocity + swing).norm_sqr()
            + parameters.stiffness * shaft.position.norm_sqr())
    }

    /// Power that the dampers turn into heat, γ|ż|², W.
    ///
    /// The rate of change of [`Machine::energy`] is [`Machine::motor_torque`] times the spin, minus this
    /// (`eq:power-balance`).
    #[must_use]
    pub fn dissipation(&self, shaft: &Shaft) -> f64 {
        self.parameters().damping * shaft.velocity.norm_sqr()
    }

    /// The Jacobi integral, m²/s² (`eq:jacobi`): energy for each kilogram as reckoned in the frame that turns with the
    /// drum. Constant along a motion of a machine without damping.
    #[must_use]
    pub fn jacobi_integral(&self, time: f64, shaft: &Shaft) -> f64 {
        let spin = self.spin();
        let turned_back = self.load_direction(time).conj();
        let position = shaft.position * turned_back; // ζ
        let speed = (shaft.velocity - Complex::i() * spin * shaft.position).norm(); // |ζ̇|
        0.5 * speed * speed + 0.5 * self.detuning() * position.norm_sqr()
            - self.offset() * spin * spin * position.re
    }
}
