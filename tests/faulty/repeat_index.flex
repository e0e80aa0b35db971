model m
repeat i from 0 to 2 {
  ground G[i-1] = (i * 1 mm, 0 mm)
  slide s[k] along (1, 0) { mass = 1 g }
}
