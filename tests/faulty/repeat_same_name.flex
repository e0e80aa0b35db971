model m
param i = 3 mm
repeat i from 1 to 2 {
  slide s along (1, 0) { mass = 1 g }
  repeat i from 1 to 2 { slide q[i] along (1, 0) { mass = 1 g } }
}
