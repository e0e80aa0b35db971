// A hinge inside a component whose thickness is zero in one part.
model unfit
component leaf(t: length) {
  link web from P to Q { length = 20 mm, angle = 0 deg, mass = 1 g }
  hinge at P { stiffness = circular_hinge(72 GPa, width = 5 mm, web = t, radius = 2 mm, formula = thin_web) }
}
param thick = 0.3 mm, thin = 0 mm
ground A = (0 mm, 0 mm), B = (0 mm, 30 mm)
part good = leaf(thick) at P = A
part bad = leaf(thin) at P = B
