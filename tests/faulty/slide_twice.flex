// A clause given twice.
model faulty
slide s along (1, 0) along (0, 1) { mass = 50 g }
