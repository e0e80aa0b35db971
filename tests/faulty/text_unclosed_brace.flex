// A brace that is never closed leaves the next items readable.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B {
  length = 20 mm
  angle = 30 deg

hinge at O { stifness = 3 N*m/rad }
