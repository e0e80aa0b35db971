// Two models in a file.
model faulty
model second
