// A model without a body.
model faulty
param a = 3 mm
output y = a
