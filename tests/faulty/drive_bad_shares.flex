// A rise that is no share of the period.
model faulty
param f = 20 Hz
drive x = sawtooth(1 mm, frequency = f, rise = 1.5)
drive z = triangle(1 mm, frequency = 0 Hz)
output y = x + z
