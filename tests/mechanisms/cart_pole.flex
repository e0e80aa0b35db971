//! A pivoted link on a slide on ground.
model cart_pole

param mc = 20 g, mp = 5 g, l = 50 mm, rp = 20 mm, bp = 15 deg, ip = 1e-6 kg*m^2
param ux = 4 mm, uy = 6 mm
param k = 0.05 N*m/rad, c = 1e-5 N*m*s/rad, kc = 500 N/m, cc = 0.3 N*s/m
param mq = 1 g

slide cart along (0.96, 0.28) { mass = mc }
point P on cart at (ux, uy)
link pole from P to T { length = l, angle = 70 deg, mass = mp, com = polar(rp, bp), inertia = ip, mass at T = mq }
hinge at P { stiffness = k, damping = c }
spring anchor between ground and cart { stiffness = kc, damping = cc }
gravity = (0, -9.81 m/s^2)
