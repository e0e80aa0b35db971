// A slide without a direction.
model faulty
slide stage { mass = 50 g }
