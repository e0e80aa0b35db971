// Several mistakes are reported from one file.
model faulty
param a = 3 parsec
param b = 
ground O = (0 mm 0 mm)
link crank from O to B { lenght = 20 mm, angle = 30 deg }
hinge at B { stiffness = kk }
