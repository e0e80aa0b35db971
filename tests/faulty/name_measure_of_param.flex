// A param has no quantities of its own.
model faulty
param a = 3 mm
output d = a.x
