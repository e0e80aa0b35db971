// A link that only a spring holds.
model faulty
ground O = (0 mm, 0 mm)
link a from C to D { length = 20 mm, angle = 30 deg, mass = 1 g }
spring s between O and C { stiffness = 3 N/m }
