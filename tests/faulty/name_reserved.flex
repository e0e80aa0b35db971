// Words that cannot be names.
model faulty
param t = 3 s
param sin = 2
link energy from O to B { length = 1 mm, angle = 0 deg }
ground O = (0 mm, 0 mm)
