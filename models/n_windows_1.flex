//! One window of the N-window chain of four-bars (IFToMM A02): three equal bars that fall and pass
//! through the positions in which all lie in one line.
//!
//! There the loop's branch is not determined by geometry; the bars stay parallel because they are
//! of the same length.
model n_windows_1

param l = 1 m           "length of a bar"
param m = 1 kg          "mass of a bar"

ground G0 = (0 m, 0 m)
ground G1 = (l, 0 m)

link upright0 from G0 to B0 { length = l, angle = 90 deg exact, mass = m }
link bar1     from B0 to B1 { length = l, angle =  0 deg,       mass = m }
link upright1 from G1 to B1 { length = l, angle = 90 deg,       mass = m }

coordinate upright0.angle
gravity = (0, -9.81 m/s^2)
initial upright0.rate = -1 rad/s

output x0 = B0.x    "horizontal position of the first upright's top"
output y0 = B0.y    "its height"
output v_x0 = B0.vx
output v_y0 = B0.vy
