// A guide through a point of another body.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B { length = 20 mm, angle = 30 deg, mass = 1 g }
slide s along (1, 0) from B { mass = 50 g }
