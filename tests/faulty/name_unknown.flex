// An unknown name, with a suggestion.
model faulty
param stiffness = 3 N/m
let double = 2 * stifness
output d = double
