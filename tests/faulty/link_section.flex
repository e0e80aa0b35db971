// No section.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B { length = 20 mm, angle = 3 deg, mass = 1 g, section = 3 mm }
