// A comparison of unlike quantities.
model faulty
slide stage along (1, 0) { mass = 50 g }
stop when stage.x > 3 m/s
