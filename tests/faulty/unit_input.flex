// An input that starts with another kind of quantity.
model faulty
input u: V = 3 A
output y = u
