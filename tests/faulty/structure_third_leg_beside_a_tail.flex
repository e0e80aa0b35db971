// A third parallel leg, equal, with another freedom beside it.
model faulty
ground O = (0 mm, 0 mm), P = (60 mm, 0 mm), Q = (30 mm, 0 mm)
link a from O to A { length = 20 mm, angle = 90 deg, mass = 1 g }
link b from P to B { length = 20 mm, angle = 90 deg, mass = 1 g }
link p from A to B { length = 60 mm, angle = 0 deg, mass = 1 g }
point M on p at (30 mm, 0 mm)
link q from Q to M { length = 20 mm, angle = 90 deg, mass = 1 g }
link tail from A to T { length = 25 mm, angle = 60 deg, mass = 1 g }
