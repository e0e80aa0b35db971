// Two outputs of one name.
model faulty
slide stage along (1, 0) { mass = 50 g }
output a = stage.v
output a = stage.x
