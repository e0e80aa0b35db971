//! Chains of windows: four-bars in a row, each of which shares an upright with the next (IFToMM A02).

/// The lengths of the bars.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lengths {
    /// All the same: every upright turns with the first, every other bar moves in translation.
    Equal,
    /// Each window a hundredth of the first upright longer than the one before: no parallelogram.
    Unequal,
}

/// The model file of a chain with `count` windows, drawn with all uprights vertical.
pub fn windows(count: usize, lengths: Lengths) -> String {
    let (length, mass, foot) = match lengths {
        Lengths::Equal => ("l", "m", "i * l"),
        Lengths::Unequal => (
            "l * (1 + i / 100)",
            "m * (1 + i / 100)",
            "l * (i + i * (i + 1) / 200)",
        ),
    };
    format!(
        "model windows
const N = {count}
param l = 1 m, m = 1 kg
repeat i from 0 to N {{
  ground G[i] = ({foot}, 0 m)
}}
link upright[0] from G[0] to B[0] {{ length = l, angle = 90 deg exact, mass = m }}
repeat i from 1 to N {{
  link bar[i]     from B[i-1] to B[i] {{ length = {length}, angle =  0 deg, mass = {mass} }}
  link upright[i] from G[i]   to B[i] {{ length = {length}, angle = 90 deg, mass = {mass} }}
}}
coordinate upright[0].angle
gravity = (0, -9.81 m/s^2)
initial upright[0].rate = -1 rad/s
output x0 = B[0].x, y0 = B[0].y, v_x0 = B[0].vx, v_y0 = B[0].vy
output x = B[N].x, y = B[N].y, v_x = B[N].vx, v_y = B[N].vy
"
    )
}
