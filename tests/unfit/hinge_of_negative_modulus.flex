// A hinge of negative modulus and no thickness.
model unfit
param E = -72 GPa
let k = circular_hinge(E, width = 5 mm, web = 0 mm, radius = 2 mm, formula = thin_web)
ground O = (0 mm, 0 mm)
link a from O to A { length = 20 mm, angle = 0 deg, mass = 1 g }
hinge at O { stiffness = k }
