// Both ends drawn at one place.
model faulty
ground O = (3 mm, 4 mm)
point B = (3 mm, 4 mm)
link crank from O to B { mass = 1 g }
