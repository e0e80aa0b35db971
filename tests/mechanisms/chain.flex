//! Pendulums side by side, tied to each other by springs: each turn of the repeat is one bar on a
//! flexure hinge and the spring to its neighbour. A bob, a component, hangs from the end of each
//! bar on a hinge of its own.
model chain

const N = 2
param l = 40 mm, m = 8 g, k = 2e-3 N*m/rad, c = 1e-6 N*m*s/rad
param bob = 3 g, arm = 6 mm, pitch = 15 mm, ks = 0.5 N/m

component weight(lever: length, load: mass, stiffness: N*m/rad = 1e-3 N*m/rad) {
  link bar from Top to Tip { length = lever, angle = -85 deg, mass = load }
  hinge at Top between bar, carrier { stiffness = stiffness }
}

repeat i from 0 to N {
  ground G[i] = (i * pitch, 0 mm)
}
repeat i from 1 to N {
  link bar[i] from G[i] to B[i] { length = l, angle = (5 * i - 90) * 1 deg, mass = m, symbol = φ[i] }
  hinge at G[i] { stiffness = k, damping = c }
  part bob[i] = weight(lever = arm, load = bob) at Top = B[i], carrier = bar[i]
}
spring first between G[0] and bob1.Tip { stiffness = ks }
repeat i from 2 to N {
  spring tie[i] between B[i-1] and B[i] { stiffness = ks }
}
gravity = (0, -9.81 m/s^2)
output x = B[N].x, y = bob[N].bar.Tip.y
