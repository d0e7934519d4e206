//! Labels: what is set where, and what is refused.

use drawing::{Label, Piece, Segment, Side, at, tex_commands};

fn label(source: &str) -> Label {
    Label::new(source, 14.0).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn every_command_of_the_subset_sets_ink() {
    assert!(tex_commands().count() > 25);
    let without = label("$a{x}{y}b$");
    for command in tex_commands() {
        let set = label(&format!(r"$a\{command}{{x}}{{y}}b$"));
        assert!(set.pieces != without.pieces, r"\{command} changes nothing");
    }
    assert!(label(r"$\hat{\boldsymbol{r}}$").bounds.width() > 5.0);
}

#[test]
fn what_is_not_understood_is_refused_with_its_name() {
    for (source, why) in [
        (r"$\omga$", r"unknown command `\omga`"),
        ("naïve Ω", "no glyph for `Ω` (U+03A9)"),
        ("$ω$", "no glyph for `ω` (U+03C9)"),
        (r"$\text{é}$", "no glyph for `é` (U+00E9)"),
        ("$x", "`$` without its partner"),
        ("$x^{2$", "`{` without its partner"),
        ("$x}$", "`}` without its partner"),
        (r"$\text{x$", "`{` without its partner"),
        ("10^{2", "`{` without its partner"),
        ("a}b", "`}` without its partner"),
        ("$^2$", "`^` lacks what it applies to, or has it twice"),
        ("$x_$", "`_` lacks what it applies to, or has it twice"),
        ("$x^2^3$", "`^` lacks what it applies to, or has it twice"),
        (r"$\sqrt$", r"`\sqrt` lacks what it applies to, or has it twice"),
        (r"$\tfrac1$", r"`\tfrac` lacks what it applies to, or has it twice"),
    ] {
        let flaw = Label::new(source, 14.0).expect_err(source);
        assert_eq!(flaw.to_string(), format!("label `{source}`: {why}"));
    }
}

#[test]
fn scripts_are_smaller_and_stand_above_and_below() {
    let plain = label("$x$").bounds;
    let squared = label("$x^2$").bounds;
    let indexed = label("$x_0$").bounds;
    assert!(squared.top < plain.top - 3.0 && (squared.bottom - plain.bottom).abs() < 0.5);
    assert!(indexed.bottom > plain.bottom + 1.5 && (indexed.top - plain.top).abs() < 1.0);
    // Both scripts stand over each other, and take the room of the wider one.
    assert!(label("$x_0^2$").width() < label("$x_0{}^2$").width());
    // A script of a script is smaller again.
    let height = |source: &str| label(source).bounds.height();
    assert!(height("$1$") > height("$x^{1}$") - height("$x$"));
    // The order in which they are written does not matter.
    assert_eq!(label("$x_0^2$"), label("$x^2_0$"));
}

#[test]
fn signs_take_room_as_operations_but_not_as_signs() {
    let width = |source: &str| label(source).width();
    assert!(width("$a-b$") > width("${-}ab$") + 3.0, "an operation has room around it");
    assert!((width("$-ab$") - width("${-}ab$")).abs() < 1e-9, "a sign at the beginning has none");
    assert!(width("$a=b$") > width("$a{=}b$") + 3.0);
    assert!((width("$x^{a=b}$") - width("$x^{a{=}b}$")).abs() < 1e-9, "scripts are set tight");
}

#[test]
fn a_root_covers_what_is_under_it() {
    for inner in ["2", r"\omega_0^2", r"\tfrac{a}{b}"] {
        let [root, under] = [label(&format!(r"$\sqrt{{{inner}}}$")), label(&format!("${inner}$"))];
        assert!(root.bounds.top < under.bounds.top - 1.0, "{inner}");
        assert!(root.width() > under.width() + 5.0, "{inner}");
    }
}

#[test]
fn words_keep_the_widths_of_the_pages_sans() {
    // Advance widths of Open Sans, font units of 1/2048 em: s 977, p 1255, i 518, n 1257.
    let expected = (977 + 1255 + 518 + 1257) as f64 / 2048.0 * 14.0;
    let spin = label("spin");
    assert!((spin.width() - expected).abs() < 1e-9);
    let [Piece::Words { text, width, size, .. }] = &spin.pieces[..] else { panic!("one piece of words") };
    assert_eq!((text.as_str(), *size), ("spin", 14.0));
    assert!((width - expected).abs() < 1e-9);
    // A space before mathematics becomes distance.
    let joined = label("spin $x$");
    let space = 532.0 / 2048.0 * 14.0;
    assert!((joined.width() - expected - space - label("$x$").width()).abs() < 1e-9);
    // And the mathematics stands where the words and the space end, then the next words after it.
    let mixed = label("spin $x$ in");
    let [Piece::Words { .. }, Piece::Outline(outline), Piece::Words { start, .. }] = &mixed.pieces[..] else {
        panic!("words, mathematics, words")
    };
    let first = outline[0].points[0];
    assert!(first.x > expected + space - 1.0 && first.x < start.x - space + 1.0, "{first:?}");
    assert!((start.x - joined.width() - space).abs() < 1e-9);
}

#[test]
fn powers_of_ten_are_raised_words() {
    let power = label("10^{−4}");
    let [Piece::Words { start: ten, size: large, .. }, Piece::Words { start: four, size: small, text, .. }] =
        &power.pieces[..]
    else {
        panic!("two pieces")
    };
    assert!(four.y < ten.y - 4.0 && small < large && text == "−4");
}

#[test]
fn labels_stand_on_their_side_of_the_point() {
    let point = at(100.0, 50.0);
    for source in ["spin", "$r_0/b$", r"$\hat{\omega}_3$"] {
        let bounds = |side| label(source).placed(point, side, 6.0).bounds;
        assert!(
            (bounds(Side::Right).left - 106.0).abs() < 1e-9 && (bounds(Side::Left).right - 94.0).abs() < 1e-9
        );
        assert!(
            (bounds(Side::Above).bottom - 44.0).abs() < 1e-9 && (bounds(Side::Below).top - 56.0).abs() < 1e-9
        );
        let corner = bounds(Side::AboveLeft);
        assert!(corner.right < 100.0 && corner.bottom < 50.0);
        assert!((bounds(Side::Over).centre().x - 100.0).abs() < 1e-9);
    }
}

#[test]
fn outlines_are_closed_and_lie_inside_their_bounds() {
    let label = label(r"$\sqrt{2}\,\omega_0^2 = \boldsymbol{L}+\hat{r}''$");
    let mut segments = 0;
    for piece in &label.pieces {
        let Piece::Outline(outline) = piece else { panic!("mathematics only") };
        assert_eq!((outline[0].letter, outline[outline.len() - 1].letter), ('m', 'z'));
        for end in outline.iter().filter_map(|segment| segment.points.last()) {
            assert!(label.bounds.grown(0.02).contains(*end), "{end:?} outside {:?}", label.bounds);
            segments += 1;
        }
    }
    assert!(segments > 100);
}

/// Where the ink of an outline begins and ends, px.
fn extent(outline: &[Segment]) -> [f64; 2] {
    let ends = outline.iter().filter_map(|segment| Some(segment.points.last()?.x));
    ends.fold([f64::INFINITY, f64::NEG_INFINITY], |[left, right], x| [left.min(x), right.max(x)])
}

#[test]
fn outlines_of_words_are_as_wide_as_their_table_says() {
    let [left, right] = extent(&label("H").outline());
    let beyond = label("H").width() - right;
    let mut tried = 0;
    for character in ('\u{20}'..='\u{2fff}').filter(|character| !"^{}$".contains(*character)) {
        // The letters after it begin where the table has it end.
        let Ok(between) = Label::new(&format!("H{character}H"), 14.0) else { continue };
        let [begin, end] = extent(&between.outline());
        assert!((begin - left).abs() < 1e-9, "{character:?} begins at {begin}");
        assert!((between.width() - end - beyond).abs() < 1e-9, "{character:?} ends at {end}");
        // And it has ink of its own, unless it is a space.
        let is_space = between.outline().len() == label("HH").outline().len();
        assert_eq!(is_space, character.is_whitespace(), "{character:?}");
        tried += 1;
    }
    assert!(tried > 100, "{tried} characters");
}

#[test]
fn an_outline_holds_words_raised_words_and_mathematics_where_they_stand() {
    let label = label(r"spin 10^{−4} of $\omega_0$ rad").from_baseline(at(100.0, 50.0));
    let [left, right] = extent(&label.outline());
    // Within the room beside a letter.
    assert!(left > label.bounds.left && left < label.bounds.left + 1.5, "{left}, {:?}", label.bounds);
    assert!(right < label.bounds.right && right > label.bounds.right - 1.5, "{right}, {:?}", label.bounds);
    let mut mathematics = 0;
    for piece in &label.pieces {
        match piece {
            Piece::Outline(own) => {
                assert!(label.outline().windows(own.len()).any(|part| part == own));
                mathematics += 1;
            }
            Piece::Words { text, start, size, .. } => {
                let alone = Label::new(text, *size).expect("a label").from_baseline(*start).outline();
                let rounded = |segment: &Segment| format!("{segment:.6?}");
                let alone: Vec<String> = alone.iter().map(rounded).collect();
                let all: Vec<String> = label.outline().iter().map(rounded).collect();
                assert!(all.windows(alone.len()).any(|part| part == alone), "{text}");
            }
        }
    }
    assert_eq!((mathematics, label.pieces.len()), (1, 5));
}
