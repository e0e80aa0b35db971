// A third parallel leg, equal in the defaults only.
model faulty
param l = 20 mm, l3 = 20 mm, w = 30 mm
ground O = (0 mm, 0 mm), P = (w, 0 mm), Q = (w / 2, 0 mm)
link a from O to B { length = l, angle = 80 deg, mass = 1 g }
link p from B to C { length = w, angle = 0 deg, mass = 1 g }
point M on p at (w / 2, 0 mm)
link c from P to C { length = l, angle = 80 deg, mass = 1 g }
link third from Q to M { length = l3, angle = 80 deg, mass = 1 g }
