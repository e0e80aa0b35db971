// A link with both ends on ground.
model faulty
param w = 30 mm
ground O = (0 mm, 0 mm), P = (w, 0 mm)
link a from O to P { mass = 1 g }
link b from O to B { length = w, angle = 0 deg, mass = 1 g }
