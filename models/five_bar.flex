//! A five-bar: two cranks on ground move the pin where their couplers meet, in both directions.
model five_bar

param base = 40 mm                            "between the cranks' pivots"
param l1 = 25 mm, l2 = 35 mm                  "length of a crank, of a coupler"
param m1 = 5 g, m2 = 6 g, mt = 8 g            "mass of a crank, of a coupler, of the tool"
param k = 0.4 N*m/rad                         "stiffness of a hinge"
param c = 2e-5 N*m*s/rad                      "damping of a hinge"
param left_torque = 0.08 N*m, right_torque = 0.05 N*m   "drives"
param f = 12 Hz                               "their frequency"

ground O1 = (0 mm, 0 mm)
ground O2 = (base, 0 mm)

link left_crank    from O1 to A { length = l1, angle = 120 deg exact, mass = m1, symbol = φ1 }
link right_crank   from O2 to B { length = l1, angle =  60 deg exact, mass = m1, symbol = φ2 }
link left_coupler  from A to P  { length = l2, angle =  25 deg, mass = m2, mass at P = mt, symbol = φ3 }
link right_coupler from B to P  { length = l2, angle = 155 deg, mass = m2, symbol = φ4 }

hinge at O1 { stiffness = k, damping = c }
hinge at O2 { stiffness = k, damping = c }
hinge at A  { stiffness = k, damping = c }
hinge at B  { stiffness = k, damping = c }
hinge at P  { stiffness = k, damping = c }

coordinate left_crank.angle
coordinate right_crank.angle
torque on left_crank  = left_torque * sin(2*pi*f*t)
torque on right_crank = right_torque * cos(2*pi*f*t)

output x = P.x    "position of the tool"
output y = P.y    "its height"
