// A condition where a value is wanted, and the reverse.
model faulty
slide stage along (1, 0) { mass = 50 g }
output y = stage.x > 1 mm
stop when stage.x
output z = if stage.x then 1 else 2
