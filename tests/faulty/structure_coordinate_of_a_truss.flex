// A coordinate of links that cannot move.
model faulty
ground O = (0 mm, 0 mm), U = (20 mm, 0 mm), V = (50 mm, 0 mm)
link pendulum from O to T { length = 20 mm, angle = -90 deg, mass = 1 g }
link left from U to C { length = 20 mm, angle = 45 deg, mass = 1 g }
link right from V to C { length = 20 mm, angle = 135 deg, mass = 1 g }
coordinate left.angle
