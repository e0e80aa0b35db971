// A name for two things.
model faulty
param stage = 3 mm
slide stage along (1, 0) { mass = 50 g }
