model m
component bar(l = 3 mm) {
  link web from P to Q { length = l, angle = 0 deg, mass = 1 g }
}
slide s along (1, 0) { mass = 1 g }
