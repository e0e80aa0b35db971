// A bracket that closes nothing.
model faulty
param a = 3 mm }
output c = a
