// A division by zero.
model faulty
param a = 3 / 0
let b = 2 / (1 - 1)
let c = 0^(-1)
let d = sqrt(-2)
output y = a + b + c + d
