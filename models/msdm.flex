//! Mass–spring–damper model of the double-rocker actuator: the baseline of the article.
//!
//! The flexure mechanism is one equivalent mass on one equivalent spring and damper between the
//! piezo stack and the contact. Nguyen & Nguyen, Machines 2025, 13, 787, equations 25 and 26.
model msdm

param mp = 15 g               "mass of the stack"
param kp = 3.6e6 N/m          "stiffness of the stack"
param cp = 0.294 N*s/m        "damping of the stack"
param me = 0.589 g            "equivalent mass of the mechanism"
param ke = 2.88e6 N/m         "equivalent stiffness of the mechanism"
param ce = 218 N*s/m          "equivalent damping of the mechanism"
param ms = 50 g               "mass of the slider"
param Fp = 20 N               "preload"
param sigma0 = 5e6 N/m        "bristle stiffness"
param sigma1 = 5 N*s/m        "bristle damping"
param sigma2 = 0.5 N*s/m      "viscous friction"
param mu_s = 0.3              "coefficient of static friction"
param mu_c = 0.2              "coefficient of sliding friction"
param v_s  = 1 mm/s           "Stribeck velocity"
param f = 1 kHz               "drive frequency"
param stroke = 20 um          "drive stroke"
param rise = 0.95             "share of the period in which the stack extends"

drive xp = sawtooth(stroke, frequency = f, rise = rise)

slide stack   along (1, 0) { mass = mp }
slide flexure along (1, 0) { mass = me }
slide stage   along (1, 0) { mass = ms }

spring ceramic   between ground and stack { stiffness = kp, damping = cp, expansion = xp }
spring mechanism between stack and flexure { stiffness = ke, damping = ce }

contact tip between flexure and stage {
  preload  = Fp
  friction = lugre(sigma0, sigma1, sigma2, mu_s, mu_c, v_s)
}

output speed    = stage.v         "velocity of the slider"
output position = stage.x         "position of the slider"
output friction = tip.friction    "friction force on the slider"
