//! A stage on two leaf springs, each as a pseudo-rigid link with a torsion spring at either end.
//!
//! A leaf whose ends stay parallel: a link of 0.8517 of its length and stiffness 2 γ K_Θ E I / L at
//! either end, K_Θ = 2.65 (Howell, Compliant Mechanisms, 2001). The stage moves in translation.
model parallelogram_stage

param E = 72 GPa                                    "elastic modulus"
param L = 40 mm, b = 10 mm, h = 0.5 mm              "length, width and thickness of a leaf"
param gap = 50 mm                                   "between the leaves"
param ml = 0.54 g, ms = 60 g                        "mass of a leaf, of the stage"
param push = 2 N, f = 15 Hz                         "force on the stage"
let I = b * h^3 / 12                                "second moment of area"
let l = 0.8517 * L                                  "length of the pseudo-rigid link"
let k = 2 * 0.8517 * 2.65 * E * I / L               "stiffness at either end of a leaf"

ground G1 = (0 mm, 0 mm)
ground G2 = (gap, 0 mm)

link left  from G1 to P1 { length = l,   angle = 90 deg exact, mass = ml, symbol = φ }
link right from G2 to P2 { length = l,   angle = 90 deg,       mass = ml }
link stage from P1 to P2 { length = gap, angle =  0 deg,       mass = ms }

hinge at G1 { stiffness = k }
hinge at G2 { stiffness = k }
hinge at P1 { stiffness = k }
hinge at P2 { stiffness = k }

coordinate left.angle
force on P1 = (push * sin(2*pi*f*t), 0 N)

output x = P1.x    "position of the stage along its travel"
output y = P1.y    "its height, which falls as it travels"
