model m
component bar(l: length, load: mass) {
  link web from P to Q { length = l, angle = 0 deg, mass = load }
}
ground O = (0 mm, 0 mm)
part a = bar(l = 3 mm) at P = O
part b = bar(3 mm, 1 g, 2 g) at P = O
part c = bar(length = 3 mm, load = 1 g, load = 2 g) at R = O
