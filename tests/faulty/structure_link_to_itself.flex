// A link from a point to itself.
model faulty
ground O = (0 mm, 0 mm)
link b from O to A { length = 20 mm, angle = 0 deg, mass = 1 g }
link a from A to A { length = 20 mm, angle = 0 deg, mass = 1 g }
