//! What can be wrong with a label.

use std::error::Error;
use std::fmt;

/// A label that cannot be set. Nothing is ever dropped silently.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum LabelError {
    /// A command that is not one of `tex_commands`.
    UnknownCommand {
        /// The whole label.
        label: String,
        /// The command, with its backslash.
        command: String,
    },
    /// A character that the tables do not hold.
    UnknownCharacter {
        /// The whole label.
        label: String,
        /// The character.
        character: char,
    },
    /// A `$`, `{` or `}` without its partner.
    Unbalanced {
        /// The whole label.
        label: String,
        /// The delimiter that has no partner.
        delimiter: char,
    },
    /// A formula that is not in the table of a program without a typesetter.
    NotSet {
        /// The whole label.
        label: String,
        /// The formula.
        formula: String,
    },
    /// A command, `^` or `_` without what it applies to, or with two of the same.
    Incomplete {
        /// The whole label.
        label: String,
        /// The command or sign.
        command: String,
    },
}

impl fmt::Display for LabelError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownCommand { label, command } => {
                write!(out, "label `{label}`: unknown command `{command}`")
            }
            Self::UnknownCharacter { label, character } => {
                let code = u32::from(*character);
                write!(out, "label `{label}`: no glyph for `{character}` (U+{code:04X})")
            }
            Self::Unbalanced { label, delimiter } => {
                write!(out, "label `{label}`: `{delimiter}` without its partner")
            }
            Self::NotSet { label, formula } => {
                write!(out, "label `{label}`: `{formula}` was not set beforehand")
            }
            Self::Incomplete { label, command } => {
                write!(out, "label `{label}`: `{command}` lacks what it applies to, or has it twice")
            }
        }
    }
}

impl Error for LabelError {}
