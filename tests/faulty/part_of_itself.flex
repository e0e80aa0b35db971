model m
component nest(l: length) {
  part inner = nest(l) at P = P
  link web from P to Q { length = l, angle = 0 deg, mass = 1 g }
}
ground O = (0 mm, 0 mm)
part a = nest(l = 3 mm) at P = O
