// A massless body inside a component, in two parts.
model faulty
component pusher() {
  slide head along (1, 0)
}
part one = pusher()
part two = pusher()
