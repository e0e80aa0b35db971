// A slider-crank at dead centre, driven by the slide.
model unfit
param r = 10 mm, l = 30 mm
ground O = (0 mm, 0 mm)
slide piston along (1, 0) { at = r + l, mass = 1 g }
point S on piston at (0 mm, 0 mm)
link crank from O to B { length = r, angle = 0 deg, mass = 1 g }
link rod from B to S { length = l, angle = 0 deg, mass = 1 g }
coordinate piston.x
