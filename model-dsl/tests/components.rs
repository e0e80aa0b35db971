//! Components, parts, repeats, constants and used files: what is written out is what would have
//! been written by hand.

use std::cell::RefCell;

use flexure_model_dsl::compile;
use flexure_model_dsl::model::Model;
use flexure_model_dsl::resolve::resolve;
use flexure_model_dsl::source::Source;

fn model(text: &str) -> Model {
    match resolve(Source::new("m.flex", text), &files) {
        Ok((model, warnings)) => {
            assert!(warnings.is_empty(), "{}", shown(&warnings));
            model
        }
        Err(diagnostics) => panic!("{}", shown(&diagnostics)),
    }
}

fn shown(diagnostics: &[impl ToString]) -> String {
    let texts: Vec<String> = diagnostics.iter().map(ToString::to_string).collect();
    texts.join("\n\n")
}

fn files(path: &str) -> Result<String, String> {
    match path {
        "parts/bars.flex" => Ok("use \"sizes.flex\"\n\
             component bar(l: length) {\n\
               link web from P to Q { length = l, angle = size * 10 deg, mass = 1 g }\n\
               hinge at P { stiffness = 1 N*m/rad }\n\
             }\n"
        .to_owned()),
        "parts/sizes.flex" => Ok("const size = 3\n".to_owned()),
        _ => Err("no such file".to_owned()),
    }
}

/// Everything that a model says, as text.
fn everything(model: &Model) -> String {
    let bodies: Vec<String> = model.bodies.iter().map(|body| body.name.clone()).collect();
    let pins: Vec<String> = model
        .pins
        .iter()
        .map(|pin| {
            let members: Vec<usize> = pin.members.iter().map(|(body, _)| *body).collect();
            format!("{}{members:?}", pin.name)
        })
        .collect();
    let points: Vec<String> = model
        .points
        .iter()
        .map(|point| point.name.clone())
        .collect();
    let hinges: Vec<String> = model
        .hinges
        .iter()
        .map(|hinge| hinge.name.clone())
        .collect();
    format!("{bodies:?} {pins:?} {points:?} {hinges:?}")
}

#[test]
fn a_part_is_what_its_component_says() {
    let text = "model m\n\
        param l = 10 mm\n\
        component bar(l: length, load: mass = 2 g) {\n\
          link web from P to Q { length = l, angle = 0 deg, mass = load }\n\
          point C on web at (l/2, 1 mm)\n\
          hinge at P { stiffness = 1 N*m/rad }\n\
        }\n\
        ground O = (0 mm, 0 mm)\n\
        part left = bar(l) at P = O\n\
        part right = bar(l = 2 * l, load = 1 g) at P = left.Q\n\
        output y = right.web.C.y + right.C.x + left.web.angle*1 m\n";
    let model = model(text);
    assert_eq!(
        everything(&model),
        "[\"ground\", \"left.web\", \"right.web\"] [\"O[0, 1]\", \"left.Q[1, 2]\"] \
         [\"O\", \"left.Q\", \"right.Q\", \"left.C\", \"right.C\"] [\"O\", \"left.Q\"]"
    );
    let lets: Vec<&str> = model.lets.iter().map(|known| known.name.as_str()).collect();
    assert!(
        lets.contains(&"right.l") && lets.contains(&"left.load"),
        "{lets:?}"
    );
    assert!(!lets.contains(&"left.l"), "a name given is the name used");
}

#[test]
fn repeated_items_are_those_written_by_hand() {
    let repeated = "model m\n\
        const N = 2, M = N + 1\n\
        param l = 10 mm\n\
        ground B[0] = (0 mm, 0 mm)\n\
        repeat i from 1 to N {\n\
          link up[i] from B[i-1] to B[i] { length = i * l, angle = 10 deg, mass = M * 1 g, symbol = φ[i] }\n\
          repeat j from i to N { point C[i][j] on up[i] at (j * 1 mm, 0 mm) }\n\
        }\n\
        output a = up[N].angle, b = C[1][2].x\n";
    let by_hand = "model m\n\
        param l = 10 mm\n\
        ground B0 = (0 mm, 0 mm)\n\
        link up1 from B0 to B1 { length = 1 * l, angle = 10 deg, mass = 3 * 1 g, symbol = φ1 }\n\
        point C1_1 on up1 at (1 * 1 mm, 0 mm)\n\
        point C1_2 on up1 at (2 * 1 mm, 0 mm)\n\
        link up2 from B1 to B2 { length = 2 * l, angle = 10 deg, mass = 3 * 1 g, symbol = φ2 }\n\
        point C2_2 on up2 at (2 * 1 mm, 0 mm)\n\
        output a = up2.angle, b = C1_2.x\n";
    let equations = |text: &str| {
        let source = Source::new("m.flex", text);
        let (equations, _) = compile(source, &files).unwrap_or_else(|d| panic!("{}", shown(&d)));
        let states = equations.states.iter();
        let states: Vec<String> = states.map(|s| format!("{} {:?}", s.name, s.rate)).collect();
        let graph = format!("{:?}", equations.graph);
        // What follows the nodes is an index without order.
        let nodes = graph.split("], index:").next().unwrap_or_default();
        format!("{states:?} {nodes}")
    };
    assert_eq!(everything(&model(repeated)), everything(&model(by_hand)));
    assert_eq!(equations(repeated), equations(by_hand));
}

#[test]
fn components_hold_parts_and_repeats() {
    let text = "model m\n\
        component bar { link web from P to Q { length = 1 mm, angle = 0 deg, mass = 1 g } }\n\
        component pair {\n\
          repeat i from 1 to 2 { part side[i] = bar() at P = Start, Q = End[i] }\n\
        }\n\
        ground O = (0 mm, 0 mm)\n\
        part a = pair() at Start = O\n\
        part b = pair() at Start = a.side[2].Q\n\
        output angle2 = b.side2.web.angle\n";
    assert_eq!(
        everything(&model(text)),
        "[\"ground\", \"a.side1.web\", \"a.side2.web\", \"b.side1.web\", \"b.side2.web\"] \
         [\"O[0, 1, 2]\", \"a.End2[2, 3, 4]\"] \
         [\"O\", \"a.End1\", \"a.End2\", \"b.End1\", \"b.End2\"] []"
    );
}

#[test]
fn files_are_used() {
    let asked = RefCell::new(Vec::new());
    let text = "use \"parts/bars.flex\"\nmodel m\nground O = (0 mm, 0 mm)\n\
                part a = bar(l = size * 1 mm) at P = O\n";
    let read = |path: &str| {
        asked.borrow_mut().push(path.to_owned());
        files(path)
    };
    let source = Source::new("m.flex", text);
    let (model, _) = resolve(source, &read).unwrap_or_else(|d| panic!("{}", shown(&d)));
    assert_eq!(model.files, ["parts/bars.flex", "parts/sizes.flex"]);
    assert_eq!(*asked.borrow(), model.files);
    assert_eq!(model.bodies[1].name, "a.web");
    let site = model.source.site(model.bodies[1].span);
    assert_eq!(
        (&*site.file, site.line, site.column),
        ("parts/bars.flex", 3, 6)
    );
}

#[test]
fn no_repeat_and_no_part_is_too_much() {
    let compiled = |text: &str| {
        resolve(Source::new("m.flex", text), &files)
            .map(|(model, _)| model.bodies.len())
            .map_err(|d| shown(&d))
    };
    let slides = |turns: &str| {
        compiled(&format!(
            "model m\nrepeat i from 1 to {turns} {{ slide s[i] along (1, 0) {{ mass = 1 g }} }}"
        ))
    };
    assert_eq!(slides("10000"), Ok(10_001));
    for turns in [
        "10001",
        "9223372036854775807",
        "99999*99999*99999*99999*9999",
    ] {
        assert!(slides(turns).is_err(), "{turns}");
    }
    assert_eq!(slides("0"), Ok(1));
    let nested = "repeat a from 1 to 999 {\n";
    for depth in [3, 16, 17, 10_000] {
        let text = format!("model m\n{}{}", nested.repeat(depth), "}\n".repeat(depth));
        assert!(compiled(&text).is_err(), "{depth}");
        assert!(compiled(&format!("model m\n{}", nested.repeat(depth))).is_err());
    }
    let itself = "model m\ncomponent a { part b = a()\n part c = a() }\npart d = a()\n";
    assert!(compiled(itself).is_err());
    let circle = "model m\ncomponent c { point P on bar at (0 mm, 0 mm) }\n\
                  part a = c() at P = b.P\npart b = c() at P = a.P\n";
    assert!(compiled(circle).is_err());
}
