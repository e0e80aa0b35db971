model m
component bar(l: length, load: mass = 2 g) {
  link web from P to Q { length = l, angle = 0 deg, mass = load }
}
ground O = (0 mm, 0 mm)
part left = bar(l = 3 g) at P = O
