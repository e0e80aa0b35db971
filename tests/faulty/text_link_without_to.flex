// A link with one end.
model faulty
ground O = (0 mm, 0 mm)
link crank from O { length = 20 mm }
