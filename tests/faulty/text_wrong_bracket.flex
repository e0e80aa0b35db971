// A parenthesis closed by a brace.
model faulty
ground O = (0 mm, 0 mm}
