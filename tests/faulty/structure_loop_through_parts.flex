// A third leg of another length, each leg a part.
model faulty
component leg(l: length) {
  link web from P to Q { length = l, angle = 80 deg, mass = 1 g }
}
param l = 20 mm, w = 30 mm
ground A = (0 mm, 0 mm), B = (w, 0 mm), C = (w / 2, 0 mm)
link stage from D to E { length = w, angle = 0 deg, mass = 1 g }
point F on stage at (w / 2, 0 mm)
part left = leg(l) at P = A, Q = D
part right = leg(l) at P = B, Q = E
part middle = leg(25 mm) at P = C, Q = F
