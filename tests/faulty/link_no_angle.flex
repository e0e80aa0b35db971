// A link of which nothing says where it points.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B { length = 20 mm, mass = 1 g }
