// A quantity without `param`.
model faulty
stiffness = 3 N/m
