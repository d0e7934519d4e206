//! `cargo book measure`: runs the library beside its peers, a package of its own, for the report "Speed and accuracy".

use std::env;
use std::path::Path;
use std::process::Command;

/// Hands its arguments on; `--help` says which there are.
pub(crate) fn measure(root: &Path, arguments: &[String]) -> Result<(), String> {
    let status = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
        .args(["run", "--quiet", "--release", "--locked"])
        .args(["--manifest-path", "benches/peers/Cargo.toml", "--target-dir", "target/peers", "--"])
        .args(arguments)
        .current_dir(root)
        .status()
        .map_err(|error| format!("error: Cargo cannot be run: {error}"))?;
    if status.success() { Ok(()) } else { Err("nothing was measured".to_owned()) }
}
