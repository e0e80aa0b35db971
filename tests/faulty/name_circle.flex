// Quantities made of each other.
model faulty
let a = 2 * b
let b = c + 1
let c = a / 3
output d = a
