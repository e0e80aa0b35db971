// A direction without length.
model faulty
slide stage along (0, 0) { mass = 50 g }
