// A spring has no mass, a stack has.
model faulty
slide stage along (1, 0) { mass = 50 g }
spring s between ground and stage { stiffness = 3 N/m, mass = 3 g }
