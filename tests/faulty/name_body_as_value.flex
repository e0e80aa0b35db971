// A body is no value.
model faulty
slide stage along (1, 0) { mass = 50 g }
output d = 2 * stage
