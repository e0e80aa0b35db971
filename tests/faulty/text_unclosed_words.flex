// Words without their closing quotation mark.
model faulty
param a = 3 mm "length of a thing
output c = a
