// A third leg that takes away more freedom than there is.
model faulty
ground O = (0 mm, 0 mm), P = (30 mm, 0 mm), Q = (15 mm, 0 mm)
link a from O to B { length = 20 mm, angle = 45 deg, mass = 1 g }
link b from P to B { length = 20 mm, angle = 135 deg, mass = 1 g }
link c from Q to B { length = 14 mm, angle = 90 deg, mass = 1 g }
