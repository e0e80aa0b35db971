//! Forty windows of the N-window chain of four-bars (IFToMM A02): 81 equal bars that fall and pass
//! through the positions in which all lie in one line. Another N makes another chain.
model n_windows_40

const N = 40

param l = 1 m           "length of a bar"
param m = 1 kg          "mass of a bar"

repeat i from 0 to N {
  ground G[i] = (i * l, 0 m)
}

link upright[0] from G[0] to B[0] { length = l, angle = 90 deg exact, mass = m }
repeat i from 1 to N {
  link bar[i]     from B[i-1] to B[i] { length = l, angle =  0 deg, mass = m }
  link upright[i] from G[i]   to B[i] { length = l, angle = 90 deg, mass = m }
}

coordinate upright[0].angle
gravity = (0, -9.81 m/s^2)
initial upright[0].rate = -1 rad/s

output x0 = B[0].x    "horizontal position of the first upright's top"
output y0 = B[0].y    "its height"
output v_x0 = B[0].vx
output v_y0 = B[0].vy
