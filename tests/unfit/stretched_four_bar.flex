// A four-bar at the end of its crank's range.
model unfit
param l = 20 mm, lb = 30 mm, lc = 10 mm, w = 60 mm
ground O = (0 mm, 0 mm), P = (w, 0 mm)
link a from O to B { length = l, angle = 0 deg exact, mass = 1 g }
link b from B to C { length = lb, angle = 0 deg, mass = 1 g }
link c from P to C { length = lc, angle = 180 deg, mass = 1 g }
coordinate a.angle
