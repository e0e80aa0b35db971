//! Coefficients of Dormand and Prince's pair 8(5,3) with dense output of order 7, in stages'
//! positions from 1.
//!
//! From E. Hairer, S. P. Nørsett, G. Wanner: Solving Ordinary Differential Equations I, second
//! edition, Springer 1993, section II.5 and II.6, and the authors' code DOP853. Stage 13 is the rate
//! at the end of the step; 14 to 16 serve the dense output alone. Those not listed are zero.
//! The tests below check that they satisfy the order conditions.

/// A position of a stage, from 1, and its coefficient.
pub(super) type Entry = (usize, f64);

/// Times of the stages, in steps.
pub(super) const TIMES: [f64; 16] = [
    0.0,
    0.05260015195876773,
    0.0789002279381516,
    0.1183503419072274,
    0.2816496580927726,
    0.3333333333333333,
    0.25,
    0.3076923076923077,
    0.6512820512820513,
    0.6,
    0.8571428571428571,
    1.0,
    1.0,
    0.1,
    0.2,
    0.7777777777777778,
];

/// What each stage adds up, from the second to the sixteenth.
pub(super) mod stage {
    /// Stage 2.
    pub const A2: [super::Entry; 1] = [(1, 0.05260015195876773)];
    /// Stage 3.
    pub const A3: [super::Entry; 2] = [(1, 0.0197250569845379), (2, 0.0591751709536137)];
    /// Stage 4.
    pub const A4: [super::Entry; 2] = [(1, 0.02958758547680685), (3, 0.08876275643042054)];
    /// Stage 5.
    pub const A5: [super::Entry; 3] = [
        (1, 0.2413651341592667),
        (3, -0.8845494793282861),
        (4, 0.924834003261792),
    ];
    /// Stage 6.
    pub const A6: [super::Entry; 3] = [
        (1, 0.037037037037037035),
        (4, 0.17082860872947386),
        (5, 0.12546768756682242),
    ];
    /// Stage 7.
    pub const A7: [super::Entry; 4] = [
        (1, 0.037109375),
        (4, 0.17025221101954405),
        (5, 0.06021653898045596),
        (6, -0.017578125),
    ];
    /// Stage 8.
    pub const A8: [super::Entry; 5] = [
        (1, 0.03709200011850479),
        (4, 0.17038392571223998),
        (5, 0.10726203044637328),
        (6, -0.015319437748624402),
        (7, 0.008273789163814023),
    ];
    /// Stage 9.
    pub const A9: [super::Entry; 6] = [
        (1, 0.6241109587160757),
        (4, -3.3608926294469414),
        (5, -0.868219346841726),
        (6, 27.59209969944671),
        (7, 20.154067550477894),
        (8, -43.48988418106996),
    ];
    /// Stage 10.
    pub const A10: [super::Entry; 7] = [
        (1, 0.47766253643826434),
        (4, -2.4881146199716677),
        (5, -0.590290826836843),
        (6, 21.230051448181193),
        (7, 15.279233632882423),
        (8, -33.28821096898486),
        (9, -0.020331201708508627),
    ];
    /// Stage 11.
    pub const A11: [super::Entry; 8] = [
        (1, -0.9371424300859873),
        (4, 5.186372428844064),
        (5, 1.0914373489967295),
        (6, -8.149787010746927),
        (7, -18.52006565999696),
        (8, 22.739487099350505),
        (9, 2.4936055526796523),
        (10, -3.0467644718982196),
    ];
    /// Stage 12.
    pub const A12: [super::Entry; 9] = [
        (1, 2.273310147516538),
        (4, -10.53449546673725),
        (5, -2.0008720582248625),
        (6, -17.9589318631188),
        (7, 27.94888452941996),
        (8, -2.8589982771350235),
        (9, -8.87285693353063),
        (10, 12.360567175794303),
        (11, 0.6433927460157636),
    ];
    /// Stage 14.
    pub const A14: [super::Entry; 8] = [
        (1, 0.056167502283047954),
        (7, 0.25350021021662483),
        (8, -0.2462390374708025),
        (9, -0.12419142326381637),
        (10, 0.15329179827876568),
        (11, 0.00820105229563469),
        (12, 0.007567897660545699),
        (13, -0.008298),
    ];
    /// Stage 15.
    pub const A15: [super::Entry; 8] = [
        (1, 0.03183464816350214),
        (6, 0.028300909672366776),
        (7, 0.053541988307438566),
        (8, -0.05492374857139099),
        (11, -0.00010834732869724932),
        (12, 0.0003825710908356584),
        (13, -0.00034046500868740456),
        (14, 0.1413124436746325),
    ];
    /// Stage 16.
    pub const A16: [super::Entry; 8] = [
        (1, -0.42889630158379194),
        (6, -4.697621415361164),
        (7, 7.683421196062599),
        (8, 4.06898981839711),
        (9, 0.3567271874552811),
        (13, -0.0013990241651590145),
        (14, 2.9475147891527724),
        (15, -9.15095847217987),
    ];
}

/// The solution, of order 8.
pub(super) const WEIGHTS: [Entry; 8] = [
    (1, 0.054293734116568765),
    (6, 4.450312892752409),
    (7, 1.8915178993145003),
    (8, -5.801203960010585),
    (9, 0.3111643669578199),
    (10, -0.1521609496625161),
    (11, 0.20136540080403034),
    (12, 0.04471061572777259),
];

/// The solution less that of order 5.
pub(super) const ERROR5: [Entry; 8] = [
    (1, 0.01312004499419488),
    (6, -1.2251564463762044),
    (7, -0.4957589496572502),
    (8, 1.6643771824549864),
    (9, -0.35032884874997366),
    (10, 0.3341791187130175),
    (11, 0.08192320648511571),
    (12, -0.022355307863886294),
];

/// Combines the stages so that order conditions up to order 6 leave nothing: all combinations of the
/// rates at the start and of stages 6 to 13 that do are multiples of this one, here of length 1.
/// Found as the null space of those conditions, with 40 digits.
pub(super) const ERROR6: [Entry; 7] = [
    (1, -0.0022358123565388577),
    (6, 0.6070328897520147),
    (7, 0.18735227557215262),
    (8, -0.7644785856545327),
    (9, 0.06370729189530164),
    (10, -0.0889561933835949),
    (11, -0.0024218658248025674),
];

/// The solution of order 3.
const ORDER3: [Entry; 3] = [
    (1, 0.2440944881889764),
    (9, 0.7338466882816118),
    (12, 0.022058823529411766),
];

/// The solution less that of order 3.
pub(super) const ERROR3: [Entry; 8] = {
    let mut error = WEIGHTS;
    error[0].1 -= ORDER3[0].1;
    error[4].1 -= ORDER3[1].1;
    error[7].1 -= ORDER3[2].1;
    error
};

/// Dense output: its coefficient of order 4.
pub(super) const DENSE4: [Entry; 12] = [
    (1, -8.428938276109013),
    (6, 0.5667149535193777),
    (7, -3.0689499459498917),
    (8, 2.38466765651207),
    (9, 2.117034582445028),
    (10, -0.871391583777973),
    (11, 2.2404374302607883),
    (12, 0.6315787787694688),
    (13, -0.08899033645133331),
    (14, 18.148505520854727),
    (15, -9.194632392478356),
    (16, -4.436036387594894),
];

/// Dense output: its coefficient of order 5.
pub(super) const DENSE5: [Entry; 12] = [
    (1, 10.427508642579134),
    (6, 242.28349177525817),
    (7, 165.20045171727028),
    (8, -374.5467547226902),
    (9, -22.113666853125306),
    (10, 7.733432668472264),
    (11, -30.674084731089398),
    (12, -9.332130526430229),
    (13, 15.697238121770845),
    (14, -31.139403219565178),
    (15, -9.35292435884448),
    (16, 35.81684148639408),
];

/// Dense output: its coefficient of order 6.
pub(super) const DENSE6: [Entry; 12] = [
    (1, 19.985053242002433),
    (6, -387.0373087493518),
    (7, -189.17813819516758),
    (8, 527.8081592054236),
    (9, -11.57390253995963),
    (10, 6.8812326946963),
    (11, -1.0006050966910838),
    (12, 0.7777137798053443),
    (13, -2.778205752353508),
    (14, -60.19669523126412),
    (15, 84.32040550667716),
    (16, 11.99229113618279),
];

/// Dense output: its coefficient of order 7.
pub(super) const DENSE7: [Entry; 12] = [
    (1, -25.69393346270375),
    (6, -154.18974869023643),
    (7, -231.5293791760455),
    (8, 357.6391179106141),
    (9, 93.40532418362432),
    (10, -37.45832313645163),
    (11, 104.0996495089623),
    (12, 29.8402934266605),
    (13, -43.53345659001114),
    (14, 96.32455395918828),
    (15, -39.17726167561544),
    (16, -149.72683625798564),
];
#[cfg(test)]
mod tests {
    use super::*;

    /// All stages as a full matrix.
    fn matrix() -> [[f64; 16]; 16] {
        let rows: [&[Entry]; 16] = [
            &[],
            &stage::A2,
            &stage::A3,
            &stage::A4,
            &stage::A5,
            &stage::A6,
            &stage::A7,
            &stage::A8,
            &stage::A9,
            &stage::A10,
            &stage::A11,
            &stage::A12,
            &WEIGHTS,
            &stage::A14,
            &stage::A15,
            &stage::A16,
        ];
        rows.map(full)
    }

    fn full(row: &[Entry]) -> [f64; 16] {
        let mut full = [0.0; 16];
        for &(position, coefficient) in row {
            full[position - 1] = coefficient;
        }
        full
    }

    /// A rooted tree: its number of nodes, γ, and for each stage the product of the sums that its
    /// branches stand for.
    struct Tree {
        order: usize,
        gamma: f64,
        stages: [f64; 16],
    }

    /// All rooted trees up to an order: every multiset of smaller trees on a common root.
    fn trees(largest: usize) -> Vec<Tree> {
        let a = matrix();
        let mut trees: Vec<Tree> = Vec::new();
        for order in 1..=largest {
            let mut grown = Vec::new();
            grow(
                &trees,
                &a,
                trees.len(),
                order - 1,
                1.0,
                [1.0; 16],
                &mut |gamma, stages| {
                    grown.push(Tree {
                        order,
                        gamma: gamma * order as f64,
                        stages,
                    });
                },
            );
            trees.append(&mut grown);
        }
        trees
    }

    fn grow(
        trees: &[Tree],
        a: &[[f64; 16]; 16],
        below: usize,
        left: usize,
        gamma: f64,
        stages: [f64; 16],
        found: &mut dyn FnMut(f64, [f64; 16]),
    ) {
        if left == 0 {
            return found(gamma, stages);
        }
        for index in (0..below).filter(|&index| trees[index].order <= left) {
            let branch = &trees[index];
            let mut with = stages;
            for (product, row) in with.iter_mut().zip(a) {
                *product *= row
                    .iter()
                    .zip(&branch.stages)
                    .map(|(a, s)| a * s)
                    .sum::<f64>();
            }
            let left = left - branch.order;
            grow(trees, a, index + 1, left, gamma * branch.gamma, with, found);
        }
    }

    /// The largest violation of the order conditions up to `order`, at a fraction of the step.
    fn violation(weights: &[f64; 16], order: usize, fraction: f64) -> f64 {
        trees(order)
            .iter()
            .map(|tree| {
                let sum: f64 = weights.iter().zip(&tree.stages).map(|(w, s)| w * s).sum();
                (sum - fraction.powi(tree.order as i32) / tree.gamma).abs()
            })
            .fold(0.0, f64::max)
    }

    #[test]
    fn there_are_as_many_trees_as_there_should_be() {
        let count = |order| trees(8).iter().filter(|t| t.order == order).count();
        assert_eq!(
            [1, 2, 3, 4, 5, 6, 7, 8].map(count),
            [1, 1, 2, 4, 9, 20, 48, 115]
        );
    }

    #[test]
    fn stages_stand_at_their_times() {
        for (row, time) in matrix().iter().zip(TIMES) {
            assert!((row.iter().sum::<f64>() - time).abs() < 1e-13);
        }
    }

    #[test]
    fn orders_are_8_6_5_and_3_and_no_more() {
        let weights = full(&WEIGHTS);
        assert!(violation(&weights, 8, 1.0) < 1e-13);
        assert!(violation(&weights, 9, 1.0) > 1e-9);
        let mut fifth = weights;
        for (weight, error) in fifth.iter_mut().zip(full(&ERROR5)) {
            *weight -= error;
        }
        assert!(violation(&fifth, 5, 1.0) < 1e-13);
        assert!(violation(&fifth, 6, 1.0) > 1e-6);
        let mut sixth = weights;
        for (weight, error) in sixth.iter_mut().zip(full(&ERROR6)) {
            *weight -= error;
        }
        assert!(violation(&sixth, 6, 1.0) < 1e-13);
        assert!(violation(&sixth, 7, 1.0) > 1e-6);
        assert!(violation(&full(&ORDER3), 3, 1.0) < 1e-13);
        assert!(violation(&full(&ORDER3), 4, 1.0) > 1e-6);
    }

    #[test]
    fn dense_output_is_of_order_7() {
        for fraction in [0.1, 0.37, 0.5, 0.9] {
            let weights: [f64; 16] = std::array::from_fn(|stage| {
                let rate = |row: &[Entry]| full(row)[stage];
                let start = if stage == 0 { 1.0 } else { 0.0 };
                let end = if stage == 12 { 1.0 } else { 0.0 };
                let whole = rate(&WEIGHTS);
                super::super::dormand_prince::polynomial(
                    &[
                        whole,
                        start - whole,
                        2.0 * whole - start - end,
                        rate(&DENSE4),
                        rate(&DENSE5),
                        rate(&DENSE6),
                        rate(&DENSE7),
                    ],
                    fraction,
                )
            });
            assert!(violation(&weights, 7, fraction) < 1e-12);
            assert!(violation(&weights, 8, fraction) > 1e-9);
        }
    }
}
