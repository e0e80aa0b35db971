// A point on a body that does not exist.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B { length = 20 mm, angle = 30 deg, mass = 1 g }
point A on crnk at (1 mm, 0 mm)
