//! Double-rocker flexure stick–slip actuator.
//!
//! A piezo stack pushes a four-bar of flexure hinges at `A`. The coupler's tip `C` presses on a
//! slider and carries it along by friction: slowly forward, sticking; quickly back, slipping.
//!
//! Sun et al., Micromachines 2023, 14, 1117; modelled by Nguyen & Nguyen, Machines 2025, 13, 787.
//!
//! Where the equations of the latter differ: its third bar points from `D` to `O2`, the rocker here
//! from `O2` to `D`, so its angle φ3 is 180° more; ω3 is the same. The contact's torque is by
//! virtual work, so both terms with `ln` have the factor ω2 that its equation (24) lacks. Its
//! equation (12) puts the third bar's centre of mass beyond `O2`; here it is on the bar.
model double_rocker

// ── Flexure mechanism ────────────────────────────────────────────────────────────────────────

param E  = 72 GPa                                                   "elastic modulus"
param b  = 3 mm                                                     "width, out of plane"
param h  = 3 mm                                                     "link height"
param e  = 1.5 mm                                                   "hinge web thickness"
param r  = 1 mm                                                     "hinge radius"
param l1 = 10.2 mm, l2 = 23.2 mm, l3 = 10 mm, l4 = 25 mm            "length of a link"
param m1 = 0.2568 g, m2 = 0.5877 g, m3 = 0.2529 g                   "mass of a link"
param beta1 = 0 deg, beta2 = 0 deg, beta3 = 0 deg                   "direction of a centre of mass off its link's line"
let   k  = circular_hinge(E, width = b, web = e, radius = r, formula = thin_web)  "stiffness of a hinge"

ground O1 = (0 mm, 0 mm)
ground O2 = (l4, 0 mm)

link crank from O1 to B {
  length  = l1
  angle   = 80 deg exact             // the design's own angle; the others close the loop
  mass    = m1
  com     = polar(l1/2, beta1)
  section = rect(b, h)
  symbol  = φ1
}
link coupler from B to D {
  length  = l2
  angle   = 0 deg                    // a guess: it picks the branch
  mass    = m2
  com     = polar(l2/2, beta2)
  section = rect(b, h)
  symbol  = φ2
}
link rocker from O2 to D {
  length  = l3
  angle   = 90 deg                   // a guess
  mass    = m3
  com     = polar(l3/2, beta3)
  section = rect(b, h)
  symbol  = φ3
}

hinge at O1 { stiffness = k }
hinge at B  { stiffness = k }
hinge at D  { stiffness = k }
hinge at O2 { stiffness = k }

coordinate crank.angle
gravity = (0, -9.81 m/s^2)

// ── Piezo stack ──────────────────────────────────────────────────────────────────────────────

param mp = 15 g                                                     "mass of the stack"
param kp = 3.6e6 N/m                                                "stiffness of the stack"
param cp = 0.294 N*s/m                                              "damping of the stack"
param ku = 3e7 N/m                                                  "stiffness of the joint between stack and crank"
param la = 5.1 mm                                                   "A from O1"
param f  = 1 kHz                                                    "drive frequency"
param stroke = 20 um                                                "drive stroke"
param rise   = 0.95                                                 "share of the period in which the stack extends"

point A on crank at (la, 0 mm)       // in the link's frame: from its first end, along the link

drive xp = sawtooth(stroke, frequency = f, rise = rise)

slide  stack   along (-1, 0) { mass = mp }
spring ceramic between ground and stack { stiffness = kp, damping = cp, expansion = xp }
spring joint   between stack and A along (-1, 0) { stiffness = ku }

// ── Slider and contact ───────────────────────────────────────────────────────────────────────

param ln = 5 mm                                                     "C from B"
param ms = 50 g                                                     "mass of the slider"
param Fp = 20 N                                                     "preload"
param sigma0 = 5e6 N/m                                              "bristle stiffness"
param sigma1 = 5 N*s/m                                              "bristle damping"
param sigma2 = 0.5 N*s/m                                            "viscous friction"
param mu_s = 0.3                                                    "coefficient of static friction"
param mu_c = 0.2                                                    "coefficient of sliding friction"
param v_s  = 1 mm/s                                                 "Stribeck velocity"

point C on coupler at (ln, 0 mm)

slide stage along (-1, 0) { mass = ms }

contact tip between C and stage {
  normal   = (0, -1)                 // on C
  preload  = Fp
  friction = lugre(sigma0, sigma1, sigma2, mu_s, mu_c, v_s)
}

// ── Results ──────────────────────────────────────────────────────────────────────────────────

output speed    = stage.v                                           "velocity of the slider"
output position = stage.x                                           "position of the slider"
output lag      = xp - stack.x                                      "stroke that the stack's stiffness takes up"
output friction = tip.friction                                      "friction force on the slider"

set table2 "tables 2 and 3 of the article" {
  sigma0 = 2e6 N/m, mu_s = 0.15, mu_c = 0.10
  ku = 3e6 N/m
  ms = 100 g
  ln = 0 mm
}
