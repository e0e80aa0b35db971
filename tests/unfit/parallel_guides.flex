// A link on two parallel guides, led by its angle.
model unfit
slide one along (1, 0) { mass = 1 g }
point S on one at (0 mm, 0 mm)
slide two along (1, 0) { mass = 1 g }
point T on two at (0 mm, 5 mm)
link rod from S to T { length = 10 mm, angle = 60 deg, mass = 1 g }
coordinate rod.angle
