// Branches of unlike kinds.
model faulty
slide stage along (1, 0) { mass = 50 g }
output y = if stage.x > 0 then 1 mm else 2 N
