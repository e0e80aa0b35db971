// Numbers beyond those of doubles.
model faulty
param a = 1e999 mm
param b = 1e308 km
param c = 1e-400
let d = 10^400
output y = a + b
output z = c + d
