// A brace that stops a four-bar; what hangs on it still moves.
model faulty
ground O = (0 mm, 0 mm), P = (60 mm, 0 mm)
link crank from O to A { length = 20 mm, angle = 60 deg, mass = 1 g }
link coupler from A to B { length = 60 mm, angle = 0 deg, mass = 1 g }
point M on coupler at (30 mm, 0 mm)
link rocker from P to B { length = 20 mm, angle = 60 deg, mass = 1 g }
link brace from O to M { length = 40 mm, angle = 30 deg, mass = 1 g }
link weight from M to W { length = 40 mm, angle = -90 deg, mass = 1 g }
