// A set that gives values to what is no param.
model faulty
param stiff = 3 N/m
let double = 2 * stiff
set other { stif = 4 N/m, double = 3 N/m, stiff = 3 mm }
output d = double
