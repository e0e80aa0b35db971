// The file does not say what it models.
param a = 3 mm
output d = a
