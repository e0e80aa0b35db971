/* The article's actuator in closed form, by hand.
 *
 * The dyad is solved geometrically: with V from the crank's end to the rocker's ground and D = |V|²,
 * q = sqrt((D - (l2 - l3)²) ((l2 + l3)² - D)) is four times the triangle's area; the links' vectors
 * are p2 = κV + ηJV and p3 = p2 - V with κ = (l2² - l3² + D)/(2D) and η = ±q/(2D), and
 * p3 × p2 = -ηD. So all sines and cosines come from one square root, and 1/D and 1/q from one
 * division; 1/A and 1/g(v) share another. Angles of hinges are arcsines of cross products, which
 * holds within a quarter turn of the closed configuration.
 *
 * `real` is a double or a vector of doubles, one trajectory in each entry; kernels.h has the
 * functions. */

#include "kernels.h"

#define PARAMS 32
#define STATES 7

/* Params in the order of the model file. */
enum { E_, B_, H_, WEB, R_, L1, L2, L3, L4, M1, M2, M3, BETA1, BETA2, BETA3, MP, KP, CP, KU, LA, FREQ,
       STROKE, RISE, LN, MS, FP, SIGMA0, SIGMA1, SIGMA2, MU_S, MU_C, V_S };

/* What the right-hand side needs, computed once for a parameter set. The entries of `drive` are for the
 * run alone. */
#define CONSTANTS(X)                                                                               \
    X(l1) X(l4) X(phi0) X(cos0) X(sin0) X(l1l1) X(l1l1_l4l4) X(two_l1l4) X(a) X(b) X(c) X(l2l2_l3l3)  \
    X(half_eps) X(minus_two_eps) X(C0) X(C1) X(C2) X(Kc) X(Ks) X(x20) X(y20) X(x30) X(y30)           \
    X(per_l2l2) X(per_l3l3) X(k) X(g1c) X(g1s) X(g2c) X(g2s) X(g3c) X(g3s) X(la) X(ku) X(Fp)         \
    X(ln_per_l2) X(minus_per_vsvs) X(FC) X(FS_FC) X(sigma0) X(sigma1) X(sigma2) X(kp) X(cp)          \
    X(per_mp) X(per_ms)

typedef struct {
#define X(name) real name;
    CONSTANTS(X)
#undef X
} Model;

typedef struct {
#define X(name) double name;
    CONSTANTS(X)
#undef X
    double f, stroke, rise;
} Design;

static Design prepare(const double *p)
{
    Design d;
    double l1 = p[L1], l2 = p[L2], l3 = p[L3], l4 = p[L4], g = 9.81, pi = 3.14159265358979323846;
    double hh = p[H_] * p[H_];
    double r1 = 0.5 * l1, r2 = 0.5 * l2, r3 = 0.5 * l3;
    double I1 = p[M1] * (l1 * l1 + hh) / 12.0;
    double I2 = p[M2] * (l2 * l2 + hh) / 12.0;
    double I3 = p[M3] * (l3 * l3 + hh) / 12.0;
    d.l1 = l1, d.l4 = l4, d.l1l1 = l1 * l1, d.l1l1_l4l4 = l1 * l1 + l4 * l4, d.two_l1l4 = 2.0 * l1 * l4;
    d.phi0 = 80.0 * pi / 180.0, d.cos0 = cos(d.phi0), d.sin0 = sin(d.phi0);
    d.a = (l2 - l3) * (l2 - l3), d.b = (l2 + l3) * (l2 + l3), d.c = l2 * l2 - l3 * l3;
    d.l2l2_l3l3 = l2 * l2 + l3 * l3;
    /* As assembled: the coupler at about 0 deg, the rocker at about 90 deg. */
    double X = l4 - l1 * d.cos0, Y = -l1 * d.sin0, D = X * X + Y * Y;
    double eps = X / l3 - Y / l2 > 0.0 ? 1.0 : -1.0;
    double kappa = (d.c + D) / (2.0 * D), eta = eps * sqrt((D - d.a) * (d.b - D)) / (2.0 * D);
    d.half_eps = 0.5 * eps, d.minus_two_eps = -2.0 * eps;
    d.x20 = kappa * X - eta * Y, d.y20 = kappa * Y + eta * X;
    d.x30 = d.x20 - X, d.y30 = d.y20 - Y;
    d.per_l2l2 = 1.0 / (l2 * l2), d.per_l3l3 = 1.0 / (l3 * l3);
    d.C0 = I1 + p[M1] * r1 * r1 + p[M2] * l1 * l1;
    d.C1 = I2 + p[M2] * r2 * r2;
    d.C2 = I3 + p[M3] * r3 * r3;
    d.Kc = 2.0 * p[M2] * r2 / l2 * cos(p[BETA2]), d.Ks = 2.0 * p[M2] * r2 / l2 * sin(p[BETA2]);
    d.k = 2.0 * p[E_] * p[B_] * p[WEB] * p[WEB] * sqrt(p[WEB]) / (9.0 * pi * sqrt(p[R_]));
    d.g1c = g * (p[M1] * r1 / l1 * cos(p[BETA1]) + p[M2]), d.g1s = g * p[M1] * r1 / l1 * sin(p[BETA1]);
    d.g2c = g * p[M2] * r2 / l2 * cos(p[BETA2]), d.g2s = g * p[M2] * r2 / l2 * sin(p[BETA2]);
    d.g3c = g * p[M3] * r3 / l3 * cos(p[BETA3]), d.g3s = g * p[M3] * r3 / l3 * sin(p[BETA3]);
    d.la = p[LA], d.ku = p[KU], d.Fp = p[FP], d.ln_per_l2 = p[LN] / l2;
    d.minus_per_vsvs = -1.0 / (p[V_S] * p[V_S]);
    d.FC = p[MU_C] * p[FP], d.FS_FC = p[MU_S] * p[FP] - p[MU_C] * p[FP];
    d.sigma0 = p[SIGMA0], d.sigma1 = p[SIGMA1], d.sigma2 = p[SIGMA2];
    d.kp = p[KP], d.cp = p[CP], d.per_mp = 1.0 / p[MP], d.per_ms = 1.0 / p[MS];
    d.f = p[FREQ], d.stroke = p[STROKE], d.rise = p[RISE];
    return d;
}

/* dx/dt at a drive of xp with rate dxp. */
static inline __attribute__((always_inline)) void rhs(const Model *restrict m, real xp, real dxp,
                                                      const real *restrict x, real *restrict dx)
{
    real phi = x[0], w = x[1], xu = x[2], vu = x[3], vs = x[5], z = x[6];
    real s1, c1, d1 = phi - m->phi0;
    sine_cosine(m->sin0, m->cos0, phi, d1, &s1, &c1);
    real p1x = m->l1 * c1, p1y = m->l1 * s1;
    real X = m->l4 - p1x, Y = -p1y;
    real D = m->l1l1_l4l4 - m->two_l1l4 * c1;
    real q = square_root((D - m->a) * (m->b - D));
    real per_Dq = 1.0 / (D * q);
    real q_per_D = q * (q * per_Dq);
    real kappa = 0.5 * ((m->c + D) * (q * per_Dq));
    real eta = m->half_eps * q_per_D;
    real per_S = m->minus_two_eps * (D * per_Dq);
    real p2x = kappa * X - eta * Y, p2y = kappa * Y + eta * X;
    real p3x = p2x - X, p3y = p2y - Y;
    real cross12 = p1x * p2y - p1y * p2x, dot12 = p1x * p2x + p1y * p2y;
    real cross13 = p1x * p3y - p1y * p3x, dot13 = dot12 - (m->l4 * p1x - m->l1l1);
    real dot23 = 0.5 * (m->l2l2_l3l3 - D);
    real w2 = cross13 * per_S, w3 = cross12 * per_S;
    real turn = (w3 - w2) * dot23;
    real dw2 = ((w3 - 1.0) * dot13 + w2 * turn) * per_S;
    real dw3 = ((w2 - 1.0) * dot12 + w3 * turn) * per_S;
    real K = m->Kc * dot12 - m->Ks * cross12, L = m->Kc * cross12 + m->Ks * dot12;
    real A = m->C0 + m->C1 * (w2 * w2) + m->C2 * (w3 * w3) + w2 * K;
    real half_dA = m->C1 * (w2 * dw2) + m->C2 * (w3 * dw3) + 0.5 * (dw2 * K + w2 * (1.0 - w2) * L);
    real d2 = arcsine((m->x20 * p2y - m->y20 * p2x) * m->per_l2l2);
    real d3 = arcsine((m->x30 * p3y - m->y30 * p3x) * m->per_l3l3);
    real dP = m->k * (d1 + (w2 - 1.0) * (d2 - d1) + (w2 - w3) * (d2 - d3) + w3 * d3)
            + (m->g1c * p1x - m->g1s * p1y) + w2 * (m->g2c * p2x - m->g2s * p2y)
            + w3 * (m->g3c * p3x - m->g3s * p3y);
    real F_joint = m->ku * (xu - m->la * (m->cos0 - c1));
    real jn = p1x + m->ln_per_l2 * (w2 * p2x), jf = p1y + m->ln_per_l2 * (w2 * p2y);

    real v = w * jf - vs;
    real G = m->FC + m->FS_FC * exponential(m->minus_per_vsvs * (v * v));
    real per_AG = 1.0 / (A * G);
    real dz = v - m->sigma0 * z * magnitude(v) * (A * per_AG);
    real F_f = m->sigma0 * z + m->sigma1 * dz + m->sigma2 * v;
    real torque = m->la * s1 * F_joint - m->Fp * jn - F_f * jf - dP - half_dA * (w * w);

    dx[0] = w;
    dx[1] = torque * (G * per_AG);
    dx[2] = vu;
    dx[3] = (m->kp * (xp - xu) + m->cp * (dxp - vu) - F_joint) * m->per_mp;
    dx[4] = vs;
    dx[5] = F_f * m->per_ms;
    dx[6] = dz;
}
