//! What bodies are, how they stand, and how any of them turns or rolls: the physics that scenes share.

pub mod attitude;
pub mod euler;
pub mod free_rotation;
pub mod geometric;
pub mod inertia;
pub mod rolling;
