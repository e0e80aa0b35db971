// Two values with nothing between them.
model faulty
param a = 3 mm, b = 2 mm
let c = a b
output d = c
