// Entries that a link does not have, or has twice.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B { lenght = 20 mm, angle = 3 deg, color = 3, angle = 4 deg, mass = 1 g exact }
