//! A serial xy stage: a platform on two leaf springs on a frame, which stands on two others; a piezo
//! stack moves each.
//!
//! Leaves are pseudo-rigid links with a torsion spring at either end.
model xy_stage

param E = 72 GPa                                "elastic modulus"
param L = 30 mm, b = 12 mm, h = 0.8 mm          "length, width and thickness of a leaf"
param w = 60 mm                                 "between the leaves"
param ml = 0.8 g, mf = 120 g, mp = 45 g         "mass of a leaf, of the frame, of the platform"
param c = 1e-4 N*m*s/rad                        "damping at either end of a leaf"
param ks = 2e6 N/m, cs = 40 N*s/m               "piezo stacks"
param stroke = 20 um, fx = 80 Hz, fy = 110 Hz   "their free extensions"
let I = b * h^3 / 12                            "second moment of area"
let l = 0.8517 * L                              "length of a pseudo-rigid link"
let k = 2 * 0.8517 * 2.65 * E * I / L           "stiffness at either end of a leaf"

drive ux = sine(stroke, frequency = fx)
drive uy = sine(stroke, frequency = fy)

ground G1 = (0 mm, 0 mm)
ground G2 = (w, 0 mm)
ground S  = (-20 mm, l)

link left  from G1 to F1 { length = l, angle = 90 deg exact, mass = ml, symbol = φ1 }
link right from G2 to F2 { length = l, angle = 90 deg,       mass = ml }
link frame from F1 to F2 { length = w, angle =  0 deg,       mass = mf }

point H1 on frame at (0 mm, 10 mm)
point H2 on frame at (0 mm, 10 mm + w)
point T  on frame at (l, 5 mm)

link lower    from H1 to P1 { length = l, angle =  0 deg exact, mass = ml, symbol = φ2 }
link upper    from H2 to P2 { length = l, angle =  0 deg,       mass = ml }
link platform from P1 to P2 { length = w, angle = 90 deg,       mass = mp }

stack x_stack between S and F1 along (1, 0) { stiffness = ks, damping = cs, expansion = ux }
stack y_stack between T and P1 along (0, 1) { stiffness = ks, damping = cs, expansion = uy }

hinge at G1 { stiffness = k, damping = c }
hinge at G2 { stiffness = k, damping = c }
hinge at F1 { stiffness = k, damping = c }
hinge at F2 { stiffness = k, damping = c }
hinge at H1 { stiffness = k, damping = c }
hinge at H2 { stiffness = k, damping = c }
hinge at P1 { stiffness = k, damping = c }
hinge at P2 { stiffness = k, damping = c }

coordinate left.angle
coordinate lower.angle

output x = P1.x    "position of the platform"
output y = P1.y    "its height"
