// Legs on both sides of a stage: rigid links cannot follow both.
model faulty
param l = 20 mm, w = 30 mm, h = 10 mm
ground A = (0 mm, 0 mm), B = (w, 0 mm), C = (0 mm, 2*l + h), D = (w, 2*l + h)
link stage from E to F { length = w, angle = 0 deg, mass = 1 g }
point G on stage at (0 mm, h)
point H on stage at (w, h)
link a from A to E { length = l, angle = 90 deg, mass = 1 g }
link b from B to F { length = l, angle = 90 deg, mass = 1 g }
link c from C to G { length = l, angle = -90 deg, mass = 1 g }
link d from D to H { length = l, angle = -90 deg, mass = 1 g }
