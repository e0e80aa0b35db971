// A spring between two points of one body.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B { length = 20 mm, angle = 30 deg, mass = 1 g }
point A on crank at (3 mm, 0 mm)
spring s between A and B { stiffness = 3 N/m }
