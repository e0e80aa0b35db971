model m
component bar(l: longueur) {
  param m = 3 g
  gravity = (0, -9.81 m/s^2)
  link web from P to Q { length = l, angle = 0 deg, mass = 1 g }
}
ground O = (0 mm, 0 mm)
part a = bar(l = 3 mm) at P = O
