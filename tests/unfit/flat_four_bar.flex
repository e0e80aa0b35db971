// A four-bar drawn flat: all in one line.
model unfit
ground O = (0 mm, 0 mm), P = (60 mm, 0 mm)
link a from O to B { length = 20 mm, angle = 0 deg, mass = 1 g }
link b from B to C { length = 30 mm, angle = 0 deg, mass = 1 g }
link c from P to C { length = 10 mm, angle = 180 deg, mass = 1 g }
coordinate a.angle
