// LuGre without a preload needs a reference force.
model faulty
slide stage along (1, 0) { mass = 50 g }
contact c between stage and ground { normal = (0, 1), normal_stiffness = 1e6 N/m, friction = lugre(1 N/m, 1 N*s/m, 1 N*s/m, 0.2, 0.1, 1 mm/s) }
