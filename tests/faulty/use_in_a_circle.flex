model m
use "first.flex"
slide s along (1, 0) { mass = 1 g }
