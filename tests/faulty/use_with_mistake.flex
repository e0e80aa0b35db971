model m
use "faulty.flex"
ground O = (0 mm, 0 mm)
part a = bar(l = 3 mm) at P = O
