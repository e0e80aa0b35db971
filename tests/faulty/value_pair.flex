// A pair where a value is wanted, and the reverse.
model faulty
param a = (1 mm, 2 mm)
ground O = 3 mm
gravity = -9.81 m/s^2
output y = a
