// A contact of which neither side is a slide.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B { length = 20 mm, angle = 30 deg, mass = 1 g }
link rod from P to C { length = 20 mm, angle = 30 deg, mass = 1 g }
ground P = (0 mm, 50 mm)
contact c between B and C { preload = 1 N, normal = (0, 1), friction = lugre(1 N/m, 1 N*s/m, 1 N*s/m, 0.2, 0.1, 1 mm/s) }
