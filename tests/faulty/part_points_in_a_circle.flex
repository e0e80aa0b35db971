model m
component tip {
  link web from P to Q { length = 1 mm, angle = 0 deg, mass = 1 g }
}
part a = tip() at P = b.P
part b = tip() at P = a.P
