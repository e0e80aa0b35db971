// A hinge formula must be named.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B { length = 20 mm, angle = 30 deg, mass = 1 g }
let k = circular_hinge(72 GPa, width = 3 mm, web = 1.5 mm, radius = 1 mm)
let m = circular_hinge(72 GPa, width = 3 mm, web = 1.5 mm, radius = 1 mm, formula = thick)
let n = circular_hinge(72 GPa, 3 mm, web = 1.5 N, raduis = 1 mm, formula = thin_web)
hinge at O { stiffness = k + m + n }
