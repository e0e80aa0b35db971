// A body has no such quantity.
model faulty
slide stage along (1, 0) { mass = 50 g }
output a = stage.speed
output b = stage.y
output c = stag.v
