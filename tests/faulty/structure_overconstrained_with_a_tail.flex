// A third leg that stops a four-bar; what hangs on it still moves.
model faulty
ground O = (0 mm, 0 mm), P = (60 mm, 0 mm)
link crank from O to A { length = 20 mm, angle = 60 deg, mass = 1 g }
link coupler from A to B { length = 60 mm, angle = 0 deg, mass = 1 g }
point M on coupler at (30 mm, 5 mm)
link rocker from P to B { length = 22 mm, angle = 60 deg, mass = 1 g }
ground Q = (30 mm, 0 mm)
link extra from Q to M { length = 25 mm, angle = 60 deg, mass = 1 g }
link tail from M to T { length = 25 mm, angle = 60 deg, mass = 1 g }
