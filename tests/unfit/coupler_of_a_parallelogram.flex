// The angle of a coupler that a parallelogram keeps constant.
model unfit
param l = 20 mm, w = 30 mm
ground O = (0 mm, 0 mm), P = (w, 0 mm)
link a from O to B { length = l, angle = 60 deg, mass = 1 g }
link b from B to C { length = w, angle = 0 deg, mass = 1 g }
link c from P to C { length = l, angle = 60 deg, mass = 1 g }
coordinate b.angle
