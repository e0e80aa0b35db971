// A body that can move, but has no mass.
model faulty
slide stage along (1, 0)
spring s between ground and stage { stiffness = 3 N/m }
