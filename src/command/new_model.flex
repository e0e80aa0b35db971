//! A stage on two flexure legs, pushed by a piezo stack.
//! Change it into yours; `flexure check` says what it describes, `flexure derive` its equations.
model my_stage

// Quantities that you may want to change or sweep, each with its unit.
// From the command line: --set leg=25mm
param leg       = 30 mm          "length of the legs"
param width     = 40 mm          "length of the platform"
param m_leg     = 2 g            "mass of each leg"
param m_stage   = 40 g           "mass of the platform"
param E         = 72 GPa         "elastic modulus"
param b         = 8 mm           "width of the hinges, out of plane"
param e         = 0.5 mm         "web of the hinges, at the thinnest"
param r         = 2 mm           "radius of the hinges"
param ka        = 20e6 N/m       "stiffness of the stack"
param ca        = 200 N*s/m      "damping of the stack"
param stroke    = 15 um          "stroke of the stack"
param frequency = 200 Hz         "frequency of the drive"

// Quantities that follow from them.
let k = circular_hinge(E, width = b, web = e, radius = r, formula = thin_web)

// Points that stand still.
ground G1 = (0 mm, 0 mm)
ground G2 = (width, 0 mm)

// Links between named points. Links that name the same point meet in a pin there.
// Angles count from the x axis; one that is not exact is a guess, and closing the loop finds it.
link left     from G1 to P1 { length = leg,   angle = 90 deg exact, mass = m_leg }
link platform from P1 to P2 { length = width, angle = 0 deg,        mass = m_stage }
link right    from G2 to P2 { length = leg,   angle = 90 deg,       mass = m_leg }

// The pins are flexure hinges: springs against turning.
hinge at G1 { stiffness = k }
hinge at P1 { stiffness = k }
hinge at P2 { stiffness = k }
hinge at G2 { stiffness = k }

// The coordinate in which the equations of motion are written.
coordinate left.angle

// What moves it: a stack between ground and the end of the platform, which acts along x.
drive extension = trapezoid(stroke, frequency = frequency, rise = 0.3, hold = 0.2, fall = 0.3)
spring stack between ground and P1 along (1, 0) { stiffness = ka, damping = ca, expansion = extension }

// What to look at: a point of a body, in its frame from its first end, and measures of anything.
point M on platform at (width/2, 0 mm)
output drive    = extension              "extension of the stack alone"
output position = platform.M.x - width/2 "travel of the platform"
output speed    = platform.M.vx          "velocity of the platform"
output force    = stack.force            "force of the stack"
