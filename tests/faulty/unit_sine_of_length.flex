// A sine of a length.
model faulty
param a = 3 mm
output y = sin(a)
