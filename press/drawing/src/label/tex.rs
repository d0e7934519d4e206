//! The TeX subset of the labels, read into a tree. The converter of the pages gives MathML, which leaves it to browsers
//! what is an operation, a relation or a bracket, and the layout of labels has to know that.

use super::{no_glyph, unbalanced};
use std::fmt::Display;

/// What TeX knows a symbol as, which decides the space around it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Class {
    Ordinary,
    Operator,
    Binary,
    Relation,
    Open,
    Close,
    Punctuation,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) enum Node {
    Symbol(Class, char),
    /// Upright letters: `\sin`, `\text{…}`.
    Word(Class, String),
    Row(Vec<Node>),
    Script {
        base: Box<Node>,
        below: Option<Box<Node>>,
        above: Option<Box<Node>>,
    },
    /// A combining accent over its base.
    Accent(char, Box<Node>),
    Root(Box<Node>),
    Fraction(Box<Node>, Box<Node>),
    /// A thin space.
    Space,
}

/// How letters are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Alphabet {
    Italic,
    Bold,
    BoldItalic,
}

use Class::{Binary, Close, Open, Operator, Ordinary, Punctuation, Relation};

/// Commands that stand for one character.
const SYMBOLS: [(&str, Class, char); 22] = [
    ("alpha", Ordinary, 'α'),
    ("beta", Ordinary, 'β'),
    ("gamma", Ordinary, 'γ'),
    ("delta", Ordinary, 'δ'),
    ("theta", Ordinary, 'θ'),
    ("lambda", Ordinary, 'λ'),
    ("pi", Ordinary, 'π'),
    ("sigma", Ordinary, 'σ'),
    ("tau", Ordinary, 'τ'),
    ("phi", Ordinary, 'ϕ'),
    ("varphi", Ordinary, 'φ'),
    ("zeta", Ordinary, 'ζ'),
    ("ell", Ordinary, 'ℓ'),
    ("chi", Ordinary, 'χ'),
    ("psi", Ordinary, 'ψ'),
    ("omega", Ordinary, 'ω'),
    ("Gamma", Ordinary, 'Γ'),
    ("Lambda", Ordinary, 'Λ'),
    ("Omega", Ordinary, 'Ω'),
    ("perp", Relation, '⊥'),
    ("lvert", Open, '|'),
    ("rvert", Close, '|'),
];

const FUNCTIONS: [&str; 3] = ["sin", "cos", "tan"];

const ACCENTS: [(&str, char); 2] = [("hat", '\u{302}'), ("dot", '\u{307}')];

const ALPHABETS: [(&str, Alphabet); 2] = [("mathbf", Alphabet::Bold), ("boldsymbol", Alphabet::BoldItalic)];

/// The commands of the TeX subset, without their backslashes.
pub fn tex_commands() -> impl Iterator<Item = &'static str> {
    let signs = SYMBOLS.iter().map(|command| command.0).chain(FUNCTIONS);
    let changes = ACCENTS.iter().map(|command| command.0).chain(ALPHABETS.iter().map(|command| command.0));
    signs.chain(changes).chain([",", "sqrt", "tfrac", "text"])
}

/// Reads mathematics: what stands between two `$`.
pub(super) fn parse(mathematics: &str) -> Result<Node, String> {
    let mut reader = Reader { rest: mathematics };
    let row = reader.row(Alphabet::Italic)?;
    if reader.rest.is_empty() { Ok(row) } else { Err(unbalanced('}')) }
}

/// A command, `^` or `_` without what it applies to, or with two of the same.
fn incomplete(command: impl Display) -> String {
    format!("`{command}` lacks what it applies to, or has it twice")
}

struct Reader<'a> {
    rest: &'a str,
}

impl<'a> Reader<'a> {
    fn peek(&self) -> Option<char> {
        self.rest.chars().next()
    }

    fn take(&mut self) -> Option<char> {
        let next = self.peek()?;
        self.rest = &self.rest[next.len_utf8()..];
        Some(next)
    }

    /// Everything up to the end or to a closing brace, which stays.
    fn row(&mut self, alphabet: Alphabet) -> Result<Node, String> {
        let mut nodes: Vec<Node> = Vec::new();
        while let Some(next) = self.peek() {
            match next {
                '}' => break,
                ' ' => {
                    self.take();
                }
                '^' | '_' | '\'' => {
                    let base = nodes.pop().ok_or_else(|| incomplete(next))?;
                    nodes.push(self.scripts(base, alphabet)?);
                }
                _ => {
                    let node = self.item(alphabet)?;
                    nodes.push(node);
                }
            }
        }
        Ok(match <[Node; 1]>::try_from(nodes) {
            Ok([single]) => single,
            Err(nodes) => Node::Row(nodes),
        })
    }

    fn scripts(&mut self, base: Node, alphabet: Alphabet) -> Result<Node, String> {
        let (mut below, mut above, mut primes) = (None, None, 0);
        while let Some(sign @ ('^' | '_' | '\'')) = self.peek() {
            self.take();
            let slot = match sign {
                '\'' => {
                    primes += 1;
                    continue;
                }
                '^' => &mut above,
                _ => &mut below,
            };
            if slot.is_some() {
                return Err(incomplete(sign));
            }
            *slot = Some(Box::new(self.argument(&sign.to_string(), alphabet)?));
        }
        if primes > 0 {
            let mut nodes = vec![Node::Symbol(Ordinary, '′'); primes];
            nodes.extend(above.take().map(|node| *node));
            above = Some(Box::new(Node::Row(nodes)));
        }
        Ok(Node::Script { base: Box::new(base), below, above })
    }

    /// What a command or sign applies to: a group in braces or one item.
    fn argument(&mut self, command: &str, alphabet: Alphabet) -> Result<Node, String> {
        while self.peek() == Some(' ') {
            self.take();
        }
        match self.peek() {
            None | Some('}' | '^' | '_') => Err(incomplete(command)),
            Some(_) => self.item(alphabet),
        }
    }

    fn item(&mut self, alphabet: Alphabet) -> Result<Node, String> {
        let Some(next) = self.take() else { return Err(incomplete("")) };
        Ok(match next {
            '{' => {
                let row = self.row(alphabet)?;
                match self.take() {
                    // In braces a sign is no operation: `{-}` takes no room around it.
                    Some('}') if matches!(row, Node::Symbol(class, _) if class != Ordinary) => {
                        Node::Row(vec![row])
                    }
                    Some('}') => row,
                    _ => return Err(unbalanced('{')),
                }
            }
            '\\' => return self.command(alphabet),
            'a'..='z' | 'A'..='Z' => Node::Symbol(Ordinary, letter(next, alphabet)),
            '0'..='9' => Node::Symbol(Ordinary, digit(next, alphabet)),
            '+' => Node::Symbol(Binary, '+'),
            '-' | '−' => Node::Symbol(Binary, '−'),
            '=' | '<' | '>' => Node::Symbol(Relation, next),
            '(' | '[' => Node::Symbol(Open, next),
            ')' | ']' => Node::Symbol(Close, next),
            ',' | ';' => Node::Symbol(Punctuation, next),
            '/' | '|' | '.' | '!' | '°' => Node::Symbol(Ordinary, next),
            ':' => Node::Symbol(Relation, next),
            character => return Err(no_glyph(character)),
        })
    }

    fn command(&mut self, alphabet: Alphabet) -> Result<Node, String> {
        let letters = self.rest.chars().take_while(char::is_ascii_alphabetic).count();
        let length = if letters > 0 { letters } else { self.peek().map_or(0, char::len_utf8) };
        let (name, rest) = self.rest.split_at(length);
        self.rest = rest;
        let full = format!("\\{name}");
        if let Some(&(_, class, character)) = SYMBOLS.iter().find(|symbol| symbol.0 == name) {
            return Ok(Node::Symbol(class, letter(character, alphabet)));
        }
        if FUNCTIONS.contains(&name) {
            return Ok(Node::Word(Operator, name.into()));
        }
        if let Some(&(_, accent)) = ACCENTS.iter().find(|accent| accent.0 == name) {
            return Ok(Node::Accent(accent, Box::new(self.argument(&full, alphabet)?)));
        }
        if let Some(&(_, other)) = ALPHABETS.iter().find(|entry| entry.0 == name) {
            return self.argument(&full, other);
        }
        match name {
            "," => Ok(Node::Space),
            "sqrt" => Ok(Node::Root(Box::new(self.argument(&full, alphabet)?))),
            "tfrac" => {
                let above = self.argument(&full, alphabet)?;
                Ok(Node::Fraction(Box::new(above), Box::new(self.argument(&full, alphabet)?)))
            }
            "text" => self.words(&full),
            _ => Err(format!("unknown command `{full}`")),
        }
    }

    /// `\text{…}`: upright letters as they stand.
    fn words(&mut self, command: &str) -> Result<Node, String> {
        let inner: &'a str = self.rest.strip_prefix('{').ok_or_else(|| incomplete(command))?;
        let (words, rest) = inner.split_once('}').ok_or_else(|| unbalanced('{'))?;
        self.rest = rest;
        Ok(Node::Word(Ordinary, words.into()))
    }
}

/// The character that shows a letter in an alphabet. Greek capitals are upright unless bold, as TeX has them.
fn letter(plain: char, alphabet: Alphabet) -> char {
    let shifted = |start: u32, first: char| {
        char::from_u32(start + (u32::from(plain) - u32::from(first))).unwrap_or(plain)
    };
    match (alphabet, plain) {
        (Alphabet::Italic, 'h') => 'ℎ',
        (Alphabet::Italic, 'A'..='Z') => shifted(0x1d434, 'A'),
        (Alphabet::Italic, 'a'..='z') => shifted(0x1d44e, 'a'),
        (Alphabet::Italic, 'α'..='ω') => shifted(0x1d6fc, 'α'),
        (Alphabet::Italic, 'ϕ') => '\u{1d719}',
        (Alphabet::Bold, 'A'..='Z') => shifted(0x1d400, 'A'),
        (Alphabet::Bold, 'a'..='z') => shifted(0x1d41a, 'a'),
        (Alphabet::Bold | Alphabet::BoldItalic, 'Α'..='Ω') => shifted(0x1d6a8, 'Α'),
        (Alphabet::BoldItalic, 'A'..='Z') => shifted(0x1d468, 'A'),
        (Alphabet::BoldItalic, 'a'..='z') => shifted(0x1d482, 'a'),
        (Alphabet::Bold | Alphabet::BoldItalic, 'α'..='ω') => shifted(0x1d736, 'α'),
        (Alphabet::Bold | Alphabet::BoldItalic, 'ϕ') => '\u{1d753}',
        _ => plain,
    }
}

fn digit(plain: char, alphabet: Alphabet) -> char {
    match alphabet {
        Alphabet::Bold | Alphabet::BoldItalic => {
            char::from_u32(0x1d7ce + (u32::from(plain) - u32::from('0'))).unwrap_or(plain)
        }
        Alphabet::Italic => plain,
    }
}
