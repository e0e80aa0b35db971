// A contact on a link must say which way it presses.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B { length = 20 mm, angle = 30 deg, mass = 1 g }
slide stage along (1, 0) { mass = 50 g }
contact c between B and stage { preload = 1 N, friction = lugre(1 N/m, 1 N*s/m, 1 N*s/m, 0.2, 0.1, 1 mm/s) }
