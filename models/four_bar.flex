//! The flexure mechanism of the double-rocker actuator alone: a four-bar of slender bars with
//! flexure hinges, released with the crank turning.
//!
//! A check case: its energy is constant, and its motion is known to ten digits from an independent
//! integration in absolute coordinates.
model four_bar

param E  = 72 GPa                                          "elastic modulus"
param b  = 3 mm                                            "width, out of plane"
param e  = 1.5 mm                                          "hinge web thickness"
param r  = 1 mm                                            "hinge radius"
param l1 = 10.2 mm, l2 = 23.2 mm, l3 = 10 mm, l4 = 25 mm   "length of a link"
param m1 = 0.2568 g, m2 = 0.5877 g, m3 = 0.2529 g          "mass of a link"
let   k  = circular_hinge(E, width = b, web = e, radius = r, formula = thin_web)  "stiffness of a hinge"

ground O1 = (0 mm, 0 mm)
ground O2 = (l4, 0 mm)

link crank   from O1 to B { length = l1, angle = 80 deg exact, mass = m1, symbol = φ1 }
link coupler from B  to D { length = l2, angle =  0 deg,       mass = m2, symbol = φ2 }
link rocker  from O2 to D { length = l3, angle = 90 deg,       mass = m3, symbol = φ3 }

hinge at O1 { stiffness = k }
hinge at B  { stiffness = k }
hinge at D  { stiffness = k }
hinge at O2 { stiffness = k }

coordinate crank.angle
gravity = (0, -9.81 m/s^2)

initial crank.rate = 20 rad/s

output rate   = crank.rate      "rate of the crank"
output torque = B.torque        "torque of the hinge between crank and coupler"
output energy_total = energy.total   "kinetic and potential energy: constant"
