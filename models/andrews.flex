//! Andrews' squeezing mechanism: seven bodies, three loops, one degree of freedom, driven by a
//! constant torque against a stiff spring.
//!
//! A published multibody benchmark (IVP test set; IFToMM A03). Angles are named as published; there
//! the coupler and the links at E are measured against the link they are pinned to.
model andrews

param rr = 7 mm, ra = 0.92 mm, m1 = 0.04325 kg, I1 = 2.194e-6 kg*m^2    "crank"
param d = 28 mm, da = 11.5 mm, m2 = 0.00365 kg, I2 = 4.41e-7 kg*m^2     "coupler"
param ss = 35 mm, sa = 18.74 mm, sb = 10.43 mm, m3 = 0.02373 kg, I3 = 5.255e-6 kg*m^2   "lever"
param sc = 18 mm, sd = 20 mm                                            "D on the lever"
param e = 20 mm, ea = 14.21 mm, m4 = 0.00706 kg, I4 = 5.667e-7 kg*m^2   "upper connecting link"
param zt = 40 mm, ta = 23.08 mm, tb = 9.16 mm, m5 = 0.0705 kg, I5 = 1.169e-5 kg*m^2     "upper arm"
param zf = 20 mm, fa = 14.21 mm, m6 = 0.00706 kg, I6 = 5.667e-7 kg*m^2  "lower connecting link"
param u = 40 mm, ua = 12.28 mm, ub = 4.49 mm, m7 = 0.05498 kg, I7 = 1.912e-5 kg*m^2     "lower arm"
param xa = -69.34 mm, ya = -2.27 mm, xb = -36.35 mm, yb = 32.73 mm, xc = 14 mm, yc = 72 mm   "fixed points"
param c0 = 4530 N/m          "stiffness of the spring"
param l0 = 77.85 mm          "its free length"
param mom = 0.033 N*m        "torque on the crank"
param beta0 = -0.0617138900142764496  "crank at the start"

ground O = (0 mm, 0 mm)
ground A = (xa, ya)
ground B = (xb, yb)
ground C = (xc, yc)

link crank      from O to F { length = rr, angle = beta0 exact, mass = m1, com = (ra, 0 mm), inertia = I1, symbol = β }
link coupler    from E to F { length = d,  angle = -0.06, mass = m2, com = (d - da, 0 mm), inertia = I2, symbol = φ2 }
link lever      from B to E { length = ss, angle = -1.12, mass = m3, com = (sa, sb), inertia = I3, symbol = φ3 }
link upper      from G to E { length = e,  angle = -0.86, mass = m4, com = (e - ea, 0 mm), inertia = I4, symbol = φ4 }
link upper_arm  from A to G { length = zt, angle = 0.49,  mass = m5, com = (ta, tb), inertia = I5, symbol = δ }
link lower      from H to E { length = zf, angle = 1.01,  mass = m6, com = (zf - fa, 0 mm), inertia = I6, symbol = φ6 }
link lower_arm  from A to H { length = u,  angle = -0.34, mass = m7, com = (ua, ub), inertia = I7, symbol = φ7 }

point D on lever at (sc, sd)

spring pull between C and D { stiffness = c0, length = l0 }
torque on crank = mom

coordinate crank.angle

output beta    = crank.angle                              "angle of the crank"
output theta   = coupler.angle - crank.angle              "of the coupler, from the crank"
output gamma   = lever.angle + 90 deg                     "of the lever"
output phi     = upper.angle - upper_arm.angle + 90 deg   "of the upper connecting link, from its arm"
output delta   = upper_arm.angle                          "of the upper arm"
output Omega   = lower.angle - lower_arm.angle - 90 deg   "of the lower connecting link, from its arm"
output epsilon = lower_arm.angle + 90 deg                 "of the lower arm"
output dbeta    = crank.rate
output dtheta   = coupler.rate - crank.rate
output dgamma   = lever.rate
output dphi     = upper.rate - upper_arm.rate
output ddelta   = upper_arm.rate
output dOmega   = lower.rate - lower_arm.rate
output depsilon = lower_arm.rate
