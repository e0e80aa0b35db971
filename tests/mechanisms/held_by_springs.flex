//! A block that springs alone hold, with a pendulum on it: a body that no joint leads to.
model held_by_springs

param w = 20 mm, m = 10 g, cx = 8 mm, cy = 3 mm, i = 4e-7 kg*m^2
param l = 15 mm, mp = 2 g, k = 5 mN*m/rad
param k1 = 90 N/m, c1 = 0.05 N*s/m, k2 = 120 N/m, k3 = 70 N/m, free = 25 mm
param fx = 0.2 N, turn = 0.5 mN*m

ground O1 = (-20 mm, 2 mm), O2 = (42 mm, -3 mm), O3 = (4 mm, 31 mm)

point P = (1 mm, -2 mm)
link block from P to Q { length = w, angle = 12 deg, mass = m, com = (cx, cy), inertia = i }
point S on block at (5 mm, 9 mm)
link bob from Q to R { length = l, angle = -80 deg, mass = mp }
hinge at Q { stiffness = k }

spring s1 between O1 and P { stiffness = k1, damping = c1 }
spring s2 between O2 and Q { stiffness = k2 }
spring s3 between S and O3 { stiffness = k3, length = free }

force on S = (fx, 0 N)
torque on block = turn
gravity = (0, -9.81 m/s^2)
