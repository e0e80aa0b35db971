// A spring with neither stiffness nor damping.
model faulty
slide stage along (1, 0) { mass = 50 g }
spring s between ground and stage
