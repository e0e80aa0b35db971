// A sum of unlike quantities.
model faulty
param a = 3 mm, b = 2 N
let c = 1 + a/a - b
let d = a + a + 3
output x = c + d
