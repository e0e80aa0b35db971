//! A driven arm whose tip presses on a slide: the normal force follows the approach and lifts off.
model pressing_arm

param l = 30 mm, m = 1 g, cx = 25 mm, cy = -2 mm
param k = 5 N*m/rad, c = 1e-4 N*m*s/rad
param ms = 40 g, ks = 2e3 N/m
param Fp = 15 N, kn = 2e5 N/m, cn = 3 N*s/m
param sigma0 = 5e5 N/m, sigma1 = 10 N*s/m, sigma2 = 0.5 N*s/m
param mu_s = 0.3, mu_c = 0.2, v_s = 1 mm/s
param amplitude = 0.2 N*m, f = 300 Hz

ground O = (0 mm, 0 mm)
link arm from O to T { length = l, angle = 60 deg exact, mass = m }
hinge at O { stiffness = k, damping = c }
point C on arm at (cx, cy)
slide stage along (0.6, -0.8) { mass = ms }
spring return between ground and stage { stiffness = ks }
torque on arm = amplitude * sin(2*pi*f*t)
contact tip between C and stage {
  normal = (-0.8, -0.6)
  preload = Fp
  normal_stiffness = kn
  normal_damping = cn
  friction = lugre(sigma0, sigma1, sigma2, mu_s, mu_c, v_s)
}
