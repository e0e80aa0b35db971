// Links that only a spring holds, and one that nothing does.
model faulty
ground O = (0 mm, 0 mm)
link a from C to D { length = 20 mm, angle = 30 deg, mass = 1 g }
link b from D to E { length = 20 mm, angle = 30 deg, mass = 1 g }
spring s between O and C { stiffness = 3 N/m }
link free from X to Y { length = 20 mm, angle = 30 deg, mass = 1 g }
