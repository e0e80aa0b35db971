// Two links of unequal lengths that share both ends.
model faulty
ground O = (0 mm, 0 mm)
link b from O to A { length = 20 mm, angle = 0 deg, mass = 1 g }
link a from A to B { length = 20 mm, angle = 0 deg, mass = 1 g }
link c from A to B { length = 21 mm, angle = 0 deg, mass = 1 g }
