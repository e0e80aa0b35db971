// A keyword with a typing error.
model faulty
lnik crank from O to B { length = 20 mm, angle = 0 deg }
ground O = (0 mm, 0 mm)
