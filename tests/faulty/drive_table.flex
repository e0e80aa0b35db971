// A table that cannot be read, or is none.
model faulty
drive x = table("missing.csv")
drive z = table("backwards.csv", value = 1 mm)
drive w = table("words.csv")
output y = x
output y2 = z
output y3 = w
