// A guide whose direction is zero by its params.
model unfit
param u = 0, v = 0
slide s along (u, v) { mass = 1 g }
