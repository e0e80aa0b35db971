//! A stage that hangs by two leaf springs from a frame that stands on two others: the stage's travel
//! is straight to second order, because what the frame sinks the stage rises.
//!
//! Leaves are pseudo-rigid links with a torsion spring at either end.
model double_parallelogram_stage

param E = 72 GPa                                    "elastic modulus"
param L = 40 mm, b = 10 mm, h = 0.5 mm              "length, width and thickness of a leaf"
param outer = 70 mm, inner = 40 mm                  "between the outer leaves, between the inner ones"
param ml = 0.54 g, mf = 25 g, ms = 60 g             "mass of a leaf, of the frame, of the stage"
param push = 1 N, f = 8 Hz                          "force on the stage"
let I = b * h^3 / 12                                "second moment of area"
let l = 0.8517 * L                                  "length of a pseudo-rigid link"
let k = 2 * 0.8517 * 2.65 * E * I / L               "stiffness at either end of a leaf"
let margin = (outer - inner) / 2

ground G1 = (0 mm, 0 mm)
ground G2 = (outer, 0 mm)

link left  from G1 to F1 { length = l,     angle = 90 deg exact, mass = ml, symbol = φ1 }
link right from G2 to F2 { length = l,     angle = 90 deg,       mass = ml }
link frame from F1 to F2 { length = outer, angle =  0 deg,       mass = mf }
point H1 on frame at (margin, 0 mm)
point H2 on frame at (margin + inner, 0 mm)

link inner_left  from H1 to P1 { length = l,     angle = -90 deg exact, mass = ml, symbol = φ2 }
link inner_right from H2 to P2 { length = l,     angle = -90 deg,       mass = ml }
link stage       from P1 to P2 { length = inner, angle =   0 deg,       mass = ms }

hinge at G1 { stiffness = k }
hinge at G2 { stiffness = k }
hinge at F1 { stiffness = k }
hinge at F2 { stiffness = k }
hinge at H1 { stiffness = k }
hinge at H2 { stiffness = k }
hinge at P1 { stiffness = k }
hinge at P2 { stiffness = k }

coordinate left.angle
coordinate inner_left.angle
force on P1 = (push * sin(2*pi*f*t), 0 N)

output x = P1.x    "position of the stage along its travel"
output y = P1.y    "its height"
