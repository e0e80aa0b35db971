// A force on ground, and a torque against itself.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B { length = 20 mm, angle = 30 deg, mass = 1 g }
force on ground = (0, 3 N)
torque on ground = 3 N*m
force on B = (3 N, 3 N*m)
