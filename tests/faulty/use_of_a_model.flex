model m
use "model.flex"
slide s along (1, 0) { mass = 1 g }
