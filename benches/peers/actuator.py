"""The article's actuator in closed form, written once for all peers."""

import math

L1, L2, L3, L4 = 10.2e-3, 23.2e-3, 10e-3, 25e-3
M1, M2, M3 = 0.2568e-3, 0.5877e-3, 0.2529e-3
HEIGHT, G = 3e-3, 9.81
K = 2 * 72e9 * 3e-3 * 1.5e-3**2.5 / (9 * math.pi * math.sqrt(1e-3))
MP, KP, CP, KU, LA = 15e-3, 3.6e6, 0.294, 3e7, 5.1e-3
F, STROKE, RISE = 1e3, 20e-6, 0.95
LN, MS, FP = 5e-3, 50e-3, 20.0
SIGMA0, SIGMA1, SIGMA2, MU_S, MU_C, V_S = 5e6, 5.0, 0.5, 0.3, 0.2, 1e-3

PHI0 = math.radians(80)
START = [PHI0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
PARAMS = [72e9, 3e-3, 3e-3, 1.5e-3, 1e-3, L1, L2, L3, L4, M1, M2, M3, 0, 0, 0, MP, KP, CP, KU, LA, F,
          STROKE, RISE, LN, MS, FP, SIGMA0, SIGMA1, SIGMA2, MU_S, MU_C, V_S]

C0 = M1 * (L1**2 + HEIGHT**2) / 12 + M1 * L1**2 / 4 + M2 * L1**2
C1 = M2 * (L2**2 + HEIGHT**2) / 12 + M2 * L2**2 / 4
C2 = M3 * (L3**2 + HEIGHT**2) / 12 + M3 * L3**2 / 4
C3 = L1 * M2 * L2


def dyad(phi, sin, cos, sqrt):
    """Directions of crank, coupler and rocker, from the geometry: sines and cosines."""
    s1, c1 = sin(phi), cos(phi)
    x, y = L4 - L1 * c1, -L1 * s1
    d = x * x + y * y
    kappa = (L2**2 - L3**2 + d) / (2 * d)
    eta = sqrt((d - (L2 - L3) ** 2) * ((L2 + L3) ** 2 - d)) / (2 * d)
    s2, c2 = (y * kappa + x * eta) / L2, (x * kappa - y * eta) / L2
    return s1, c1, s2, c2, (L2 * s2 - y) / L3, (L2 * c2 - x) / L3


_, _, S20, C20, S30, C30 = dyad(PHI0, math.sin, math.cos, math.sqrt)


def make_rates(sin, cos, sqrt, exp, asin, magnitude, dyad=dyad):
    """dx/dt with the functions of a peer, as a function of the state and of the drive and its rate."""

    def rates(phi, w, xu, vu, xs, vs, z, xp, dxp):
        s1, c1, s2, c2, s3, c3 = dyad(phi, sin, cos, sqrt)
        s12, c12 = s1 * c2 - c1 * s2, c1 * c2 + s1 * s2
        s13, c13 = s1 * c3 - c1 * s3, c1 * c3 + s1 * s3
        s23, c23 = s2 * c3 - c2 * s3, c2 * c3 + s2 * s3
        w2, w3 = -L1 * s13 / (L2 * s23), -L1 * s12 / (L3 * s23)
        dw2 = (L1 * (w3 - 1) * c13 + L2 * w2 * (w3 - w2) * c23) / (L2 * s23)
        dw3 = (L1 * (w2 - 1) * c12 + L3 * w3 * (w3 - w2) * c23) / (L3 * s23)
        a = C0 + C1 * w2 * w2 + C2 * w3 * w3 + C3 * w2 * c12
        da = 2 * C1 * w2 * dw2 + 2 * C2 * w3 * dw3 + C3 * (dw2 * c12 - w2 * (1 - w2) * s12)
        d1, d2, d3 = phi - PHI0, asin(s2 * C20 - c2 * S20), asin(s3 * C30 - c3 * S30)
        dp = K * (d1 + (w2 - 1) * (d2 - d1) + (w2 - w3) * (d2 - d3) + w3 * d3)
        dp = dp + G * (M1 * L1 / 2 * c1 + M2 * (L1 * c1 + L2 / 2 * w2 * c2) + M3 * L3 / 2 * w3 * c3)
        joint = KU * (xu - LA * (math.cos(PHI0) - c1))
        lever = L1 * s1 + LN * w2 * s2
        v = w * lever - vs
        g = (MU_C * FP + (MU_S - MU_C) * FP * exp(-(v / V_S) * (v / V_S))) / SIGMA0
        dz = v - z * magnitude(v) / g
        friction = SIGMA0 * z + SIGMA1 * dz + SIGMA2 * v
        torque = LA * joint * s1 - FP * (L1 * c1 + LN * w2 * c2) - friction * lever
        return (w, (torque - dp - 0.5 * da * w * w) / a,
                vu, (KP * (xp - xu) + CP * (dxp - vu) - joint) / MP,
                vs, friction / MS, dz)

    return rates


def segments(until, frequency=F):
    """(from, to, drive at the start, its rate) between the drive's kinks."""
    cycle = 0
    while cycle / frequency < until:
        rates = STROKE * frequency / RISE, -STROKE * frequency / (1 - RISE)
        kinks = cycle / frequency, (cycle + RISE) / frequency, (cycle + 1) / frequency
        for (begin, end), start, rate in zip(zip(kinks, kinks[1:]), (0.0, STROKE), rates):
            if begin < until:
                yield begin, min(end, until), start, rate
        cycle += 1


def equal_steps(begin, end, step):
    """The fewest equal steps that are no longer than `step`."""
    return max(1, math.ceil((end - begin) / step * (1 - 1e-9)))
