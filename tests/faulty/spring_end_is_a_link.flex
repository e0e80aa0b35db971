// A spring that ends on a link instead of a point of it.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B { length = 20 mm, angle = 30 deg, mass = 1 g }
slide stage along (1, 0) { mass = 50 g }
spring s between crank and stage { stiffness = 3 N/m }
