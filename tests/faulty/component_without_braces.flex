model m
component bar(l: length)
slide s along (1, 0) { mass = 1 g }
