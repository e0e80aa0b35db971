model m
component bar(l: length) {
  link web from P to Q { length = l, angle = 0 deg, mass = 1 g }
}
ground O = (0 mm, 0 mm)
slide base along (1, 0) { mass = 1 g }
part left = bar(l = 3 mm) at P = base.A
part right = bar(l = 3 mm) at P = left.web.C
