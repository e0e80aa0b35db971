/* Andrews' squeezing mechanism in absolute coordinates, by hand, with an adaptive solver.
 *
 *     andrews TOLERANCE UNTIL REPETITIONS
 *
 * Coordinates are the centres of mass and the angles of the seven bodies; the ten pins act through
 * multipliers: M q'' + G^T λ = Q, G q'' = γ. M is diagonal, so S = G M^-1 G^T is made of 2×2 blocks, one
 * for each pair of pins on one body, and a Cholesky decomposition within its envelope solves for λ.
 * Data: IVP test set (Mazzia, Magherini), "Andrews' squeezing mechanism".
 *
 * Output: seconds of the fastest run, evaluations; then the seven published angles and rates. */

#define _GNU_SOURCE
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#define BODIES 7
#define PINS 10
#define N (6 * BODIES)
#define EQUATIONS (2 * PINS)

static const double mass[BODIES] = {0.04325, 0.00365, 0.02373, 0.00706, 0.07050, 0.00706, 0.05498};
static const double inertia[BODIES] = {2.194e-6, 4.410e-7, 5.255e-6, 5.667e-7,
                                       1.169e-5, 5.667e-7, 1.912e-5};
static const double rr = 7e-3, ra = 0.92e-3, d_ = 28e-3, da = 11.5e-3, ss = 35e-3, sa = 18.74e-3;
static const double sb = 10.43e-3, sc = 18e-3, sd = 20e-3, e_ = 20e-3, ea = 14.21e-3, zt = 40e-3;
static const double ta = 23.08e-3, tb = 9.16e-3, zf = 20e-3, fa = 14.21e-3, u_ = 40e-3, ua = 12.28e-3;
static const double ub = 4.49e-3, xa = -69.34e-3, ya = -2.27e-3, xb = -36.35e-3, yb = 32.73e-3;
static const double xc = 14e-3, yc = 72e-3, c0 = 4530.0, l0 = 77.85e-3, moment = 0.033;
static const double half_pi = 1.57079632679489661923;

/* A pin: a point of body `a` at (ax, ay) from its centre of mass, in its frame, on one of body `b` or
 * on the ground (-1). In an order that keeps the envelope of S small. */
typedef struct {
    int a, b;
    double ax, ay, bx, by;
} Pin;
enum { PIN_O, PIN_F, PIN_E23, PIN_A5, PIN_G, PIN_E43, PIN_A7, PIN_H, PIN_E63, PIN_B };
static Pin pins[PINS];
static double dx_, dy_; /* D from the centre of mass of body 3 */
static int first[EQUATIONS]; /* first column in each row's envelope */

/* Pairs of pins on one body: block (p, q) of S, p >= q, with the bodies' share. */
typedef struct {
    int p, q, body, p_is_b, q_is_b;
} Pair;
static Pair pairs[64];
static int pair_count;

typedef struct {
    int unused;
} Context;

static inline void rates(const Context *c, double t, const double *restrict x, double *restrict dx)
{
    (void)c, (void)t;
    const double *v = x + 3 * BODIES;
    double *a = dx + 3 * BODIES;
    double sine[BODIES], cosine[BODIES];
    for (int i = 0; i < BODIES; i++)
        sincos(x[3 * i + 2], &sine[i], &cosine[i]);

    /* Accelerations without pins. */
    double free_[3 * BODIES] = {0};
    double rx = cosine[2] * dx_ - sine[2] * dy_, ry = sine[2] * dx_ + cosine[2] * dy_;
    double px = xc - (x[6] + rx), py = yc - (x[7] + ry);
    double length = sqrt(px * px + py * py);
    double pull = c0 * (length - l0) / length, fx = pull * px, fy = pull * py;
    free_[6] = fx / mass[2], free_[7] = fy / mass[2], free_[8] = (rx * fy - ry * fx) / inertia[2];
    free_[2] = moment / inertia[0];

    /* Levers of the pins, turned by a right angle: what a unit of angular acceleration does. */
    double ux[PINS][2], uy[PINS][2], rhs[EQUATIONS], s[EQUATIONS][EQUATIONS];
    for (int p = 0; p < PINS; p++) {
        const Pin *pin = &pins[p];
        int i = pin->a, j = pin->b;
        double sx = cosine[i] * pin->ax - sine[i] * pin->ay;
        double sy = sine[i] * pin->ax + cosine[i] * pin->ay;
        double w = v[3 * i + 2] * v[3 * i + 2];
        ux[p][0] = -sy, uy[p][0] = sx;
        rhs[2 * p] = free_[3 * i] - sy * free_[3 * i + 2] - w * sx;
        rhs[2 * p + 1] = free_[3 * i + 1] + sx * free_[3 * i + 2] - w * sy;
        if (j >= 0) {
            sx = cosine[j] * pin->bx - sine[j] * pin->by;
            sy = sine[j] * pin->bx + cosine[j] * pin->by;
            w = v[3 * j + 2] * v[3 * j + 2];
            ux[p][1] = sy, uy[p][1] = -sx;
            rhs[2 * p] -= free_[3 * j] - sy * free_[3 * j + 2] - w * sx;
            rhs[2 * p + 1] -= free_[3 * j + 1] + sx * free_[3 * j + 2] - w * sy;
        }
    }
    for (int i = 0; i < EQUATIONS; i++)
        for (int j = first[i]; j <= i; j++)
            s[i][j] = 0.0;
    for (int n = 0; n < pair_count; n++) {
        const Pair *r = &pairs[n];
        double per_m = (r->p_is_b == r->q_is_b ? 1.0 : -1.0) / mass[r->body];
        double per_i = 1.0 / inertia[r->body];
        double px_ = ux[r->p][r->p_is_b] * per_i, py_ = uy[r->p][r->p_is_b] * per_i;
        double qx = ux[r->q][r->q_is_b], qy = uy[r->q][r->q_is_b];
        s[2 * r->p][2 * r->q] += per_m + px_ * qx;
        s[2 * r->p + 1][2 * r->q] += py_ * qx;
        s[2 * r->p + 1][2 * r->q + 1] += per_m + py_ * qy;
        if (r->p != r->q)
            s[2 * r->p][2 * r->q + 1] += px_ * qy;
    }
    /* S = L D L^T within the envelope, then λ in rhs. */
    double per_d[EQUATIONS];
    for (int i = 0; i < EQUATIONS; i++) {
        for (int j = first[i]; j < i; j++) {
            double sum = s[i][j];
            for (int k = first[i] > first[j] ? first[i] : first[j]; k < j; k++)
                sum -= s[i][k] * s[j][k];
            s[i][j] = sum;
        }
        double diagonal = s[i][i];
        for (int k = first[i]; k < i; k++) {
            double scaled = s[i][k] * per_d[k];
            diagonal -= s[i][k] * scaled;
            rhs[i] -= scaled * rhs[k];
            s[i][k] = scaled;
        }
        per_d[i] = 1.0 / diagonal;
        /* Rows below use unscaled entries times scaled ones. */
    }
    for (int i = 0; i < EQUATIONS; i++)
        rhs[i] *= per_d[i];
    for (int i = EQUATIONS - 1; i >= 0; i--)
        for (int k = first[i]; k < i; k++)
            rhs[k] -= s[i][k] * rhs[i];

    for (int i = 0; i < 3 * BODIES; i++)
        dx[i] = v[i], a[i] = free_[i];
    for (int p = 0; p < PINS; p++) {
        int body[2] = {pins[p].a, pins[p].b};
        for (int side = 0; side < 2 && body[side] >= 0; side++) {
            double sign = side ? -1.0 : 1.0, lx = rhs[2 * p], ly = rhs[2 * p + 1];
            int i = body[side];
            a[3 * i] -= sign * lx / mass[i];
            a[3 * i + 1] -= sign * ly / mass[i];
            a[3 * i + 2] -= (ux[p][side] * lx + uy[p][side] * ly) / inertia[i];
        }
    }
}

#include "dop853.h"

/* Sets a pin by its places in the bodies' frames, whose origins are their pivots. */
static const double com[BODIES][2] = {{ra, 0}, {-da, 0}, {sb, -sa}, {e_ - ea, 0}, {ta, tb},
                                      {zf - fa, 0}, {ua, ub}};
static void pin(int index, int a, double ax, double ay, int b, double bx, double by)
{
    Pin p = {a, b, ax - com[a][0], ay - com[a][1], bx, by};
    if (b >= 0)
        p.bx -= com[b][0], p.by -= com[b][1];
    pins[index] = p;
}

static void place(double *x, int body, double px, double py, double angle)
{
    x[3 * body] = px + cos(angle) * com[body][0] - sin(angle) * com[body][1];
    x[3 * body + 1] = py + sin(angle) * com[body][0] + cos(angle) * com[body][1];
    x[3 * body + 2] = angle;
}

int main(int argc, char **argv)
{
    if (argc != 4)
        return 2;
    pin(PIN_O, 0, 0, 0, -1, 0, 0);
    pin(PIN_F, 0, rr, 0, 1, 0, 0);
    pin(PIN_E23, 1, -d_, 0, 2, 0, -ss);
    pin(PIN_A5, 4, 0, 0, -1, xa, ya);
    pin(PIN_G, 4, zt, 0, 3, 0, 0);
    pin(PIN_E43, 3, e_, 0, 2, 0, -ss);
    pin(PIN_A7, 6, 0, 0, -1, xa, ya);
    pin(PIN_H, 6, u_, 0, 5, 0, 0);
    pin(PIN_E63, 5, zf, 0, 2, 0, -ss);
    pin(PIN_B, 2, 0, 0, -1, xb, yb);
    dx_ = sd - com[2][0], dy_ = -sc - com[2][1];
    for (int p = 0; p < PINS; p++) {
        int least = p;
        for (int q = 0; q <= p; q++)
            for (int i = 0; i < 2; i++)
                for (int j = 0; j < 2; j++) {
                    int a = i ? pins[p].b : pins[p].a, b = j ? pins[q].b : pins[q].a;
                    if (a < 0 || a != b)
                        continue;
                    pairs[pair_count++] = (Pair){p, q, a, i, j};
                    least = q < least ? q : least;
                }
        first[2 * p] = first[2 * p + 1] = 2 * least;
    }

    double start[WIDE] = {0};
    double beta = -0.0617138900142764496358948458001, gamma = 0.455279819163070380255912382449;
    double phi = 0.222668390165885884674473185609, delta = 0.487364979543842550225598953530;
    double omega = -0.222668390165885884674473185609, epsilon = 1.23054744454982119249735015568;
    place(start, 0, 0, 0, beta);
    place(start, 1, rr * cos(beta), rr * sin(beta), beta);
    place(start, 2, xb, yb, gamma);
    place(start, 3, xa + zt * cos(delta), ya + zt * sin(delta), phi + delta - half_pi);
    place(start, 4, xa, ya, delta);
    place(start, 5, xa + u_ * sin(epsilon), ya - u_ * cos(epsilon), omega + epsilon);
    place(start, 6, xa, ya, epsilon - half_pi);

    double tolerance = atof(argv[1]), until = atof(argv[2]), least = INFINITY;
    double allowed[WIDE] = {0}, x[WIDE];
    for (int i = 0; i < N; i++) {
        double size = i % 3 == 2 ? 1.0 : 1e-2;
        allowed[i] = 1.0 / (tolerance * (i < 3 * BODIES ? size : 1e3 * size));
    }
    Context c = {0};
    Cost cost;
    for (int n = 0; n < atoi(argv[3]); n++) {
        struct timespec before, after;
        clock_gettime(CLOCK_MONOTONIC, &before);
        memcpy(x, start, sizeof x);
        memset(&cost, 0, sizeof cost);
        double h = 1e-6;
        if (!dop853(&c, 0.0, until, x, allowed, &h, &cost))
            return 1;
        clock_gettime(CLOCK_MONOTONIC, &after);
        least = fmin(least, after.tv_sec - before.tv_sec + 1e-9 * (after.tv_nsec - before.tv_nsec));
    }
    printf("%.9f %ld\n", least, cost.evaluations);
    for (const double *y = x; y <= x + 3 * BODIES; y += 3 * BODIES) {
        double turn = y == x ? half_pi : 0.0;
        printf("%.17g %.17g %.17g %.17g %.17g %.17g %.17g\n", y[2], y[5] - y[2], y[8],
               y[11] - y[14] + turn, y[14], y[17] - (y[20] + turn), y[20] + turn);
    }
    return 0;
}
