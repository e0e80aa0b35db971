// A frequency where an angular rate is wanted, and the reverse.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B { length = 20 mm, angle = 30 deg, mass = 1 g }
initial crank.rate = 20 Hz
drive x = sawtooth(1 mm, frequency = 6 rad/s, rise = 0.9)
output y = x
