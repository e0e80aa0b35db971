// A rigid truss on ground beside a mechanism.
model faulty
ground O = (0 mm, 0 mm), P = (60 mm, 0 mm)
link crank from O to A { length = 20 mm, angle = 60 deg, mass = 1 g }
link coupler from A to B { length = 60 mm, angle = 0 deg, mass = 1 g }
link rocker from P to B { length = 20 mm, angle = 60 deg, mass = 1 g }
ground U = (200 mm, 0 mm), V = (230 mm, 0 mm)
link left from U to C { length = 20 mm, angle = 45 deg, mass = 1 g }
link right from V to C { length = 20 mm, angle = 135 deg, mass = 1 g }
