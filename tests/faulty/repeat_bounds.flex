model m
param n = 3
repeat i from 1 to n {
  slide s[i] along (1, 0) { mass = 1 g }
}
repeat j from 1 to 2.5 {
  slide q[j] along (1, 0) { mass = 1 g }
}
