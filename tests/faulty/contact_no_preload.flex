// A contact that nothing presses together, without friction.
model faulty
slide stage along (1, 0) { mass = 50 g }
contact c between stage and ground
