// Measured quantities are never equal.
model faulty
slide stage along (1, 0) { mass = 50 g }
stop when stage.x == 1 mm
