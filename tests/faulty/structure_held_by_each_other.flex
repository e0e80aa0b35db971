// Two links that a spring holds together, with nothing that leads to ground.
model faulty
ground O = (0 mm, 0 mm)
link arm from O to A { length = 20 mm, angle = 30 deg, mass = 1 g }
link a from C to D { length = 20 mm, angle = 30 deg, mass = 1 g }
link b from E to F { length = 20 mm, angle = 30 deg, mass = 1 g }
spring s between D and E { stiffness = 3 N/m }
