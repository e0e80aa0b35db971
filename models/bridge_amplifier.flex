//! A bridge-type amplifier: a piezo stack spreads two blocks, and four inclined arms turn their
//! motion into a larger one of the output across it.
model bridge_amplifier

param l = 20 mm                     "length of an arm between its hinges"
param rise = 8 deg                  "inclination of the arms"
param ma = 0.8 g, mb = 4 g, mo = 12 g   "mass of an arm, of a block, of the output"
param k = 1.5 N*m/rad               "stiffness of a hinge"
param c = 2e-5 N*m*s/rad            "damping of a hinge"
param ks = 2e7 N/m, cs = 60 N*s/m   "piezo stack"
param stroke = 10 um, f = 200 Hz    "its free extension"
let height = l * sin(rise)

drive extension = sine(stroke, frequency = f)

ground O = (0 mm, 0 mm)

link lower_left  from O to A { length = l, angle = 180 deg - rise, mass = ma, mass at A = mb, symbol = φ1 }
link lower_right from O to B { length = l, angle = rise,           mass = ma, mass at B = mb, symbol = φ2 }
link upper_left  from P to A { length = l, angle = 180 deg + rise, mass = ma, symbol = φ3 }
link upper_right from P to B { length = l, angle = -rise,          mass = ma, symbol = φ4 }

slide table along (0, 1) through (0 mm, 0 mm) { mass = mo, at = 2 * height }
point P on table at (0 mm, 0 mm)

stack piezo between A and B { stiffness = ks, damping = cs, expansion = extension }

hinge at O between ground, lower_left      { stiffness = k, damping = c }
hinge at O between ground, lower_right     { stiffness = k, damping = c }
hinge at A                                 { stiffness = k, damping = c }
hinge at B                                 { stiffness = k, damping = c }
hinge at P between table, upper_left       { stiffness = k, damping = c }
hinge at P between table, upper_right      { stiffness = k, damping = c }

coordinate lower_left.angle

output stretch = B.x - A.x    "distance of the blocks"
output position = table.x     "position of the output"
