//! A planar 3-RRR platform: three cranks on ground move a triangle in x, y and angle.
//!
//! With the platform's pose as coordinates each leg is a dyad and closes by one square root. With
//! the cranks' angles it would have no closed form: see `three_rrr_cranks`.
model three_rrr

param R = 60 mm, s = 40 mm                      "radius of the pivots, side of the platform"
param l1 = 34 mm, l2 = 30 mm                    "length of a crank, of a connecting link"
param m1 = 6 g, m2 = 6 g, mp = 30 g             "masses of a crank, a connecting link, the platform"
param k = 0.3 N*m/rad                           "stiffness of a hinge"
param c = 2e-5 N*m*s/rad                        "damping of a hinge"
param torque = 0.05 N*m, f = 8 Hz               "drive of the cranks"

ground O1 = (R * cos(210 deg), R * sin(210 deg))
ground O2 = (R * cos(330 deg), R * sin(330 deg))
ground O3 = (R * cos(90 deg), R * sin(90 deg))

link crank1 from O1 to A1 { length = l1, angle =  80 deg, mass = m1, symbol = φ1 }
link crank2 from O2 to A2 { length = l1, angle = 200 deg, mass = m1, symbol = φ2 }
link crank3 from O3 to A3 { length = l1, angle = 320 deg, mass = m1, symbol = φ3 }

point P1 = (-s/2, -s * sqrt(3)/6)   // the platform's centre of mass starts at (0, 0)
link platform from P1 to P2 { length = s, angle = 0 deg exact, mass = mp, com = (s/2, s * sqrt(3)/6), inertia = mp * s^2 / 12, symbol = θ }
point P3 on platform at (s/2, s * sqrt(3)/2)

link rod1 from A1 to P1 { length = l2, angle = -30 deg, mass = m2, symbol = ψ1 }
link rod2 from A2 to P2 { length = l2, angle =  90 deg, mass = m2, symbol = ψ2 }
link rod3 from A3 to P3 { length = l2, angle = 210 deg, mass = m2, symbol = ψ3 }

hinge at O1 { stiffness = k, damping = c }
hinge at O2 { stiffness = k, damping = c }
hinge at O3 { stiffness = k, damping = c }
hinge at A1 { stiffness = k, damping = c }
hinge at A2 { stiffness = k, damping = c }
hinge at A3 { stiffness = k, damping = c }
hinge at P1 { stiffness = k, damping = c }
hinge at P2 { stiffness = k, damping = c }
hinge at P3 { stiffness = k, damping = c }

coordinate platform.P1.x, platform.P1.y, platform.angle
torque on crank1 = torque * sin(2*pi*f*t)
torque on crank2 = torque * cos(2*pi*f*t)
torque on crank3 = -torque * sin(2*pi*f*t)

output x = P1.x               "position of the platform's first corner"
output y = P1.y               "its height"
output turn = platform.angle  "angle of the platform"
