//! A pendulum on a flexure hinge: one pivoted bar that swings under gravity against the stiffness
//! and damping of its hinge.
model pendulum

param length  = 200 mm              "length of the bar"
param width   = 20 mm               "width of the bar, out of plane"
param height  = 5 mm                "height of the bar, in the plane of motion"
param density = 2700 kg/m^3         "density of the bar"
param k = 20 N*mm/rad               "stiffness of the hinge"
param c = 0.05 N*mm*s/rad           "damping of the hinge"

ground pivot = (0 mm, 0 mm)

link bar from pivot to tip {
  length  = length
  angle   = -30 deg exact
  section = rect(width, height)
  density = density
  symbol  = φ
}

hinge at pivot { stiffness = k, damping = c, rest = -90 deg }

gravity = (0, -9.81 m/s^2)

output swing = bar.angle + 90 deg   "angle from hanging straight down"
output x = tip.x                    "horizontal position of the tip"
output y = tip.y                    "vertical position of the tip"
