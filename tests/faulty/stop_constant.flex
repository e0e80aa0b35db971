// A condition that never changes.
model faulty
slide stage along (1, 0) { mass = 50 g }
stop when 1 > 2
