// Words where a value is wanted.
model faulty
param a = "three"
output y = a
