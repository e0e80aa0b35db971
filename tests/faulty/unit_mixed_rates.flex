// A frequency added to an angular rate.
model faulty
param f = 20 Hz, w = 3 rad/s
output y = f + w
