// A truss inside a part.
model faulty
component tri(l: length) {
  link left from P to T { length = l, angle = 60 deg, mass = 1 g }
  link right from Q to T { length = l, angle = 120 deg, mass = 1 g }
}
ground O = (0 mm, 0 mm), R = (20 mm, 0 mm)
link a from O to A { length = 20 mm, angle = 0 deg, mass = 1 g }
part one = tri(20 mm) at P = O, Q = R
