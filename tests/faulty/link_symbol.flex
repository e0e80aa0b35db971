// A symbol that is taken.
model faulty
param φ1 = 3
ground O = (0 mm, 0 mm)
link crank from O to B { length = 20 mm, angle = 3 deg, mass = 1 g, symbol = φ1 }
output y = φ1
