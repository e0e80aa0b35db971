// A density without a section, and beside a mass.
model faulty
ground O = (0 mm, 0 mm)
link crank from O to B { length = 20 mm, angle = 3 deg, density = 2700 kg/m^3 }
link rod from B to C { length = 20 mm, angle = 3 deg, density = 2700 kg/m^3, mass = 3 g, section = rect(1 mm, 2 mm) }
