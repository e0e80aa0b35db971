// Massless links between ground and a mass.
model faulty
ground O = (0 mm, 0 mm)
link a from O to A { length = 20 mm, angle = 0 deg }
link b from A to B { length = 20 mm, angle = 0 deg }
link c from B to C { length = 20 mm, angle = 30 deg, mass at C = 1 g }
