// A param made of another.
model faulty
param a = 3 mm
param b = 2 * a
output d = a + b
