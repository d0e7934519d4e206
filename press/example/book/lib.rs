//! The code of the pages: what is listed here is drawn, and what is not, is not.

#[cfg(feature = "figures")]
pub mod figures;
pub mod scenes;
#[cfg(feature = "figures")]
pub mod tables;
