// A link from a point to itself.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to O { length = 20 mm, angle = 3 deg }
