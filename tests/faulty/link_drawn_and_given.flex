// A length beside drawn ends, which give it.
model faulty
ground O = (0 mm, 0 mm)
point B = (10 mm, 20 mm)
link crank from O to B { length = 20 mm, mass = 1 g }
link rod from B to C { length = 20 mm, angle = 3 deg, mass = 1 g }
