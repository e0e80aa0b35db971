// A point of ground as a coordinate.
model faulty
ground O = (0 mm, 0 mm)
link arm from O to A { length = 20 mm, angle = 30 deg, mass = 1 g }
coordinate O.x, arm.A.y
