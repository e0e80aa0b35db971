model m
const N = 2.5
const M = K + 1
const L = 3, L = 4
param L = 3 mm
slide s along (1, 0) { mass = 1 g }
