//! Expressions as written.

use crate::symbolic::{Expr, Function, Graph, Rational, Style};

/// Makes symbols by name, as a model would.
struct Writer {
    g: Graph,
    listing: String,
}

impl Writer {
    fn new() -> Self {
        Self {
            g: Graph::new(),
            listing: String::new(),
        }
    }

    fn symbol(&mut self, name: &str) -> Expr {
        let latex = crate::notation::latex_of(name);
        let symbol = self.g.symbol(name, latex);
        self.g.of(symbol)
    }

    fn symbols<const N: usize>(&mut self, names: [&str; N]) -> [Expr; N] {
        names.map(|name| self.symbol(name))
    }

    fn varying<const N: usize>(&mut self, names: [&str; N]) -> [Expr; N] {
        names.map(|name| {
            let expr = self.symbol(name);
            let symbol = self.g.as_symbol(expr).unwrap();
            self.g.mark_varying(symbol);
            expr
        })
    }

    fn list(&mut self, expr: Expr) {
        self.listing.push_str(&self.g.text(expr));
        self.listing.push_str("\n    ");
        self.listing.push_str(&self.g.latex(expr));
        self.listing.push('\n');
    }
}

#[test]
fn equations_of_the_article() {
    let mut w = Writer::new();
    let [c0, c1, c2, c3] = w.symbols(["C0", "C1", "C2", "C3"]);
    let [beta2, l1, l2, k2, phi1_0, phi2_0] = w.symbols(["β2", "l1", "l2", "k2", "φ1⁰", "φ2⁰"]);
    let [phi1, phi2, phi3, omega2, omega3] = w.varying(["φ1", "φ2", "φ3", "ω2", "ω3"]);
    let g = &mut w.g;

    // (5)
    let (square2, square3) = (g.powi(omega2, 2), g.powi(omega3, 2));
    let (t1, t2) = (g.mul(c1, square2), g.mul(c2, square3));
    let angle = g.sub(phi2, phi1);
    let angle = g.add(angle, beta2);
    let cos = g.cos(angle);
    let t3 = g.product(&[cos, omega2, c3]);
    let inertia = g.sum(&[c0, t1, t2, t3]);

    // The ratio of the coupler
    let (a, b) = (g.sub(phi3, phi1), g.sub(phi2, phi3));
    let (sa, sb) = (g.sin(a), g.sin(b));
    let (above, below) = (g.mul(l1, sa), g.mul(l2, sb));
    let ratio = g.div(above, below);

    // A term of (8) and of (11)
    let deflection = {
        let turned = g.sub(phi2, phi1);
        let rest = g.sub(phi1_0, phi2_0);
        g.add(turned, rest)
    };
    let square = g.powi(deflection, 2);
    let half = g.ratio(1, 2);
    let stored = g.product(&[half, k2, square]);
    let one = g.one();
    let lever = g.sub(omega2, one);
    let torque = g.product(&[k2, deflection, lever]);

    // (17)
    let difference = g.function(Function::CosDifference, &[phi1_0, phi1]);
    let travel = g.mul(l1, difference);

    for expr in [inertia, ratio, stored, torque, travel] {
        w.list(expr);
    }

    // (10), (19) to (22)
    let [modulus, width, web, radius] = w.symbols(["E", "b", "e", "r"]);
    let g = &mut w.g;
    let (two, nine, pi) = (g.integer(2), g.integer(9), g.pi());
    let (web, root) = (
        g.powr(web, Rational::new(5.into(), 2.into())),
        g.sqrt(radius),
    );
    let above = g.product(&[two, modulus, width, web]);
    let below = g.product(&[nine, pi, root]);
    let stiffness = g.div(above, below);
    w.list(stiffness);
    let [sigma0, sigma1, fs, fc, vs] = w.symbols(["σ0", "σ1", "F_S", "F_C", "v_S"]);
    let [v, z] = w.varying(["v", "z"]);
    let g = &mut w.g;
    let limit = g.symbol("g(v)", "g(v)");
    let limit = g.of(limit);
    let rate = g.symbol("ż", r"\dot{z}");
    let rate = g.of(rate);
    let ratio = g.div(v, vs);
    let ratio = g.powi(ratio, 2);
    let exponent = g.neg(ratio);
    let decay = g.function(Function::Exp, &[exponent]);
    let drop = g.sub(fs, fc);
    let stribeck = g.mul(drop, decay);
    let level = g.add(fc, stribeck);
    let level = g.div(level, sigma0);
    let magnitude = g.function(Function::Abs, &[v]);
    let pulled = g.mul(z, magnitude);
    let pulled = g.div(pulled, limit);
    let relaxation = g.sub(v, pulled);
    let (elastic, damped) = (g.mul(sigma0, z), g.mul(sigma1, rate));
    let force = g.add(elastic, damped);
    let load = g.div(fs, fc);
    let scaled = g.mul(load, force);
    for expr in [level, relaxation, force, scaled] {
        w.list(expr);
    }
    insta::assert_snapshot!(w.listing);
}

#[test]
fn numbers() {
    let mut w = Writer::new();
    let x = w.symbol("x");
    for (p, q) in [
        (0, 1),
        (7, 1),
        (-3, 1),
        (1, 2),
        (2, 9),
        (-3, 4),
        (19, 20),
        (3, 2),
        (1, 5),
        (1, 1000),
        (1, 1_000_000),
        (5_000_000, 1),
        (36_000_000, 1),
        (981, 100),
        (1, 30),
        (22, 7),
        (355, 113),
        (123_456_789, 1_000_000_007),
        (1_234_567_890_123_456_789, 7_000_000_000_000_000_001),
    ] {
        let g = &mut w.g;
        let number = g.ratio(p, q);
        let (scaled, shifted) = (g.mul(number, x), g.add(x, number));
        let (power, ratio) = (
            g.powr(x, Rational::new(p.into(), q.into())),
            g.div(x, number),
        );
        for expr in [number, scaled, shifted, power, ratio] {
            w.list(expr);
        }
    }
    for value in [1e-320, 1e308, 0.1, 2.568e-4, 123456.789] {
        let number = w.g.decimal(value).unwrap();
        w.list(number);
    }
    insta::assert_snapshot!(w.listing);
}

/// A sum that is written as its negative keeps the value: what is written as a sum itself gets
/// parentheses where a minus sign stands before it, and only there.
#[test]
fn opposite_sums() {
    let mut g = Graph::new();
    let [k, a, b] = ["k", "a", "b"].map(|name| {
        let symbol = g.symbol(name, name);
        g.of(symbol)
    });
    let [x, y] = ["x - x⁰", "y - y⁰"].map(|text| {
        let symbol = g.symbol_written_as_sum(text, text);
        g.of(symbol)
    });
    let minus_k = g.neg(k);
    for (less, more, expected) in [
        (x, y, "k (y - y⁰ - (x - x⁰))"),
        (y, x, "k (x - x⁰ - (y - y⁰))"),
        (a, y, "k (y - y⁰ - a)"),
        (y, b, "k (b - (y - y⁰))"),
    ] {
        let difference = g.sub(less, more);
        let written = g.mul(minus_k, difference);
        assert_eq!(g.text(written), expected);
    }
}

#[test]
fn sums_and_products() {
    let mut w = Writer::new();
    let [a, b, c, d] = w.symbols(["a", "b", "c", "d"]);
    let g = &mut w.g;
    let deflection = g.symbol_written_as_sum("φ2 - φ2⁰", r"\varphi_2 - \varphi_2^0");
    let s = g.of(deflection);
    let (minus_a, minus_b) = (g.neg(a), g.neg(b));
    let one = g.one();
    let ab = g.add(a, b);
    let cd = g.sub(c, d);
    let minus_cd = g.neg(cd);
    let root = g.sqrt(ab);
    let three = g.integer(3);
    let root3 = g.sqrt(three);
    let bulk = g.mul(ab, cd);
    let (minus_c, minus_ab) = (g.neg(c), g.neg(ab));
    let [sine, turned] = [cd, ab].map(|angle| g.sin(angle));
    let retarded = g.mul(a, sine);
    let examples = [
        minus_a,
        g.sum(&[minus_a, b]),
        g.sum(&[minus_a, minus_b, c, d]),
        g.sum(&[minus_a, minus_b]),
        g.sub(one, a),
        g.add(one, a),
        g.sub(a, one),
        bulk,
        g.div(a, b),
        g.div(ab, cd),
        g.div(a, bulk),
        g.div(bulk, a),
        g.div(one, a),
        g.div(minus_a, ab),
        g.mul(a, minus_cd),
        g.powi(ab, 2),
        g.powi(ab, -2),
        g.powi(a, -1),
        g.powi(a, 12),
        g.powi(a, 1234),
        root,
        g.div(a, root),
        g.powi(root, 3),
        g.powr(a, Rational::new(1.into(), 3.into())),
        g.mul(three, root3),
        g.mul(c, s),
        g.powi(s, 2),
        g.add(c, s),
        g.sub(c, s),
        g.neg(s),
        g.mul(c, minus_ab),
        g.div(minus_c, minus_ab),
        g.powi(minus_ab, 2),
        g.powi(minus_ab, -3),
        g.sub(d, retarded),
        g.mul(minus_c, turned),
    ];
    for expr in examples {
        w.list(expr);
    }
    let g = &mut w.g;
    // Not folded, so two numbers meet.
    let huge = g.powr(three, Rational::from_integer(100_000.into()));
    let five = g.integer(5);
    let examples = [
        g.product(&[five, huge, a]),
        g.scale(ab, Rational::new(1.into(), 2.into())),
        {
            let square = g.powi(a, 2);
            let root = g.sqrt(square);
            g.mul(b, root)
        },
        {
            let ratio = g.div(a, b);
            g.powi(ratio, -3)
        },
        {
            let ratio = g.div(ab, c);
            let ratio = g.powi(ratio, 2);
            g.scale(ratio, Rational::new((-5).into(), 16.into()))
        },
    ];
    for expr in examples {
        w.list(expr);
    }
    insta::assert_snapshot!(w.listing);
}

#[test]
fn functions() {
    let mut w = Writer::new();
    let [a, b] = w.symbols(["a", "φ1"]);
    let g = &mut w.g;
    let ab = g.add(a, b);
    let mut examples = Vec::new();
    for function in Function::ALL {
        let arguments: Vec<Expr> = [ab, b, a][..function.arity()].to_vec();
        let plain: Vec<Expr> = [b, a, ab][..function.arity()].to_vec();
        let plain = g.function(function, &plain);
        let full = g.function(function, &arguments);
        let square = g.powi(full, 2);
        let scaled = g.mul(a, full);
        let raised = g.powi(plain, 3);
        let negative = g.neg(plain);
        let shifted = g.sub(a, full);
        examples.extend([plain, square, scaled, raised, negative, shifted]);
    }
    let lookup = g.table(vec![1.0, 2.0]);
    let entry = g.function(lookup, &[a]);
    let half = g.ratio(1, 2);
    let threshold = g.sub(a, half);
    let inner = g.function(Function::IfPositive, &[b, entry, a]);
    let chain = g.function(Function::IfPositive, &[threshold, b, inner]);
    let nested = g.function(Function::IfPositive, &[threshold, inner, b]);
    let negative = g.neg(ab);
    let difference = g.function(Function::SinDifference, &[a, b]);
    let decreasing = g.sub(a, difference);
    let increasing = g.add(a, difference);
    let power = g.function(Function::Power, &[ab, negative]);
    examples.extend([entry, chain, nested, decreasing, increasing, power]);
    for expr in examples {
        w.list(expr);
    }
    insta::assert_snapshot!(w.listing);
}

#[test]
fn terms_one_by_one() {
    let mut w = Writer::new();
    let [a, b] = w.symbols(["a", "b"]);
    let g = &mut w.g;
    let minus = g.neg(a);
    let product = g.mul(a, b);
    let sum = g.sum(&[minus, b, product]);
    let terms = g.terms(sum, Style::Text);
    let written: Vec<_> = terms
        .iter()
        .map(|term| (term.negative, term.text.as_str()))
        .collect();
    assert_eq!(written, [(false, "b"), (true, "a"), (false, "a b")]);
    let single = g.terms(minus, Style::Latex);
    assert_eq!((single.len(), single[0].negative), (1, true));
}

#[test]
fn neither_sharing_nor_depth_nor_width_is_too_much() {
    let mut w = Writer::new();
    let x = w.symbol("x");
    let g = &mut w.g;
    let mut shared = x;
    let mut deep = x;
    let mut wide = vec![x];
    for index in 0..10_000 {
        let sine = g.sin(shared);
        let cosine = g.cos(shared);
        shared = g.mul(sine, cosine);
        deep = g.sin(deep);
        let power = g.powi(x, index);
        wide.push(g.sin(power));
    }
    let wide = g.sum(&wide);
    for expr in [shared, deep, wide] {
        for style in [Style::Text, Style::Latex] {
            let written = g.written(expr, style);
            let ellipsis = if style == Style::Text {
                "…"
            } else {
                r"\ldots"
            };
            assert!(written.len() < 200_000, "{}", written.len());
            assert!(written.contains(ellipsis));
        }
    }
}
