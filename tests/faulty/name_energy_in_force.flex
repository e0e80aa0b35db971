// A force cannot depend on the energy.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B { length = 20 mm, angle = 30 deg, mass = 1 g }
force on B = (energy.total / (1 m), 0 N)
output d = energy.kinetc
