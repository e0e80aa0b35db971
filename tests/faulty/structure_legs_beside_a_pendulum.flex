// A slide between two legs beside a pendulum: only the slide and its legs are named.
model faulty
ground O = (0 mm, 50 mm), A = (-30 mm, 0 mm), B = (30 mm, 0 mm)
link pendulum from O to T { length = 20 mm, angle = -90 deg, mass = 1 g }
slide stage along (0, 1) { at = 10 mm, mass = 1 g }
point S on stage at (0 mm, 0 mm)
link a from A to S { length = 40 mm, angle = 10 deg, mass = 1 g }
link b from B to S { length = 40 mm, angle = 170 deg, mass = 1 g }
