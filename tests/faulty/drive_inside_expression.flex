// A waveform inside an expression.
model faulty
drive x = 2 * sine(1 mm, frequency = 20 Hz)
output y = x
