//! A slide on a turning arm: two coordinates coupled by inertia, a guide that turns.
model slide_on_link

param l = 40 mm, ma = 2 g, ra = 15 mm, ba = 20 deg, ia = 3e-7 kg*m^2
param mb = 1.5 g, bx = 2 mm, by = -1 mm, ib = 2e-8 kg*m^2
param px = 6 mm, py = 4 mm, start = 3 mm
param k = 0.8 N*m/rad, c = 1e-4 N*m*s/rad, rest = 0.2
param k1 = 300 N/m, c1 = 0.2 N*s/m, k2 = 200 N/m, c2 = 0.1 N*s/m, free = 8 mm
param fx = 0.5 N, fy = -0.3 N, turn = 4 mN*m
param qx = 7 mm, qy = -3 mm, mq = 0.4 g

ground O = (0 mm, 0 mm)
ground G = (30 mm, 35 mm)

link arm from O to T { length = l, angle = 30 deg exact, mass = ma, com = polar(ra, ba), inertia = ia }
hinge at O { stiffness = k, damping = c, rest = rest }

slide bead on arm along (0.8, 0.6) through (px, py) { mass = mb, com = (bx, by), inertia = ib, at = start, mass at Q = mq }
point Q on bead at (qx, qy)

spring holding between T and bead { stiffness = k1, damping = c1 }
spring tether between G and Q { stiffness = k2, damping = c2, length = free }
spring sideways between G and bead along (1, 0) { stiffness = k2 }

force on Q = (fx, fy)
torque on arm = turn
gravity = (1 m/s^2, -9.81 m/s^2)
