// A point on two bodies.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B { length = 20 mm, angle = 30 deg, mass = 1 g }
link rod from B to C { length = 20 mm, angle = 30 deg, mass = 1 g }
point A on crank at (3 mm, 0 mm)
point A on rod at (3 mm, 0 mm)
