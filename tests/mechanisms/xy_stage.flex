//! A slide on a slide, with friction between them and a spring across.
model xy_stage

param mx = 60 g, my = 25 g, ax = 3 mm, ay = 2 mm, free = 12 mm
param kx = 2e4 N/m, cx = 2 N*s/m, ky = 8e3 N/m, cy = 1 N*s/m, kd = 3e3 N/m, cd = 0.4 N*s/m
param sigma0 = 2e5 N/m, sigma1 = 20 N*s/m, sigma2 = 0.5 N*s/m
param mu_s = 0.3, mu_c = 0.2, v_s = 1 mm/s, Fp = 5 N
param push = 3 N, f = 100 Hz

ground G = (20 mm, 10 mm)
slide base along (1, 0) { mass = mx }
slide plate on base along (0.6, 0.8) { mass = my }
point A on plate at (ax, ay)

spring first between ground and base { stiffness = kx, damping = cx }
spring second between base and plate { stiffness = ky, damping = cy }
spring across between G and A { stiffness = kd, damping = cd, length = free }
contact rub between base and plate {
  preload = Fp
  friction = lugre(sigma0, sigma1, sigma2, mu_s, mu_c, v_s)
}
force on A = (push * cos(2*pi*f*t), push * sin(2*pi*f*t))
gravity = (0, -9.81 m/s^2)
