// A hinge where no bodies meet.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B { length = 20 mm, angle = 30 deg, mass = 1 g }
hinge at B { stiffness = 3 N*m/rad }
hinge at C { stiffness = 3 N*m/rad }
