// A quantity made of itself.
model faulty
let a = 2 * a
output d = a
