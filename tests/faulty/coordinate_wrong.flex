// What cannot be a coordinate.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B { length = 20 mm, angle = 30 deg, mass = 1 g }
coordinate crank.rate
coordinate crank
coordinate crnk.angle
