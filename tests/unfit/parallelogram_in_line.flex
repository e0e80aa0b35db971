// A parallelogram in line whose cranks are equal in value only.
model unfit
param r = 10 mm, l = 30 mm, r2 = 10 mm
ground O = (0 mm, 0 mm), P = (l, 0 mm)
link a from O to B { length = r, angle = 0 deg exact, mass = 1 g }
link b from B to C { length = l, angle = 0 deg, mass = 1 g }
link c from P to C { length = r2, angle = 0 deg, mass = 1 g }
coordinate a.angle
