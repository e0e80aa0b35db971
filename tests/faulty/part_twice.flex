model m
component bar(l: length) {
  link web from P to Q { length = l, angle = 0 deg, mass = 1 g }
}
component bar {
  link web from P to Q { length = 1 mm, angle = 0 deg, mass = 1 g }
}
ground O = (0 mm, 0 mm)
part a = bar(l = 3 mm) at P = O
part a = bar(l = 4 mm) at P = O
slide a along (1, 0) { mass = 1 g }
