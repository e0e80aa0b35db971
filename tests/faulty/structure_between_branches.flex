// A loop drawn right between the two ways in which it closes.
model faulty
ground O = (0 mm, 0 mm), P = (30 mm, 0 mm)
link a from O to B { length = 20 mm, angle = 0 deg, mass = 1 g }
link b from B to C { length = 20 mm, angle = 0 deg, mass = 1 g }
link c from P to C { length = 20 mm, angle = 180 deg, mass = 1 g }
coordinate a.angle
