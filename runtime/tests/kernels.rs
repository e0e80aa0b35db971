//! Own functions of the lanes, on every path of this machine, against series in exact arithmetic.

mod reference;

use flexure_runtime::lanes::{Lanes, Path, Task, on_path, on_path_alone, on_path_in_one_register};
use flexure_runtime::real::Real;
use reference::{Fixed, Reference};

#[derive(Clone, Copy, Debug, PartialEq)]
enum Function {
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Tanh,
    Exp,
    Ln,
    Atan2,
    Power,
    Floor,
    Sign,
    Unwrap,
    Sqrt,
    Abs,
    Quotient,
    Smaller,
    Larger,
    Positive,
}

impl Function {
    #[inline(always)]
    fn apply<T: Real>(self, x: T, y: T) -> T {
        match self {
            Function::Sin => x.sin(),
            Function::Cos => x.cos(),
            Function::Tan => x.tan(),
            Function::Asin => x.asin(),
            Function::Acos => x.acos(),
            Function::Atan => x.atan(),
            Function::Tanh => x.tanh(),
            Function::Exp => x.exp(),
            Function::Ln => x.ln(),
            Function::Atan2 => x.atan2(y),
            Function::Power => x.power(y),
            Function::Floor => x.floor(),
            Function::Sign => x.sign(),
            Function::Unwrap => x.unwrap_to(y),
            Function::Sqrt => x.sqrt(),
            Function::Abs => x.abs(),
            Function::Quotient => x / y,
            Function::Smaller => x.smaller(y),
            Function::Larger => x.larger(y),
            Function::Positive => x.if_positive(y, -y),
        }
    }
}

/// A function of pairs of numbers, as many at once as there are lanes.
struct Evaluate<'a> {
    function: Function,
    arguments: &'a [(f64, f64)],
}

impl Task for Evaluate<'_> {
    type Output = Vec<f64>;

    #[inline(always)]
    fn run<T: Lanes>(self) -> Vec<f64> {
        let mut results = Vec::new();
        for chunk in self.arguments.chunks(T::COUNT) {
            let argument = |i: usize| chunk[i.min(chunk.len() - 1)];
            let x = T::from_entries(|i| argument(i).0);
            let y = T::from_entries(|i| argument(i).1);
            let result = self.function.apply(x, y);
            results.extend((0..chunk.len()).map(|i| result.entry(i)));
        }
        results
    }
}

fn paths() -> impl Iterator<Item = Path> {
    Path::ALL
        .into_iter()
        .filter(|&path| path <= Path::available())
}

fn on_lanes(path: Path, function: Function, arguments: &[(f64, f64)]) -> Vec<f64> {
    on_path(
        path,
        Evaluate {
            function,
            arguments,
        },
    )
}

fn alone(path: Path, function: Function, arguments: &[(f64, f64)]) -> Vec<f64> {
    on_path_alone(
        path,
        Evaluate {
            function,
            arguments,
        },
    )
}

fn in_one_register(path: Path, function: Function, arguments: &[(f64, f64)]) -> Vec<f64> {
    on_path_in_one_register(
        path,
        Evaluate {
            function,
            arguments,
        },
    )
}

/// Numbers that are the same in every run.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        // SplitMix64.
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn between(&mut self, least: f64, most: f64) -> f64 {
        let share = (self.bits() >> 11) as f64 / (1u64 << 53) as f64;
        least + (most - least) * share
    }

    /// Of any size between powers of two, and any sign.
    fn of_any_size(&mut self, least: i32, most: i32) -> f64 {
        let exponent = self.between(f64::from(least), f64::from(most));
        let sign = if self.bits() & 1 == 0 { 1.0 } else { -1.0 };
        sign * exponent.exp2()
    }
}

/// Fails if any result is further than `bound` units in the last place from the exact one, on any
/// path.
fn check(
    function: Function,
    bound: f64,
    arguments: &[(f64, f64)],
    exact: impl Fn(f64, f64) -> Fixed,
) {
    let exact: Vec<Fixed> = arguments.iter().map(|&(x, y)| exact(x, y)).collect();
    for path in paths() {
        let results = on_lanes(path, function, arguments);
        let mut worst = (0.0, 0);
        for (i, &result) in results.iter().enumerate() {
            assert!(
                result.is_finite(),
                "{function:?} of {:?}: {result}",
                arguments[i]
            );
            let ulps = exact[i].ulps(result);
            if ulps > worst.0 {
                worst = (ulps, i);
            }
        }
        println!(
            "{function:?} {path:?}: {:.3} ulp at {:?}",
            worst.0, arguments[worst.1]
        );
        assert!(
            worst.0 <= bound,
            "{function:?} of {:?} is {:?} on {path:?}: {} ulp",
            arguments[worst.1],
            results[worst.1],
            worst.0
        );
    }
}

fn singly(numbers: impl IntoIterator<Item = f64>) -> Vec<(f64, f64)> {
    numbers.into_iter().map(|x| (x, 0.0)).collect()
}

fn angles(count: usize) -> Vec<(f64, f64)> {
    let mut random = Random(1);
    let mut all = Vec::new();
    for _ in 0..count {
        all.push(random.between(-4.0, 4.0));
        all.push(random.between(-1e3, 1e3));
        all.push(random.between(-1e6, 1e6));
        all.push(random.of_any_size(-1074, 20));
        all.push(random.of_any_size(19, 1023));
        // As near to a whole number of quarter turns as numbers come.
        let quarters = random.between(0.0, 640_000.0).floor();
        all.push(quarters * std::f64::consts::FRAC_PI_2);
        all.push(random.between(0.0, 12.0).floor() * std::f64::consts::FRAC_PI_4);
    }
    // The nearest of all numbers to a multiple of π/2, and the limit between the methods.
    all.extend([
        6381956970095103.0 * 2f64.powi(797),
        1e6,
        1e6f64.next_down(),
        f64::MAX,
    ]);
    all.retain(|&x| x != 0.0);
    singly(all)
}

#[test]
fn sine_and_cosine() {
    let reference = Reference::new();
    let angles = angles(3000);
    check(Function::Sin, 1.0, &angles, |x, _| reference.sin_cos(x).0);
    check(Function::Cos, 1.0, &angles, |x, _| reference.sin_cos(x).1);
}

#[test]
fn tangent() {
    let reference = Reference::new();
    check(Function::Tan, 2.0, &angles(500), |x, _| reference.tan(x));
}

#[test]
fn exponential() {
    let reference = Reference::new();
    let mut random = Random(2);
    let mut numbers = Vec::new();
    for _ in 0..4000 {
        numbers.push(random.between(-1.0, 1.0));
        numbers.push(random.between(-708.396, 709.78));
        numbers.push(random.between(-708.396, -708.0));
        numbers.push(random.between(708.0, 709.78));
        numbers.push(random.of_any_size(-1074, 9));
        // Where one entry of the table takes over from another.
        let eighths = 2.0 * random.between(-4088.0, 4096.0).floor() + 1.0;
        numbers.push(eighths * std::f64::consts::LN_2 / 8.0);
        numbers.push(random.between(-1022.0, 1024.0).floor() * std::f64::consts::LN_2 * 0.5);
    }
    numbers.retain(|&x| x > -708.396 && x < 709.78 && x != 0.0);
    check(Function::Exp, 1.0, &singly(numbers), |x, _| {
        reference.exp(x)
    });
}

#[test]
fn directions() {
    let reference = Reference::new();
    let mut random = Random(3);
    let mut vectors = Vec::new();
    for _ in 0..1500 {
        vectors.push((random.between(-1.0, 1.0), random.between(-1.0, 1.0)));
        vectors.push((random.of_any_size(-20, 20), random.of_any_size(-20, 20)));
        vectors.push((random.of_any_size(-200, 200), random.of_any_size(-200, 200)));
        let size = random.of_any_size(-1000, 1023);
        let other = size * random.between(0.3, 3.0);
        vectors.push((size, if other.is_finite() { other } else { size }));
        let x = random.of_any_size(-1, 1);
        vectors.push((x * random.between(0.4142, 0.51), x));
        vectors.push((x, -x * random.between(0.4142, 0.51)));
    }
    vectors.extend([
        (1.0, 1.0),
        (-1.0, 1.0),
        (1.0, -1.0),
        (-1.0, -1.0),
        (5e-324, 5e-324),
    ]);
    check(Function::Atan2, 2.0, &vectors, |y, x| reference.atan2(y, x));
    let slopes = singly(vectors.iter().map(|v| v.0).filter(|y| y.abs() > 1e-300));
    check(Function::Atan, 2.0, &slopes, |y, _| reference.atan2(y, 1.0));
}

#[test]
fn angles_of_sines_and_cosines() {
    let reference = Reference::new();
    let mut random = Random(4);
    let mut numbers = vec![0.5, -0.5, 1.0 - 1e-16, -1.0 + 1e-16, 1.0 - 1e-9];
    for _ in 0..1000 {
        numbers.push(random.between(-1.0, 1.0));
        numbers.push(random.of_any_size(-60, 0));
        numbers.push(1.0 - random.of_any_size(-52, 0).abs());
    }
    numbers.retain(|x| x.abs() < 1.0 && *x != 0.0);
    let numbers = singly(numbers);
    check(Function::Asin, 3.0, &numbers, |x, _| reference.asin(x));
    check(Function::Acos, 3.0, &numbers, |x, _| reference.acos(x));
}

#[test]
fn hyperbolic_tangent() {
    let reference = Reference::new();
    let mut random = Random(5);
    let mut numbers = Vec::new();
    for _ in 0..2000 {
        numbers.push(random.between(-1.0, 1.0));
        numbers.push(random.between(-25.0, 25.0));
        numbers.push(random.of_any_size(-300, 1));
    }
    check(Function::Tanh, 2.0, &singly(numbers), |x, _| {
        reference.tanh(x)
    });
}

#[test]
fn logarithm_and_powers() {
    let reference = Reference::new();
    let mut random = Random(6);
    let mut numbers = vec![5e-324, 1e-310, f64::MIN_POSITIVE, f64::MAX, 2.0, 0.5];
    for _ in 0..2000 {
        numbers.push(random.between(0.5, 2.0));
        numbers.push(random.of_any_size(-1074, 1023).abs());
        numbers.push(1.0 + random.of_any_size(-50, -2));
    }
    numbers.retain(|&x| x > 0.0 && x != 1.0);
    check(
        Function::Ln,
        1.0,
        &singly(numbers.iter().copied()),
        |x, _| reference.ln(x),
    );
    let mut powers = Vec::new();
    for &x in &numbers {
        let most = 708.0 / x.ln().abs();
        powers.push((x, random.between(-most, most)));
        powers.push((x, random.between(-4.0, 4.0)));
    }
    powers.retain(|&(x, y)| x.powf(y).is_normal() && y != 0.0);
    check(Function::Power, 1.0, &powers, |x, y| reference.power(x, y));
}

/// Entries that no error in units in the last place is told of: what C's functions say of them.
#[test]
fn zeros_infinities_and_what_is_not_a_number() {
    const INF: f64 = f64::INFINITY;
    const NAN: f64 = f64::NAN;
    const PI: f64 = std::f64::consts::PI;
    let cases: &[(Function, f64, f64, f64)] = &[
        (Function::Sin, 0.0, 0.0, 0.0),
        (Function::Sin, -0.0, 0.0, -0.0),
        (Function::Sin, -5e-324, 0.0, -5e-324),
        (Function::Cos, -0.0, 0.0, 1.0),
        (Function::Sin, INF, 0.0, NAN),
        (Function::Cos, -INF, 0.0, NAN),
        (Function::Sin, NAN, 0.0, NAN),
        (Function::Tan, -0.0, 0.0, -0.0),
        (Function::Tan, INF, 0.0, NAN),
        (Function::Exp, 0.0, 0.0, 1.0),
        (Function::Exp, -0.0, 0.0, 1.0),
        (Function::Exp, INF, 0.0, INF),
        (Function::Exp, -INF, 0.0, 0.0),
        (Function::Exp, NAN, 0.0, NAN),
        (Function::Exp, 709.79, 0.0, INF),
        // Results that would be subnormal.
        (Function::Exp, -708.3961, 0.0, 0.0),
        (Function::Exp, -745.13, 0.0, 0.0),
        (Function::Exp, -1e300, 0.0, 0.0),
        (Function::Exp, f64::MAX, 0.0, INF),
        (Function::Exp, 5e-324, 0.0, 1.0),
        (Function::Ln, 0.0, 0.0, -INF),
        (Function::Ln, -0.0, 0.0, -INF),
        (Function::Ln, 1.0, 0.0, 0.0),
        (Function::Ln, -1.0, 0.0, NAN),
        (Function::Ln, INF, 0.0, INF),
        (Function::Ln, NAN, 0.0, NAN),
        (Function::Tanh, -0.0, 0.0, -0.0),
        (Function::Tanh, INF, 0.0, 1.0),
        (Function::Tanh, -INF, 0.0, -1.0),
        (Function::Tanh, NAN, 0.0, NAN),
        (Function::Asin, 1.0, 0.0, PI / 2.0),
        (Function::Asin, -0.0, 0.0, -0.0),
        (Function::Asin, 1.1, 0.0, NAN),
        (Function::Acos, 1.0, 0.0, 0.0),
        (Function::Acos, -1.0, 0.0, PI),
        (Function::Acos, -1.1, 0.0, NAN),
        (Function::Atan, INF, 0.0, PI / 2.0),
        (Function::Atan, -INF, 0.0, -PI / 2.0),
        (Function::Atan, -0.0, 0.0, -0.0),
        (Function::Atan2, 0.0, 0.0, 0.0),
        (Function::Atan2, -0.0, 0.0, -0.0),
        (Function::Atan2, 0.0, -0.0, PI),
        (Function::Atan2, -0.0, -0.0, -PI),
        (Function::Atan2, 0.0, -1.0, PI),
        (Function::Atan2, -0.0, -1.0, -PI),
        (Function::Atan2, 0.0, 1.0, 0.0),
        (Function::Atan2, -0.0, 1.0, -0.0),
        (Function::Atan2, 1.0, 0.0, PI / 2.0),
        (Function::Atan2, -1.0, -0.0, -PI / 2.0),
        (Function::Atan2, INF, 1.0, PI / 2.0),
        (Function::Atan2, 1.0, INF, 0.0),
        (Function::Atan2, -1.0, INF, -0.0),
        (Function::Atan2, 1.0, -INF, PI),
        (Function::Atan2, INF, INF, PI / 4.0),
        (Function::Atan2, -INF, -INF, -0.75 * PI),
        (Function::Atan2, NAN, 1.0, NAN),
        (Function::Atan2, 1.0, NAN, NAN),
        (Function::Atan2, NAN, INF, NAN),
        (Function::Power, NAN, 0.0, 1.0),
        (Function::Power, 1.0, NAN, 1.0),
        (Function::Power, -1.0, INF, 1.0),
        (Function::Power, -1.0, 0.5, NAN),
        (Function::Power, -2.0, 3.0, -8.0),
        (Function::Power, -2.0, 2.0, 4.0),
        (Function::Power, 0.0, -1.0, INF),
        (Function::Power, -0.0, -3.0, -INF),
        (Function::Power, 0.5, INF, 0.0),
        (Function::Power, 0.5, -INF, INF),
        (Function::Power, INF, -2.0, 0.0),
        (Function::Power, -INF, 3.0, -INF),
        (Function::Power, 10.0, 400.0, INF),
        (Function::Power, 10.0, -400.0, 0.0),
        (Function::Floor, -0.0, 0.0, -0.0),
        (Function::Floor, -0.3, 0.0, -1.0),
        (Function::Floor, 0.7, 0.0, 0.0),
        (Function::Floor, 2.0, 0.0, 2.0),
        (Function::Floor, -2.5, 0.0, -3.0),
        (Function::Floor, 4503599627370495.5, 0.0, 4503599627370495.0),
        (
            Function::Floor,
            -2251799813685248.5,
            0.0,
            -2251799813685249.0,
        ),
        (Function::Floor, 1e300, 0.0, 1e300),
        (Function::Floor, -INF, 0.0, -INF),
        (Function::Floor, NAN, 0.0, NAN),
        (Function::Sign, -2.0, 0.0, -1.0),
        (Function::Sign, 2.0, 0.0, 1.0),
        (Function::Sign, -0.0, 0.0, -0.0),
        (Function::Sign, NAN, 0.0, NAN),
        (Function::Unwrap, 0.25, 0.5, 0.25),
        (Function::Unwrap, 0.25, 0.25 + 6.0 * PI, 0.25 + 6.0 * PI),
        (Function::Unwrap, NAN, 0.0, NAN),
        (Function::Unwrap, 0.0, INF, INF),
    ];
    for path in paths() {
        for &(function, x, y, expected) in cases {
            for result in [
                on_lanes(path, function, &[(x, y)])[0],
                in_one_register(path, function, &[(x, y)])[0],
                alone(path, function, &[(x, y)])[0],
            ] {
                let same = result.to_bits() == expected.to_bits();
                assert!(
                    same || (result.is_nan() && expected.is_nan()),
                    "{function:?} of {x:?}, {y:?} is {result:?} on {path:?}, not {expected:?}"
                );
            }
        }
    }
}

const FUNCTIONS: [Function; 20] = [
    Function::Sin,
    Function::Cos,
    Function::Tan,
    Function::Asin,
    Function::Acos,
    Function::Atan,
    Function::Tanh,
    Function::Exp,
    Function::Ln,
    Function::Atan2,
    Function::Power,
    Function::Floor,
    Function::Sign,
    Function::Unwrap,
    Function::Sqrt,
    Function::Abs,
    Function::Quotient,
    Function::Smaller,
    Function::Larger,
    Function::Positive,
];

/// Bits, one pattern standing for all that are not numbers.
fn bits(results: Vec<f64>) -> Vec<u64> {
    results
        .into_iter()
        .map(|x| if x.is_nan() { f64::NAN } else { x }.to_bits())
        .collect()
}

/// What IEEE 754 defines to the last bit, and choices: as plain numbers do, whatever the numbers.
#[test]
fn square_roots_sizes_and_choices() {
    let exact = |function: Function, x: f64, y: f64| match function {
        Function::Sqrt => x.sqrt(),
        Function::Abs => x.abs(),
        Function::Quotient => x / y,
        Function::Smaller if x < y => x,
        Function::Larger if x > y => x,
        Function::Positive if x > 0.0 => y,
        Function::Positive => -y,
        _ => y,
    };
    let reference = Reference::new();
    let mut random = Random(9);
    let positive: Vec<_> = (0..2000)
        .map(|_| random.of_any_size(-1074, 1023).abs())
        .collect();
    check(Function::Sqrt, 0.5, &singly(positive), |x, _| {
        reference.sqrt(x)
    });
    let arguments = mixed(20_000);
    for path in paths() {
        for function in &FUNCTIONS[14..] {
            let expected = arguments
                .iter()
                .map(|&(x, y)| exact(*function, x, y))
                .collect();
            assert_eq!(
                bits(on_lanes(path, *function, &arguments)),
                bits(expected),
                "{function:?} on {path:?}"
            );
        }
    }
}

/// Pairs of every kind beside each other: ordinary, huge, infinite, not numbers.
fn mixed(count: usize) -> Vec<(f64, f64)> {
    let mut random = Random(7);
    let mut one = || match random.bits() % 8 {
        0 => random.of_any_size(-1074, 1023),
        1 => {
            [0.0, -0.0, f64::INFINITY, -f64::INFINITY, f64::NAN, 5e-324][random.bits() as usize % 6]
        }
        2 => random.between(-1e6, 1e6),
        _ => random.between(-4.0, 4.0),
    };
    (0..count).map(|_| (one(), one())).collect()
}

#[test]
fn a_lane_does_not_depend_on_the_others_nor_on_their_number() {
    let arguments = mixed(10_000);
    let others = Random(8).between(-1.0, 1.0);
    for path in paths() {
        for function in FUNCTIONS {
            let together = bits(on_lanes(path, function, &arguments));
            let alone = bits(alone(path, function, &arguments));
            let in_one_register = bits(in_one_register(path, function, &arguments));
            assert_eq!(together, in_one_register, "{function:?} on {path:?}");
            let spread: Vec<_> = arguments
                .iter()
                .flat_map(|&a| [(others, others), a, (f64::NAN, f64::INFINITY)])
                .collect();
            let spread = bits(on_lanes(path, function, &spread));
            for (i, argument) in arguments.iter().enumerate() {
                assert_eq!(
                    together[i], alone[i],
                    "{function:?} of {argument:?} on {path:?}"
                );
                assert_eq!(
                    together[i],
                    spread[3 * i + 1],
                    "{function:?} of {argument:?}"
                );
            }
        }
    }
}

#[test]
fn fused_paths_give_the_same_bits() {
    if Path::available() < Path::Avx512 {
        return;
    }
    let arguments = mixed(10_000);
    for function in FUNCTIONS {
        assert_eq!(
            bits(on_lanes(Path::Avx2, function, &arguments)),
            bits(on_lanes(Path::Avx512, function, &arguments)),
            "{function:?}"
        );
    }
}
