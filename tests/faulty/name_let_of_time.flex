// A `let` cannot change with time.
model faulty
slide stage along (1, 0) { mass = 50 g }
let a = 2 * t
let b = stage.v
output d = a
output c = b
