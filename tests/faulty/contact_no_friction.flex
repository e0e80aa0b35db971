// A contact without a friction law.
model faulty
slide stage along (1, 0) { mass = 50 g }
contact c between stage and ground { preload = 3 N }
contact d between stage and ground { preload = 3 N, friction = coulomb(0.2) }
