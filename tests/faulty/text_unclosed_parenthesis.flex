// A parenthesis that is never closed.
model faulty
param a = (3 mm + 2 mm
param b = 2 mm
output c = a + b
