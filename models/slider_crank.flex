//! A flexure slider–crank: a crank moves a slide through a connecting rod, against a return spring.
model slider_crank

param r = 15 mm                    "length of the crank"
param l = 50 mm                    "length of the connecting rod"
param offset = 4 mm                "of the guide from the crank's pivot"
param mc = 4 g, mr = 9 g, ms = 20 g   "masses of crank, rod and slide"
param k = 0.3 N*m/rad              "stiffness of a hinge"
param c = 1e-5 N*m*s/rad           "damping of a hinge"
param kr = 400 N/m                 "stiffness of the return spring"
param torque = 0.1 N*m, f = 12 Hz  "drive of the crank"

ground O = (0 mm, 0 mm)

link crank from O to A { length = r, angle = 75 deg exact, mass = mc, symbol = φ }
link rod   from A to P { length = l, angle = -15 deg,      mass = mr, symbol = ψ }

slide piston along (1, 0) through (0 mm, offset) { mass = ms, at = 52 mm }
point P on piston at (0 mm, 0 mm)

hinge at O { stiffness = k, damping = c }
hinge at A { stiffness = k, damping = c }
hinge at P { stiffness = k, damping = c }

spring return between ground and piston { stiffness = kr }

coordinate crank.angle
torque on crank = torque * sin(2*pi*f*t)
gravity = (0, -9.81 m/s^2)

output position = piston.x    "position of the slide"
output velocity = piston.v    "velocity of the slide"
