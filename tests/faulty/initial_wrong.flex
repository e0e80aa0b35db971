// Initial values of the wrong kind, or twice.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B { length = 20 mm, angle = 30 deg, mass = 1 g }
slide stage along (1, 0) { mass = 50 g }
initial crank.rate = 3 m/s
initial stage.v = 1 mm/s, stage.v = 2 mm/s
initial stage = 3 mm
