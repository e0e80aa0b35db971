// A mass of zero on a body with a freedom of its own.
model unfit
ground O = (0 mm, 0 mm)
link a from O to A { length = 20 mm, angle = 0 deg, mass = 1 g }
link b from A to B { length = 20 mm, angle = 0 deg, mass = 0 g }
