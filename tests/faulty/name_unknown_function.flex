// Functions that do not exist.
model faulty
param a = 3
output b = ln(a)
output c = sinus(a)
output d = a(3)
