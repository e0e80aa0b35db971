// A link without length.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B { angle = 30 deg, mass = 1 g }
