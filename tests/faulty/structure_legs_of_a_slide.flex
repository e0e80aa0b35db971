// A slide between two legs.
model faulty
param l = 20 mm, w = 30 mm
ground A = (-w, 0 mm), B = (w, 0 mm)
slide stage along (0, 1) { at = 10 mm, mass = 1 g }
point S on stage at (0 mm, 0 mm)
link a from A to S { length = l + w, angle = 10 deg, mass = 1 g }
link b from B to S { length = l + w, angle = 170 deg, mass = 1 g }
