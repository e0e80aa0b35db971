// Gravity twice.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B { length = 20 mm, angle = 30 deg, mass = 1 g }
gravity = (0, -9.81 m/s^2)
gravity = (0, -1.62 m/s^2)
