// A component that is never used, with a mistake in it.
model faulty
component bar(l: length) {
  link web from P to Q { length = ll, angle = 0 deg, mass = 1 mm }
}
ground O = (0 mm, 0 mm)
link a from O to A { length = 20 mm, angle = 0 deg, mass = 1 g }
