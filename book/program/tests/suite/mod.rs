//! The tests of the library as tokens, in which comments and the insides of strings do not show.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

struct Function {
    /// The file or folder of tests to which it belongs: one crate.
    part: String,
    runs_as_test: bool,
    body: Group,
    /// What its file imports from the library.
    imports: BTreeSet<String>,
}

/// All functions of the tests, by name. Helpers of two parts may share a name, tests may not.
pub(crate) struct Suite(BTreeMap<String, Vec<Function>>);

/// The tests below a folder.
pub(crate) fn read(folder: &Path) -> Suite {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).expect("the folder of tests") {
        let path = entry.expect("an entry").path();
        let part = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let paths = if path.is_dir() {
            fs::read_dir(&path).expect("a folder").map(|entry| entry.expect("an entry").path()).collect()
        } else {
            vec![path]
        };
        for path in paths.into_iter().filter(|path| path.extension().is_some_and(|ending| ending == "rs")) {
            files.push((part.clone(), fs::read_to_string(path).expect("a test")));
        }
    }
    let suite = Suite::of(files.iter().map(|(part, text)| (part.as_str(), text.as_str())));
    let tests = suite.0.values().flatten().filter(|function| function.runs_as_test).count();
    assert!(tests > 200, "only {tests} tests were found");
    suite
}

impl Suite {
    /// From texts of Rust, each with the part to which it belongs.
    pub(crate) fn of<'a>(files: impl IntoIterator<Item = (&'a str, &'a str)>) -> Self {
        let mut suite = Self(BTreeMap::new());
        for (part, text) in files {
            let tokens: Vec<TokenTree> = text
                .parse::<TokenStream>()
                .unwrap_or_else(|_| panic!("{part} is no Rust"))
                .into_iter()
                .collect();
            suite.add(part, &tokens);
        }
        suite
    }

    fn add(&mut self, part: &str, tokens: &[TokenTree]) {
        let imports = imports(tokens);
        let mut attributes = Vec::new();
        let mut at = 0;
        while at < tokens.len() {
            match &tokens[at..] {
                [TokenTree::Punct(hash), TokenTree::Group(attribute), ..] if hash.as_char() == '#' => {
                    attributes.push(attribute.stream().to_string());
                    at += 2;
                }
                [TokenTree::Ident(word), TokenTree::Ident(name), rest @ ..] if word == "fn" => {
                    let brace = |token: &TokenTree| match token {
                        TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => {
                            Some(group.clone())
                        }
                        _ => None,
                    };
                    let body = rest.iter().find_map(brace).expect("a body");
                    let runs_as_test = attributes.iter().any(|a| a == "test")
                        && !attributes.iter().any(|a| a.starts_with("ignore"));
                    let function =
                        Function { part: part.to_owned(), runs_as_test, body, imports: imports.clone() };
                    self.0.entry(name.to_string()).or_default().push(function);
                    attributes.clear();
                    at += 2;
                }
                [TokenTree::Group(block), ..] if block.delimiter() == Delimiter::Brace => {
                    attributes.clear();
                    at += 1;
                }
                _ => at += 1,
            }
        }
    }

    fn test(&self, name: &str) -> Result<&Function, String> {
        let named = self.0.get(name).map(Vec::as_slice).unwrap_or_default();
        match named {
            [function] if function.runs_as_test => Ok(function),
            [] => Err(format!("the test `{name}` does not exist")),
            [_] => Err(format!("`{name}` is no test that runs")),
            _ => Err(format!("there are {} functions `{name}`", named.len())),
        }
    }

    /// That the test runs, asserts something, and reaches the library, itself or through the functions of its
    /// part that it calls.
    pub(crate) fn proves(&self, name: &str) -> Result<(), String> {
        let test = self.test(name)?;
        let (mut asserts, mut reaches) = (false, false);
        let (mut seen, mut open) = (BTreeSet::new(), vec![test]);
        while let Some(function) = open.pop() {
            for word in words(function.body.stream()) {
                asserts |= word.starts_with("assert") || word == "corrected_holds_and_printed_fails";
                reaches |= word == "mechanics" || function.imports.contains(&word);
                if seen.insert(word.clone()) {
                    open.extend(self.0.get(&word).into_iter().flatten().filter(|f| f.part == test.part));
                }
            }
        }
        match (asserts, reaches) {
            (false, _) => Err(format!("the test `{name}` asserts nothing")),
            (_, false) => Err(format!("the test `{name}` does not reach the library")),
            _ => Ok(()),
        }
    }

    /// That the test binds `corrected` and `printed`, uses both, and has them compared with the truth.
    pub(crate) fn sees_the_printed_form_fail(&self, name: &str) -> Result<(), String> {
        let body = words(self.test(name)?.body.stream());
        for form in ["corrected", "printed"] {
            // `let printed = …`, or `let (corrected, printed) = …`.
            let bound = (0..body.len())
                .any(|at| body[at] == "let" && (body[at + 1..].iter().take(2).any(|word| word == form)));
            let uses = body.iter().filter(|word| *word == form).count();
            if !bound || uses < 2 {
                return Err(format!("the test `{name}` does not hold the {form} form: bind it to `{form}`"));
            }
        }
        if !body.iter().any(|word| word == "corrected_holds_and_printed_fails") {
            return Err(format!("the test `{name}` does not see the printed form fail"));
        }
        Ok(())
    }
}

/// The identifiers of a stream, those of its groups among them, in order.
fn words(stream: TokenStream) -> Vec<String> {
    stream
        .into_iter()
        .flat_map(|token| match token {
            TokenTree::Group(group) => words(group.stream()),
            TokenTree::Ident(word) => vec![word.to_string()],
            _ => Vec::new(),
        })
        .collect()
}

/// The names that `use mechanics::…;` brings into a file.
fn imports(tokens: &[TokenTree]) -> BTreeSet<String> {
    tokens
        .windows(2)
        .enumerate()
        .filter(|(_, pair)| {
            matches!(pair, [TokenTree::Ident(word), TokenTree::Ident(name)] if word == "use" && name == "mechanics")
        })
        .flat_map(|(at, _)| {
            let end = |token: &&TokenTree| !matches!(token, TokenTree::Punct(p) if p.as_char() == ';');
            words(tokens[at + 2..].iter().take_while(end).cloned().collect())
        })
        .collect()
}
