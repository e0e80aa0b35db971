// A decimal point needs a digit after it.
model faulty
param a = 3. mm
output d = a
