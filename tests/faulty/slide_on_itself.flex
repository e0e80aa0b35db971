// Slides that carry themselves or each other.
model faulty
slide a on b along (1, 0) { mass = 50 g }
slide b on a along (0, 1) { mass = 50 g }
