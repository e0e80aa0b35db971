//! Tables in lanes: what a lane gets depends on nothing in the others.

use flexure_runtime::lanes::{Lanes, Portable};
use flexure_runtime::real::Real;
use flexure_runtime::table::{Fit, Table};

/// 1 + 2 s - s³ and s², on an interval about `center`.
fn fit(center: f64, half_width: f64, degree: usize) -> Fit {
    let rows = [[1.0, 0.0], [2.0, 0.0], [0.0, 1.0], [-1.0, 0.0]];
    Fit {
        center,
        half_width,
        degree,
        error: 0.0,
        coefficients: rows[..=degree].iter().map(|row| row.to_vec()).collect(),
    }
}

#[test]
fn polynomials_and_closed_form() {
    let table = Table::<f64, 2>::new(&fit(1.0, 0.5, 3), 0);
    assert!(table.covers(1.25));
    let inside = [1.0 + 1.0 - 0.125, 0.25];
    assert_eq!(table.polynomials(1.25), inside);
    assert_eq!(table.where_covered(1.25, [7.0, 8.0]), inside);
    for outside in [0.5, 1.5, 2.0, f64::NAN] {
        assert!(!table.covers(outside));
        assert_eq!(table.where_covered(outside, [7.0, 8.0]), [7.0, 8.0]);
    }
    let none = Table::<f64, 2>::none();
    assert_eq!(none.where_covered(0.0, [7.0, 8.0]), [7.0, 8.0]);
}

#[test]
fn lanes_do_not_depend_on_each_other() {
    // Different intervals and degrees, one without a table, some coordinates outside.
    let tables = [
        Table::<f64, 2>::new(&fit(1.0, 0.5, 3), 0),
        Table::new(&fit(0.0, 2.0, 1), 0),
        Table::none(),
        Table::new(&fit(-1.0, 0.1, 2), 0),
    ];
    let mut joined: Table<Portable<4>, 2> = tables[0].map(Portable::from_f64);
    for (lane, table) in tables.iter().enumerate() {
        joined = joined.zip(table, |mut number, value| {
            number.set_entry(lane, value);
            number
        });
    }
    let closed = |q: f64| [q.exp(), q * q];
    for coordinates in [
        [1.1, 0.3, 0.0, -1.05],
        [2.0, 0.3, 0.1, -1.0],
        [2.0, 3.0, 0.1, 0.0],
        [0.7, -1.9, 5.0, -0.95],
    ] {
        let q = Portable::<4>::from_entries(|lane| coordinates[lane]);
        let each = coordinates.map(closed);
        let exact = std::array::from_fn(|k| Portable::from_entries(|lane| each[lane][k]));
        let together = joined.where_covered(q, exact);
        for (lane, table) in tables.iter().enumerate() {
            let alone = table.where_covered(coordinates[lane], each[lane]);
            for k in 0..2 {
                assert_eq!(together[k].entry(lane).to_bits(), alone[k].to_bits());
            }
        }
    }
}

#[test]
fn every_degree() {
    for degree in 0..=12 {
        let coefficients: Vec<Vec<f64>> = (0..=degree)
            .map(|power| vec![1.0 / (power as f64 + 1.0), f64::from(power as i32 % 3 - 1)])
            .collect();
        let fit = Fit {
            center: 2.0,
            half_width: 0.5,
            degree,
            error: 0.0,
            coefficients,
        };
        let table = Table::<f64, 2>::new(&fit, 0);
        for coordinate in [1.6, 1.9, 2.0, 2.3, 2.45] {
            let s = (coordinate - 2.0) / 0.5;
            for (k, found) in table.polynomials(coordinate).into_iter().enumerate() {
                let rows = fit.coefficients.iter().rev();
                let expected = rows.fold(0.0, |sum, row| sum * s + row[k]);
                assert!(
                    (found - expected).abs() < 1e-14,
                    "{degree}: {found} {expected}"
                );
            }
        }
    }
}
