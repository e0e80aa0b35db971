//! Two links in a row, led by x and y of the tip instead of their angles.
model two_link_arm

param l1 = 40 mm, l2 = 35 mm, px = 33 mm, py = 4 mm
param m1 = 6 g, m2 = 5 g, mt = 2 g
param k1 = 20 mN*m/rad, k2 = 15 mN*m/rad, c = 1e-5 N*m*s/rad

ground O = (0 mm, 0 mm)
link upper from O to E { length = l1, angle = 65 deg, mass = m1 }
link lower from E to T { length = l2, angle = -20 deg, mass = m2, mass at P = mt }
point P on lower at (px, py)
hinge at O { stiffness = k1, damping = c }
hinge at E { stiffness = k2, damping = c }

coordinate P.x, P.y
initial P.vx = 0.3 m/s
force on T = (0.1 N, -0.05 N)
gravity = (0, -9.81 m/s^2)
