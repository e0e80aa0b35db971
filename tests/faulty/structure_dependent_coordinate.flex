// Two angles of one loop.
model faulty
param l = 20 mm
ground O = (0 mm, 0 mm), P = (30 mm, 0 mm)
link a from O to B { length = 20 mm, angle = 60 deg, mass = 1 g }
link b from B to C { length = 30 mm, angle = 0 deg, mass = 1 g }
link c from P to C { length = 20 mm, angle = 60 deg, mass = 1 g }
link tail from C to D { length = l, angle = 0 deg, mass = 1 g }
coordinate a.angle, c.angle
