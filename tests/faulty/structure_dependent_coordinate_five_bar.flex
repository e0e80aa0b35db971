// Three angles of a mechanism with two degrees of freedom.
model faulty
ground O = (0 mm, 0 mm), P = (60 mm, 0 mm)
link a from O to A { length = 20 mm, angle = 100 deg, mass = 1 g }
link b from A to C { length = 40 mm, angle = 30 deg, mass = 1 g }
link c from P to B { length = 20 mm, angle = 80 deg, mass = 1 g }
link d from B to C { length = 40 mm, angle = 150 deg, mass = 1 g }
coordinate a.angle, b.angle, c.angle
