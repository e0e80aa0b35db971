model m
param E = 3 GPa
component bar(l: length) {
  link web from P to Q { length = l, angle = 0 deg, mass = 2 mm }
  hinge at P { stiffness = E * l^3 }
}
component pair {
  part first = bar(l = 3 mm) at P = Start
  part second = bar(l = 4 mm) at P = first.Q
}
ground O = (0 mm, 0 mm)
part left = pair() at Start = O
part right = pair() at Start = left.second.Q
output y = E * 1 m
