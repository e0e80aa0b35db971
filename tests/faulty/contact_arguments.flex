// Friction with arguments missing, too many, misnamed or out of order.
model faulty
slide stage along (1, 0) { mass = 50 g }
contact c between stage and ground { preload = 3 N, friction = lugre(1 N/m, 1 N*s/m) }
contact d between stage and ground { preload = 3 N, friction = lugre(sigma0 = 1 N/m, 1 N*s/m) }
contact e between stage and ground { preload = 3 N, friction = lugre(sigma_0 = 1 N/m) }
