model m
const N = 200
repeat i from 1 to N {
  repeat j from 1 to N {
    slide s[i][j] along (1, 0) { mass = 1 g }
  }
}
