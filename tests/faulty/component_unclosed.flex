model m
slide s along (1, 0) { mass = 1 g }
component bar(l: length) {
  link web from P to Q { length = l, angle = 0 deg, mass = 1 g }
