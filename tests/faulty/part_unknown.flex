model m
component bar(l: length) {
  link web from P to Q { length = l, angle = 0 deg, mass = 2 g }
}
ground O = (0 mm, 0 mm)
part left = bra(l = 3 mm) at P = O
