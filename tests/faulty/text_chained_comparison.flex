// Comparisons do not chain.
model faulty
slide stage along (1, 0) { mass = 50 g }
stop when 0 mm < stage.x < 1 mm
