//! Polylines, and the SVG that drawings become.

use crate::distance;
use drawing::kit::{self, Heads, Marker};
use drawing::{Drawing, Fill, Hue, Point, Rect, Role, Shape, Side, Stroke, TOLERANCE, at, clip, simplify};
use roxmltree::Document;

/// A resonance curve with 4000 points.
fn resonance() -> Vec<Point> {
    let value = |x: f64| 300.0 - 6.0 / ((1.0 - x * x).powi(2) + 0.001 * x * x).sqrt();
    (0..4000).map(|k| f64::from(k) / 1333.0).map(|x| at(200.0 * x, value(x))).collect()
}

#[test]
fn thinned_curves_stay_within_their_tolerance_with_far_fewer_points() {
    let curve = resonance();
    let thin = simplify(&curve, TOLERANCE);
    let worst = curve.iter().map(|&point| distance(&thin, point)).fold(0.0, f64::max);
    assert!(worst <= TOLERANCE && worst > 0.2 * TOLERANCE, "{worst}");
    assert!(thin.len() * 20 < curve.len(), "{} points left", thin.len());
    assert_eq!((thin.first(), thin.last()), (curve.first(), curve.last()));
    // A closed curve does not collapse though it ends where it began.
    let circle: Vec<Point> = (0..=360).map(|k| Point::polar(100.0, f64::from(k).to_radians())).collect();
    assert!(simplify(&circle, TOLERANCE).len() > 60);
}

#[test]
fn clipped_curves_end_on_the_edge_and_miss_nothing_inside() {
    let (curve, frame) = (resonance(), Rect::new(20.0, 200.0, 500.0, 99.5));
    let pieces = clip(&curve, &frame);
    assert_eq!(pieces.len(), 2, "the peak leaves through the upper edge");
    for piece in &pieces {
        for &point in piece {
            assert!(frame.grown(1e-9).contains(point), "{point:?}");
            assert!(distance(&curve, point) < 1e-9);
        }
    }
    let inside: Vec<&Point> = curve.iter().filter(|&&point| frame.contains(point)).collect();
    assert!(inside.len() > 1000);
    for &point in inside {
        assert!(pieces.iter().any(|piece| distance(piece, point) < 1e-9), "{point:?} was lost");
    }
    let cut = pieces[0].last().expect("a point");
    assert!((cut.y - 200.0).abs() < 1e-9, "cut at the edge, not before");
}

#[test]
fn clipping_breaks_at_points_that_are_no_numbers() {
    let frame = Rect::new(0.0, 0.0, 100.0, 100.0);
    let broken = [
        at(10.0, 10.0),
        at(20.0, 20.0),
        at(f64::NAN, 0.0),
        at(30.0, 30.0),
        at(40.0, f64::INFINITY),
        at(50.0, 50.0),
    ];
    assert_eq!(clip(&broken, &frame), vec![vec![at(10.0, 10.0), at(20.0, 20.0)]]);
    let beside = [at(-10.0, 10.0), at(-10.0, 90.0), at(-5.0, 200.0)];
    assert!(clip(&beside, &frame).is_empty());
    let across = [at(-50.0, 50.0), at(150.0, 50.0)];
    assert_eq!(clip(&across, &frame), vec![vec![at(0.0, 50.0), at(100.0, 50.0)]]);
}

/// A drawing with everything that the kit has.
fn everything() -> Drawing {
    let mut drawing =
        Drawing::new("fig:all", 300.0, 200.0).titled("All & <more>", "Every \"part\" of the kit.");
    let (left, right) = (at(20.0, 100.0), at(180.0, 60.0));
    kit::spring(&mut drawing, left, right, 8, 12.0, 10.0, Hue::Ink);
    kit::damper(&mut drawing, left, right, 0.24, 14.0, Hue::Ink);
    kit::ground(&mut drawing, left, 3.0, 40.0, Hue::Ink);
    kit::arrow(&mut drawing, left, right, Hue::Orange);
    kit::angle(&mut drawing, right, 30.0, 0.2, 4.0, Heads::Both, Hue::Ink);
    kit::angle(&mut drawing, right, 40.0, 0.2, -1.0, Heads::End, Hue::Ink);
    kit::dimension(&mut drawing, left, right, Heads::Both, Hue::Ink);
    for marker in
        [Marker::Disc, Marker::Square, Marker::Triangle, Marker::Diamond, Marker::Ring, Marker::Mass]
    {
        kit::marker(&mut drawing, at(250.0, 150.0), marker, Hue::Green);
    }
    drawing.disc(at(100.0, 150.0), 20.0, Hue::Blue);
    drawing.name_curve("edge", 1);
    drawing.label(at(100.0, 180.0), Side::Below, r"$\omega_0 < 1$ & more", Hue::Blue).expect("a label");
    drawing
}

#[test]
fn drawings_become_valid_svg_with_classes_in_place_of_colours() {
    let drawing = everything();
    let svg = drawing.to_svg().expect("no flaw");
    let document = Document::parse(&svg).expect("valid XML");
    let root = document.root_element();
    assert_eq!((root.attribute("viewBox"), root.attribute("role")), (Some("1 19 266 192"), Some("img")));
    assert!(root.attribute("width").is_none(), "the page decides how wide it is");
    let text =
        |name: &str| document.descendants().find(|node| node.has_tag_name(name)).and_then(|node| node.text());
    assert_eq!((text("title"), text("desc")), (Some("All & <more>"), Some("Every \"part\" of the kit.")));
    assert_eq!(text("text"), Some("& more"));
    let edge = document.descendants().find(|node| node.attribute("id") == Some("fig-all-edge"));
    assert_eq!(edge.and_then(|node| node.attribute("class")), Some("f-line f-outline f-blue"));
    // Rims of all pieces of a label come before the ink of the first, or they would eat into it.
    let (last_rim, first_ink) = (svg.rfind("f-rim"), svg.find("f-plain f-blue"));
    assert!(last_rim.is_some() && last_rim < first_ink);
    assert_eq!(svg, everything().to_svg().expect("no flaw"), "the same bytes every time");
    assert!(!svg.contains('#') && !svg.contains("NaN") && !svg.contains("inf"));

    let alone = drawing.to_standalone_svg().expect("no flaw");
    let document = Document::parse(&alone).expect("valid XML");
    let root = document.root_element();
    assert_eq!((root.attribute("width"), root.attribute("height")), (Some("266"), Some("192")));
    assert_eq!(root.tag_name().namespace(), Some("http://www.w3.org/2000/svg"));
    assert!(alone.contains("prefers-color-scheme: dark"));
    // It asks for no font, and a program that paints a rim over its letter finds the letter after it.
    for absent in ["<text", "font-", "\"f-text"] {
        assert!(!alone.contains(absent), "{absent} in {alone}");
    }
    let text =
        |name: &str| document.descendants().find(|node| node.has_tag_name(name)).and_then(|node| node.text());
    assert_eq!((text("title"), text("desc")), (Some("All & <more>"), Some("Every \"part\" of the kit.")));
}

/// A panel of this height with one dot.
fn dotted(height: f64, x: f64, y: f64) -> Drawing {
    let mut panel = Drawing::new("", 200.0, height).titled("A dot", "One dot.");
    panel.dot(at(x, y), 3.0, Hue::Blue);
    panel.name_curve("dot", 1);
    panel
}

/// What an attribute of every SVG is.
fn attributes(svg: &str, name: &str) -> Vec<String> {
    let document = format!("<div>{svg}</div>");
    let document = Document::parse(&document).expect("valid XML");
    let drawn = document.descendants().filter(|node| node.has_tag_name("svg"));
    drawn.map(|node| node.attribute(name).unwrap_or_default().to_owned()).collect()
}

#[test]
fn panels_of_equal_height_are_level_and_each_is_cut_to_its_width() {
    let panels = vec![dotted(100.0, 50.0, 20.0), dotted(100.0, 80.0, 70.0), dotted(50.0, 10.0, 20.0)];
    let whole = Drawing::panels("fig:dots", panels);
    let svg = whole.to_svg().expect("no flaw");
    assert_eq!(attributes(&svg, "viewBox"), ["37 7 26 76", "67 7 26 76", "-3 7 26 26"]);
    for id in ["fig-dots-a-dot", "fig-dots-b-dot", "fig-dots-c-title"] {
        assert!(svg.contains(&format!(" id=\"{id}\"")), "{svg}");
    }
    assert_eq!((whole.title(), whole.room()), ("A dot; A dot; A dot", 3.0 * 26.0 + 40.0));
    // Alone, they stand in a row, level at the top.
    let alone = whole.to_standalone_svg().expect("no flaw");
    assert_eq!(attributes(alone.split_once('\n').expect("a head").1, "viewBox"), ["37 7 118 76"]);
    for step in ["0 0", "16 0", "132 0"] {
        assert!(alone.contains(&format!("translate({step})")), "{alone}");
    }
}

#[test]
fn many_panels_stand_in_rows() {
    let panel = || {
        let mut panel = dotted(100.0, 0.0, 0.0);
        panel.line(at(0.0, 0.0), at(379.0, 0.0), Stroke::Outline, Hue::Ink);
        panel
    };
    let alone =
        Drawing::panels("fig:rows", vec![panel(), panel(), panel()]).to_standalone_svg().expect("no flaw");
    for step in ["0 0", "423 0", "0 46"] {
        assert!(alone.contains(&format!("translate({step})")), "{alone}");
    }
}

#[test]
fn a_narrow_layout_has_an_svg_of_its_own_for_narrow_pages_only() {
    let narrow = || Drawing::panels("", vec![dotted(100.0, 5.0, 5.0), dotted(90.0, 5.0, 5.0)]);
    let whole = dotted(100.0, 50.0, 50.0).with_narrow(narrow());
    let svg = whole.to_svg().expect("no flaw");
    assert_eq!(attributes(&svg, "class"), ["drawn wide-only", "drawn narrow", "drawn narrow"]);
    assert!(svg.contains(" id=\"-narrow-b-dot\""), "{svg}");
    assert_eq!((whole.parts().len(), whole.narrow_parts().len(), whole.all_parts().len()), (1, 2, 3));
    assert!(!whole.to_standalone_svg().expect("no flaw").contains("-narrow"));
    // Only one of the panels has a second layout.
    let pair = Drawing::panels("fig:x", vec![whole, dotted(100.0, 5.0, 5.0)]);
    let classes = attributes(&pair.to_svg().expect("no flaw"), "class");
    assert_eq!(classes, ["drawn wide-only", "drawn", "drawn narrow", "drawn narrow"]);
    assert_eq!(pair.narrow_parts().len(), 3);
}

#[test]
fn panels_without_words_leave_them_to_the_first() {
    let mute = || dotted(100.0, 5.0, 5.0).titled("", "");
    let whole = Drawing::panels("fig:mute", vec![mute(), mute()]).titled("Two dots", "A dot and a dot.");
    let svg = whole.with_narrow(mute()).to_svg().expect("no flaw");
    assert_eq!(attributes(&svg, "aria-hidden"), ["", "true", ""]); // the first of each layout speaks
    assert_eq!(svg.matches(">Two dots</title>").count(), 2);
}

#[test]
fn what_lies_in_no_panel_is_refused() {
    let mut whole = Drawing::panels("fig:dots", vec![dotted(100.0, 50.0, 20.0)]);
    whole.line(at(0.0, 0.0), at(1.0, 0.0), Stroke::Outline, Hue::Ink);
    let flaw = whole.to_svg().expect_err("it would not be seen").to_string();
    assert_eq!(flaw, "a line (f-line f-outline f-ink) lies in no panel of a figure of panels");
    let broken = dotted(100.0, f64::NAN, 20.0);
    assert!(Drawing::panels("fig:dots", vec![broken.clone()]).to_svg().is_err());
    assert!(dotted(100.0, 0.0, 0.0).with_narrow(broken).to_standalone_svg().is_err());
    let mut labelled = dotted(100.0, 0.0, 0.0);
    labelled.label(at(f64::NAN, 20.0), Side::Right, "here", Hue::Ink).expect("it can be set");
    let flaw = labelled.to_svg().expect_err("it stands nowhere").to_string();
    assert!(flaw.starts_with("the label `here` goes through (NaN, "), "{flaw}");
}

#[test]
fn arcs_turn_counter_clockwise_on_the_page() {
    let mut drawing = Drawing::new("fig:arc", 100.0, 100.0);
    let quarter = std::f64::consts::FRAC_PI_2;
    drawing.arc(at(50.0, 50.0), 20.0, 0.0, quarter, Stroke::Outline, Hue::Ink);
    drawing.arc(at(50.0, 50.0), 20.0, 0.0, -3.0 * quarter, Stroke::Outline, Hue::Ink);
    let svg = drawing.to_svg().expect("no flaw");
    // From the right to the top (y is downwards): the short way with sweep flag 0, the long way round with 1.
    assert!(svg.contains("M70,50A20,20 0 0 0 50,30\""), "{svg}");
    assert!(svg.contains("M70,50A20,20 0 1 1 50,30\""), "{svg}");
    let Shape::Arc { .. } = drawing.items()[0].shape else { panic!("an arc") };
    let end = drawing.items()[0].shape.points().pop().expect("points");
    assert!((end - at(50.0, 30.0)).length() < 1e-12);
}

#[test]
fn ellipses_lie_where_their_axes_say() {
    let (centre, radii, turn) = (at(50.0, 60.0), (30.0, 10.0), std::f64::consts::FRAC_PI_6);
    let ellipse = Shape::Ellipse { centre, radii, turn };
    for point in ellipse.points() {
        let step = point - centre;
        let (along, across) = (Point::polar(1.0, turn), Point::polar(1.0, turn).quarter_turned());
        let [x, y] = [along, across].map(|axis| step.x * axis.x + step.y * axis.y);
        assert!(((x / 30.0).powi(2) + (y / 10.0).powi(2) - 1.0).abs() < 1e-12, "{point:?}");
    }
    let mut drawing = Drawing::new("fig:ellipse", 100.0, 100.0);
    drawing.push(Role::Line(Stroke::Outline, Hue::Ink), ellipse);
    // From one end of the long axis to the other and back; SVG turns clockwise, the drawing counter-clockwise.
    let path = "M75.98,45A30,10 -30 0 0 24.02,75A30,10 -30 0 0 75.98,45Z";
    let svg = drawing.to_svg().expect("no flaw");
    assert!(svg.contains(path), "{svg}");
}

#[test]
fn rounded_bodies_are_shaded_by_a_gradient_of_their_own() {
    let mut drawing = Drawing::new("fig:balls", 100.0, 100.0);
    for (x, hue) in [(30.0, Hue::Blue), (70.0, Hue::Green)] {
        let (centre, light) = (at(x, 50.0), at(x - 4.0, 45.0));
        let shape = Shape::Rounded { centre, radii: (20.0, 10.0), turn: 0.0, light };
        drawing.push(Role::Area(Fill::Round, hue), shape);
    }
    let svg = drawing.to_svg().expect("no flaw");
    let document = Document::parse(&svg).expect("valid XML");
    let gradients: Vec<_> =
        document.descendants().filter(|node| node.has_tag_name("radialGradient")).collect();
    let paths: Vec<_> = document.descendants().filter(|node| node.has_tag_name("path")).collect();
    assert_eq!((gradients.len(), paths.len()), (2, 2));
    for (gradient, path) in gradients.iter().zip(&paths) {
        let id = gradient.attribute("id").expect("an id");
        assert!(id.starts_with("fig-balls-"));
        assert_eq!(path.attribute("fill"), Some(format!("url(#{id})").as_str()));
        // In the unit circle of the ellipse, a fifth to the left and half-way up.
        let focus = (gradient.attribute("fx"), gradient.attribute("fy"));
        assert_eq!(focus, (Some("-0.2"), Some("0.5")));
        assert_eq!(gradient.children().count(), 3);
    }
    assert_ne!(gradients[0].attribute("id"), gradients[1].attribute("id"));
    assert!(svg.contains("matrix(20 0 0 -10 30 50)"), "{svg}");
}

#[test]
fn a_tint_on_the_colour_of_the_page_with_its_edge_is_one_element_of_a_page_and_three_of_a_file() {
    let mut drawing = Drawing::new("fig:coins", 100.0, 100.0);
    drawing.disc(at(30.0, 30.0), 20.0, Hue::Blue);
    // What is tinted apart from the page stays apart.
    drawing.circle(at(70.0, 70.0), 20.0, Role::Area(Fill::Page, Hue::Ink));
    drawing.circle(at(70.0, 70.0), 10.0, Role::Area(Fill::Face, Hue::Ink));
    let circles = |svg: &str| {
        let document = Document::parse(svg).expect("valid XML");
        let paths = document.descendants().filter(|node| node.has_tag_name("path"));
        paths.map(|node| node.attribute("class").unwrap_or_default().to_owned()).collect::<Vec<_>>()
    };
    let (page, file) = (drawing.to_svg(), drawing.to_standalone_svg());
    let apart = ["f-page f-ink", "f-face f-ink"];
    let [coin, of_a_file] = [
        &["f-line f-outline f-blue f-opaque f-face f-blue"][..],
        &["f-page f-blue", "f-face f-blue", "f-line f-outline f-blue"],
    ];
    assert_eq!(circles(&page.expect("no flaw")), [coin, &apart].concat());
    assert_eq!(circles(&file.expect("no flaw")), [of_a_file, &apart].concat());
}

#[test]
fn polygons_that_follow_one_another_are_one_element_without_holes_but_panes_of_glass_stay_panes() {
    let square = |left: f64| vec![at(left, 0.0), at(left + 20.0, 0.0), at(left + 20.0, 20.0), at(left, 20.0)];
    let turned = |left: f64| square(left).into_iter().rev().collect();
    let mut drawing = Drawing::new("fig:squares", 100.0, 100.0);
    for fill in [Fill::Side, Fill::Glass] {
        drawing.polygon(square(0.0), fill, Hue::Blue);
        drawing.polygon(turned(10.0), fill, Hue::Blue);
    }
    // The second square of the colour of the page belongs to the tint on it.
    drawing.polygon(square(0.0), Fill::Page, Hue::Blue);
    drawing.polygon(square(50.0), Fill::Page, Hue::Blue);
    drawing.polygon(square(50.0), Fill::Side, Hue::Blue);
    let svg = drawing.to_svg().expect("no flaw");
    let paths: Vec<&str> = svg.lines().filter(|line| line.starts_with("<path")).collect();
    let classes = ["f-side", "f-glass", "f-glass", "f-page", "f-opaque f-side"];
    let expected = classes.map(|class| format!("<path class=\"{class} f-blue\""));
    assert_eq!(paths.len(), expected.len(), "{svg}");
    assert!(paths.iter().zip(&expected).all(|(path, start)| path.starts_with(start)), "{svg}");
    // Both go round in one sense.
    assert!(paths[0].ends_with("d=\"M0 0l20 0 0 20-20 0zm10 0l20 0 0 20-20 0z\"/>"), "{}", paths[0]);
}

#[test]
fn arrows_end_at_their_points() {
    for (from, to) in [(at(10.0, 90.0), at(80.0, 20.0)), (at(10.0, 10.0), at(14.0, 10.0))] {
        let mut drawing = Drawing::new("fig:arrow", 100.0, 100.0);
        kit::arrow(&mut drawing, from, to, Hue::Ink);
        let [shaft, head] = drawing.items() else { panic!("a shaft and a head") };
        assert_eq!(shaft.role, Role::Line(Stroke::Vector, Hue::Ink));
        assert_eq!((shaft.shape.points()[0], head.shape.points()[0]), (from, to));
        let length = (to - from).length();
        assert!(head.shape.points().iter().all(|&point| (point - to).length() < length.min(11.0)));
    }
}
