// A force that depends on itself.
model faulty
slide stage along (1, 0) { mass = 1 g }
spring s between ground and stage { stiffness = 3 N/m, expansion = s.force / (3 N/m) }
