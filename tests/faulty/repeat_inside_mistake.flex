model m
repeat i from 1 to 40 {
  slide s[i] along (1, 0) { mass = i * 1 mm }
}
