// Units that are not of the list.
model faulty
param a = 3 min
param b = 20 lbf
param c = 3 t
param d = 4 mmm
param g = 50 rpm
output x = a
output y = b + c + d + g
