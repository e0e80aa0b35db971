//! A six-bar flexure linkage (Stephenson III): a four-bar whose coupler moves a rocker on a third
//! pivot through a further link.
model six_bar

param l1 = 12 mm, l2 = 30 mm, l3 = 22 mm              "crank, coupler, rocker"
param cx = 14 mm, cy = 11 mm                          "C on the coupler"
param l5 = 21 mm, l6 = 17 mm                          "connecting link, output rocker"
param x2 = 32 mm, y2 = -3 mm, x3 = 38 mm, y3 = 22 mm  "second and third pivot"
param m1 = 0.8 g, m2 = 2.6 g, m3 = 1.5 g, m5 = 1.4 g, m6 = 1.1 g   "masses of the links"
param k = 1.2 N*m/rad                                 "stiffness of a hinge"
param c = 2e-6 N*m*s/rad                              "damping of a hinge"
param torque = 0.25 N*m, f = 60 Hz                    "drive of the crank"

ground O1 = (0 mm, 0 mm)
ground O2 = (x2, y2)
ground O3 = (x3, y3)

link crank   from O1 to A { length = l1, angle = 70 deg exact, mass = m1, symbol = φ1 }
link coupler from A to B  { length = l2, angle = 15 deg,  mass = m2, com = (l2/2, cy/3), symbol = φ2 }
link rocker  from O2 to B { length = l3, angle = 87 deg,  mass = m3, symbol = φ3 }
point C on coupler at (cx, cy)
link connector from C to D  { length = l5, angle = 36 deg,  mass = m5, symbol = φ5 }
link output_rocker from O3 to D { length = l6, angle = 111 deg, mass = m6, symbol = φ6 }

hinge at O1 { stiffness = k, damping = c }
hinge at A  { stiffness = k, damping = c }
hinge at B  { stiffness = k, damping = c }
hinge at O2 { stiffness = k, damping = c }
hinge at C  { stiffness = k, damping = c }
hinge at D  { stiffness = k, damping = c }
hinge at O3 { stiffness = k, damping = c }

coordinate crank.angle
torque on crank = torque * sin(2*pi*f*t)
gravity = (0, -9.81 m/s^2)

output swing = output_rocker.angle   "angle of the output rocker"
