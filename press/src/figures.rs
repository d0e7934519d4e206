//! The figures, as the build script rendered them.

use std::path::Path;
use std::{fs, io};

/// One rendered figure.
#[derive(Debug, Clone, Copy)]
pub struct Figure {
    /// Its label: `fig:machine`.
    pub id: &'static str,
    /// The folder of the chapter that draws it: `laundromat`.
    pub chapter: &'static str,
    /// What it shows, in a few words.
    pub title: &'static str,
    /// SVG for a page, coloured by the page's style sheet.
    pub svg: &'static str,
    /// SVG that stands alone, for slides.
    pub standalone: &'static str,
}

include!(concat!(env!("OUT_DIR"), "/figures.rs"));

impl Figure {
    /// The ids in its SVG.
    pub(crate) fn ids(&self) -> impl Iterator<Item = &'static str> {
        self.svg.split(" id=\"").skip(1).filter_map(|rest| rest.split('"').next())
    }

    /// The name of its file: `machine.svg`.
    pub fn file_name(&self) -> String {
        format!("{}.svg", self.id.trim_start_matches("fig:"))
    }
}

/// Writes every figure into `folder` as a standalone SVG file; returns how many there are.
///
/// # Errors
/// If the folder or a file cannot be written.
pub fn write_all(folder: &Path) -> io::Result<usize> {
    fs::create_dir_all(folder)?;
    for figure in ALL {
        fs::write(folder.join(figure.file_name()), figure.standalone)?;
    }
    Ok(ALL.len())
}
