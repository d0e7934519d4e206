//! A tilted plate on a shaft, and the pistons that it drives. Chapter "The wobble plate".
//!
//! The shaft lies along z and turns with the angular velocity ω; the phase is ωt. The rotating axes are
//! `x' = (cos ωt, sin ωt, 0)`, `y' = z × x'` and z. The plate's normal is `cos α z − sin α x'`. Nothing here has a state: every
//! quantity is a function of the phase. A phase or spin that is not finite gives NaN.

use crate::inertia::{Body, PrincipalMoments};
use crate::quantity::{InvalidQuantity, Rule, Shown};
use nalgebra::Vector3;
use std::error::Error;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::fmt;

/// A round plate fixed to a shaft through its centre, its normal tilted by α.
///
/// ```
/// use mechanics::scenes::wobble_plate::Plate;
/// // Whatever its size, a thin plate's angular momentum never leans more than arcsin 1/3 = 19.47° from the shaft.
/// let steepest = (1..90)
///     .map(|degrees| Plate::thin(2.0, 0.1, f64::from(degrees).to_radians()))
///     .map(|plate| plate.map(|plate| plate.momentum_angle()))
///     .try_fold(0.0, |largest, angle| angle.map(|angle| f64::max(largest, angle)))?;
/// assert!(steepest < (1.0_f64 / 3.0).asin() && steepest.to_degrees() > 19.46);
/// # Ok::<(), mechanics::scenes::wobble_plate::InvalidEngine>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plate {
    moments: PrincipalMoments,
    across: f64, // I₁
    along: f64,  // I₃
    tilt: f64,
    sin: f64,
    cos: f64,
}

impl Plate {
    /// A thin plate: mass, kg, radius, m, and tilt α of its normal from the shaft, rad, from 0 to less than π/2.
    ///
    /// # Errors
    /// [`InvalidEngine`] if a number breaks its rule.
    pub fn thin(mass: f64, radius: f64, tilt: f64) -> Result<Self, InvalidEngine> {
        Self::thick(mass, radius, 0.0, tilt)
    }

    /// A plate of some thickness, m.
    ///
    /// # Errors
    /// As [`Plate::thin`].
    pub fn thick(mass: f64, radius: f64, thickness: f64, tilt: f64) -> Result<Self, InvalidEngine> {
        InvalidQuantity::check_not_negative("tilt", tilt, "rad")?;
        InvalidQuantity::require(tilt < FRAC_PI_2, "tilt", tilt, "rad", Rule::LessThan(FRAC_PI_2))?;
        let moments = Body::cylinder(mass, crate::inertia::Cylinder { radius, height: thickness })?.moments();
        let [across, _, along] = moments.to_array(); // eq:plate-moments
        let (sin, cos) = tilt.sin_cos();
        Ok(Self { moments, across, along, tilt, sin, cos })
    }

    /// The tilt α, rad.
    pub fn tilt(&self) -> f64 {
        self.tilt
    }

    /// The principal moments; axis 3 is the normal.
    pub fn moments(&self) -> PrincipalMoments {
        self.moments
    }

    /// The angular velocity of the spin `spin`, rad/s, along the plate's principal axes (`eq:plate-spin`).
    pub fn spin_body(&self, spin: f64) -> Vector3<f64> {
        Vector3::new(self.sin, 0.0, self.cos) * spin
    }

    /// The angular momentum about the centre along the plate's principal axes, kg·m²/s (`eq:plate-momentum`).
    pub fn angular_momentum_body(&self, spin: f64) -> Vector3<f64> {
        self.moments.angular_momentum(&self.spin_body(spin))
    }

    /// The angular momentum about the centre along the rotating axes x', y', z, kg·m²/s (`eq:plate-transverse`).
    ///
    /// The part across the shaft is formed from the difference of the moments, and keeps its digits at every tilt. The difference
    /// itself has as many as the moments leave it: few for a plate of nearly √3 times its radius.
    pub fn angular_momentum_rotating(&self, spin: f64) -> Vector3<f64> {
        let along_shaft = self.along * self.cos * self.cos + self.across * self.sin * self.sin;
        Vector3::new(-self.unbalance(), 0.0, along_shaft) * spin
    }

    /// `ΔI sin α cos α`, kg·m².
    fn unbalance(&self) -> f64 {
        (self.along - self.across) * self.sin * self.cos
    }

    /// The angle β from the shaft to the angular momentum, rad; positive on the side of the normal, negative for a plate
    /// that is thicker than √3 times its radius (`eq:momentum-tilt`).
    pub fn momentum_angle(&self) -> f64 {
        let momentum = self.angular_momentum_rotating(1.0);
        (-momentum.x).atan2(momentum.z)
    }

    /// The angle β of largest size of any tilt, rad, and the tilt that has it, rad: `sin β = (I₃ − I₁)/(I₃ + I₁)` at
    /// `tan² α = I₃/I₁` (`eq:largest-momentum-tilt`).
    pub fn largest_momentum_angle(&self) -> (f64, f64) {
        let sine = (self.along - self.across) / (self.along + self.across);
        (sine.asin(), (self.along / self.across).sqrt().atan())
    }

    /// The torque that the bearings give the turning plate, along the rotating axes, N·m: `ω × L` (`eq:bearing-torque`).
    pub fn bearing_torque_rotating(&self, spin: f64) -> Vector3<f64> {
        Vector3::new(0.0, spin, 0.0) * self.angular_momentum_rotating(spin).x
    }
}

/// A sum over so many pistons takes less than a tenth of a millisecond.
const MOST_PISTONS: u32 = 1000;

/// Pistons of equal mass, evenly spaced round the shaft, their rods pressed against the plate.
///
/// Piston n of N stands at the azimuth `2πn/N − π/2`. A rod's end keeps its distance from the shaft and stays on the plate's
/// middle plane; a thick plate adds a constant length, which changes nothing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pistons {
    count: u32,
    mass: f64,
    distance: f64,
    rod: f64,
}

impl Pistons {
    /// `count` pistons, from one to a thousand, each of `mass`, kg, at `distance`, m, from the shaft, with centres `rod`, m, below the
    /// rods' ends.
    ///
    /// # Errors
    /// [`InvalidEngine`] for no piston or too many, a negative mass or rod, a distance that is not positive, or a number that is not
    /// finite.
    pub fn new(count: u32, mass: f64, distance: f64, rod: f64) -> Result<Self, InvalidEngine> {
        if count == 0 {
            return Err(InvalidEngine::NoPistons);
        }
        if count > MOST_PISTONS {
            return Err(InvalidEngine::TooManyPistons { count });
        }
        InvalidQuantity::check_not_negative("piston mass", mass, "kg")?;
        InvalidQuantity::check_positive("distance of the pistons", distance, "m")?;
        InvalidQuantity::check_not_negative("rod length", rod, "m")?;
        Ok(Self { count, mass, distance, rod })
    }

    /// How many there are.
    pub fn count(&self) -> u32 {
        self.count
    }

    /// The mass of each, kg.
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// The same with another mass each, kg.
    ///
    /// # Errors
    /// As [`Pistons::new`].
    pub fn with_mass(self, mass: f64) -> Result<Self, InvalidEngine> {
        Self::new(self.count, mass, self.distance, self.rod)
    }
}

/// A plate with its pistons.
///
/// ```
/// use mechanics::scenes::wobble_plate::{Engine, Pistons, Plate};
/// let plate = Plate::thin(2.0, 0.1, 0.4)?;
/// let pistons = Pistons::new(4, 0.3, 0.07, 0.2)?;
/// let balanced = Engine::new(plate, pistons.with_mass(plate.balancing_mass(&pistons)?)?);
/// // Balanced means that the frame feels nothing, at any phase.
/// assert!(balanced.frame_torque(1.0, 100.0).norm() < 1e-14 * 100.0 * 100.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Engine {
    plate: Plate,
    pistons: Pistons,
    slope: f64, // tan α
}

impl Plate {
    /// The mass of each piston, kg, with which the pistons balance the plate: `2ΔI cos²α/(N r²)` (`eq:many-pistons`, with
    /// `eq:thick-plate`; for four pistons and a thin plate `eq:balancing-mass`). The
    /// present mass of the pistons plays no part.
    ///
    /// # Errors
    /// [`NoBalance`] for fewer than three pistons, and for a plate so thick that its momentum leans the other way.
    pub fn balancing_mass(&self, pistons: &Pistons) -> Result<f64, NoBalance> {
        if pistons.count < 3 {
            return Err(NoBalance::TooFewPistons { count: pistons.count });
        }
        let difference = self.along - self.across;
        if difference < 0.0 {
            return Err(NoBalance::ThickPlate { across: self.across, along: self.along });
        }
        let count = f64::from(pistons.count);
        Ok(2.0 * difference * self.cos * self.cos / (count * pistons.distance * pistons.distance))
    }
}

impl Engine {
    /// The plate with its pistons.
    pub fn new(plate: Plate, pistons: Pistons) -> Self {
        Self { plate, pistons, slope: plate.tilt.tan() }
    }

    /// The plate.
    pub fn plate(&self) -> Plate {
        self.plate
    }

    /// The pistons.
    pub fn pistons(&self) -> Pistons {
        self.pistons
    }

    /// The azimuth of piston `n`, counted from 1 and modulo N, as sine and cosine of `2πn/N`.
    fn azimuth(&self, n: u32) -> (f64, f64) {
        (TAU * f64::from(n) / f64::from(self.pistons.count)).sin_cos()
    }

    /// Where the rod of piston `n` touches the plate's middle plane at a phase ωt, rad, in the room, m (`eq:contact`).
    pub fn contact(&self, n: u32, phase: f64) -> Vector3<f64> {
        let Pistons { distance, .. } = self.pistons;
        let ((sin, cos), (sin_phase, cos_phase)) = (self.azimuth(n), phase.sin_cos());
        let rise = self.slope * (sin * cos_phase - cos * sin_phase);
        Vector3::new(sin, -cos, rise) * distance
    }

    /// The centre of piston `n` at a phase ωt, rad, in the room, m (`eq:piston-centre`).
    pub fn centre(&self, n: u32, phase: f64) -> Vector3<f64> {
        self.contact(n, phase) - Vector3::new(0.0, 0.0, self.pistons.rod)
    }

    /// The velocity of piston `n` along the shaft, m/s, at a phase, rad, and a spin, rad/s (`eq:piston-velocity`).
    pub fn velocity(&self, n: u32, phase: f64, spin: f64) -> f64 {
        let ((sin, cos), (sin_phase, cos_phase)) = (self.azimuth(n), phase.sin_cos());
        -spin * self.pistons.distance * self.slope * (cos * cos_phase + sin * sin_phase)
    }

    /// The acceleration of piston `n` along the shaft, m/s²: `−ω²` times its height above the middle.
    pub fn acceleration(&self, n: u32, phase: f64, spin: f64) -> f64 {
        -spin * spin * self.contact(n, phase).z
    }

    /// The angular momentum of the pistons about the plate's centre, in the room, kg·m²/s (`eq:piston-momentum`). It has no
    /// part along the shaft.
    pub fn piston_momentum(&self, phase: f64, spin: f64) -> Vector3<f64> {
        self.piston_sum(|n| self.velocity(n, phase, spin))
    }

    /// The angular momentum of plate and pistons about the plate's centre, in the room, kg·m²/s.
    pub fn angular_momentum(&self, phase: f64, spin: f64) -> Vector3<f64> {
        in_room(&self.plate.angular_momentum_rotating(spin), phase) + self.piston_momentum(phase, spin)
    }

    /// The torque about the plate's centre that the frame gives plate and pistons, through bearings and cylinder walls together,
    /// in the room, N·m: the rate of [`Engine::angular_momentum`]. For three and more pistons its length is `eq:residual-torque`.
    ///
    /// At the balancing mass at most 2e-15 of the plate's own torque is left, up to ten pistons and a tilt of 89.99°; 1e-14 for more
    /// pistons.
    pub fn frame_torque(&self, phase: f64, spin: f64) -> Vector3<f64> {
        in_room(&self.plate.bearing_torque_rotating(spin), phase)
            + self.piston_sum(|n| self.acceleration(n, phase, spin))
    }

    /// `Σ r × m v` for velocities, or anything else, along the shaft.
    fn piston_sum(&self, along_shaft: impl Fn(u32) -> f64) -> Vector3<f64> {
        let Pistons { count, mass, distance, .. } = self.pistons;
        let arms = (1..=count).map(|n| {
            let (sin, cos) = self.azimuth(n);
            Vector3::new(-cos, -sin, 0.0) * along_shaft(n)
        });
        arms.sum::<Vector3<f64>>() * (mass * distance)
    }

    /// The force along the shaft that moves the pistons, N; zero for two and more (`eq:shaking-force`).
    pub fn shaking_force(&self, phase: f64, spin: f64) -> f64 {
        let sum: f64 = (1..=self.pistons.count).map(|n| self.acceleration(n, phase, spin)).sum();
        self.pistons.mass * sum
    }

    /// The kinetic energy of the pistons, J; `¼N m ω² r² tan²α`, constant, for three and more (`eq:piston-energy`).
    pub fn piston_energy(&self, phase: f64, spin: f64) -> f64 {
        let squares: f64 = (1..=self.pistons.count).map(|n| self.velocity(n, phase, spin).powi(2)).sum();
        0.5 * self.pistons.mass * squares
    }

    /// The torque about the shaft that moves the pistons at constant spin, N·m; zero for three and more.
    pub fn drive_torque(&self, phase: f64, spin: f64) -> f64 {
        let power: f64 = (1..=self.pistons.count)
            .map(|n| self.velocity(n, phase, 1.0) * self.acceleration(n, phase, spin))
            .sum();
        self.pistons.mass * power
    }
}

/// Components along x', y', z as components in the room at a phase, rad.
pub fn in_room(rotating: &Vector3<f64>, phase: f64) -> Vector3<f64> {
    let (sin, cos) = phase.sin_cos();
    Vector3::new(rotating.x * cos - rotating.y * sin, rotating.x * sin + rotating.y * cos, rotating.z)
}

/// Why there is no such plate or set of pistons.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum InvalidEngine {
    /// A number breaks a rule.
    Quantity(InvalidQuantity),
    /// There is no piston.
    NoPistons,
    /// There are more than a thousand pistons.
    TooManyPistons {
        /// How many.
        count: u32,
    },
}

impl From<InvalidQuantity> for InvalidEngine {
    fn from(error: InvalidQuantity) -> Self {
        Self::Quantity(error)
    }
}

impl fmt::Display for InvalidEngine {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Quantity(error) => error.fmt(out),
            Self::NoPistons => write!(out, "0 pistons: an engine has at least one"),
            Self::TooManyPistons { count } => {
                write!(
                    out,
                    "{count} pistons: an engine has at most {MOST_PISTONS}, as sums run over all of them"
                )
            }
        }
    }
}

impl Error for InvalidEngine {}

/// Why no mass of the pistons balances the plate.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum NoBalance {
    /// One or two pistons have an angular momentum that swings to and fro and does not turn with the plate.
    TooFewPistons {
        /// How many there are.
        count: u32,
    },
    /// The plate's moment along its axis is the smaller one: its angular momentum leans to the same side as that of pistons.
    ThickPlate {
        /// The moment across the axis, kg·m².
        across: f64,
        /// The moment along it, kg·m².
        along: f64,
    },
}

impl fmt::Display for NoBalance {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::TooFewPistons { count } => {
                let plural = if count == 1 { "" } else { "s" };
                write!(out, "{count} piston{plural} cannot balance a turning plate; it takes at least 3")
            }
            Self::ThickPlate { across, along } => write!(
                out,
                "the plate's moment across its axis, {} kg·m², exceeds that along it, {} kg·m²; no mass of pistons balances it",
                Shown(across),
                Shown(along)
            ),
        }
    }
}

impl Error for NoBalance {}
