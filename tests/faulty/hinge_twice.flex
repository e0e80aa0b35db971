// Two hinges at one pin.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B { length = 20 mm, angle = 30 deg, mass = 1 g }
hinge at O { stiffness = 3 N*m/rad }
hinge at O { stiffness = 3 N*m/rad }
