// Powers that have no dimension.
model faulty
param a = 3 mm, n = 2
let b = a^n
let c = a^0.123
let d = a^(1 mm)
output y = b + c + d
