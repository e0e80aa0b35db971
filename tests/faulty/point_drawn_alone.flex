// A drawn point that no body has.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B { length = 20 mm, angle = 30 deg, mass = 1 g }
point P = (3 mm, 4 mm)
