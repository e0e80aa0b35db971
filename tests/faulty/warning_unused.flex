// A param that nothing uses is a warning.
model faulty
param a = 3 mm
slide stage along (1, 0) { mass = 50 g }
