// An unknown name that resembles nothing.
model faulty
param a = 3 N/m
let double = 2 * elasticity * a
output d = double
