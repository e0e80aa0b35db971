// A link that nothing joins to ground.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B { length = 20 mm, angle = 30 deg, mass = 1 g }
link rod from C to D { length = 20 mm, angle = 30 deg, mass = 1 g }
