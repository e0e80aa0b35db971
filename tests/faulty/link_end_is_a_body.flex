// A link that ends on a body instead of a point of it.
model faulty
slide stage along (1, 0) { mass = 50 g }
ground O = (0 mm, 0 mm)
link rod from O to stage { length = 20 mm, angle = 3 deg, mass = 1 g }
