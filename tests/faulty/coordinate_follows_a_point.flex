// A point's coordinate beside one that determines it.
model faulty
ground O = (0 mm, 0 mm), Q = (30 mm, 0 mm)
link a from O to A { length = 20 mm, angle = 80 deg, mass = 1 g }
link b from A to B { length = 30 mm, angle = 5 deg, mass = 1 g }
link c from Q to B { length = 22 mm, angle = 85 deg, mass = 1 g }
coordinate b.A.x, b.B.x
