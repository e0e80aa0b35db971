//! Stick–slip of a mass that is pulled over a rough surface through a soft spring.
//!
//! The standard example of the LuGre friction law: C. Canudas de Wit, H. Olsson, K. J. Åström,
//! P. Lischinsky, A new model for control of systems with friction, IEEE Transactions on
//! Automatic Control 40 (1995).
model lugre_mass

param m  = 1 kg                           "mass"
param k  = 2 N/m                          "spring stiffness"
param pull = 0.1 m/s                      "velocity of the spring's far end"
param FN = 1 N                            "normal force"
param sigma0 = 1e5 N/m                    "bristle stiffness"
param sigma1 = sqrt(1e5 N/m * 1 kg)       "bristle damping"
param sigma2 = 0.4 N*s/m                  "viscous friction"
param mu_s = 1.5                          "static friction over normal force"
param mu_c = 1                            "sliding friction over normal force"
param v_s  = 1 mm/s                       "Stribeck velocity"

drive end = ramp(pull)

slide block along (1, 0) { mass = m }

spring rope between ground and block { stiffness = k, expansion = end }

contact surface between block and ground {
  preload  = FN
  friction = lugre(sigma0, sigma1, sigma2, mu_s, mu_c, v_s)
}

output position = block.x            "position of the mass"
output velocity = block.v            "velocity of the mass"
output friction = surface.friction   "friction force on the ground"
output deflection = surface.z        "bristle deflection"
