// A length without its unit.
model faulty
ground O = (0, 3)
link crank from O to B { length = 20, angle = 30 deg }
