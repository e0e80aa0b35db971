// A spring to no place on ground.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B { length = 20 mm, angle = 30 deg, mass = 1 g }
spring s between ground and B { stiffness = 3 N/m }
