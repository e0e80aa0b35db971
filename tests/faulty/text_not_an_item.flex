// A line that starts with a number.
model faulty
3 mm
