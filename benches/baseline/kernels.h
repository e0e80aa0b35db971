/* Functions of the right-hand side: those of libm, or short series about the closed configuration, on
 * one number or on LANES of them. */

#include <math.h>
#include <string.h>

#ifndef LANES
#define LANES 1
#endif

#if LANES > 1
typedef double real __attribute__((vector_size(8 * LANES)));
typedef long long whole __attribute__((vector_size(8 * LANES)));
#else
typedef double real;
#endif

#if LANES == 1
static inline double square_root(double a) { return sqrt(a); }
static inline double magnitude(double a) { return fabs(a); }
static inline double larger(double a, double b) { return a > b ? a : b; }
#else
/* Written entry by entry: the compiler makes one instruction of it. */
static inline real square_root(real a)
{
    real r;
    for (int i = 0; i < LANES; i++)
        r[i] = sqrt(a[i]);
    return r;
}
static inline real magnitude(real a) { return (real)((whole)a & 0x7fffffffffffffffLL); }
static inline real larger(real a, real b)
{
    whole first = a > b;
    return (real)(((whole)a & first) | ((whole)b & ~first));
}
#endif

#ifndef SERIES

static inline void sine_cosine(real sin0, real cos0, real phi, real d, real *s, real *c)
{
    (void)sin0, (void)cos0, (void)d;
    sincos(phi, s, c);
}
static inline real arcsine(real a) { return asin(a); }
static inline real exponential(real a) { return exp(a); }

#else

/* Largest angle from the closed configuration, in rad, for which the series are exact to rounding. */
#define REACH 0.05

/* Sine and cosine of phi = phi0 + d by those of phi0. */
static inline void sine_cosine(real sin0, real cos0, real phi, real d, real *s, real *c)
{
    (void)phi;
    real t = d * d;
    real sd = d * (1.0 + t * (-1.0 / 6 + t * (1.0 / 120 + t * (-1.0 / 5040))));
    real cd = t * (-0.5 + t * (1.0 / 24 + t * (-1.0 / 720 + t * (1.0 / 40320))));
    *s = sin0 + (sin0 * cd + cos0 * sd);
    *c = cos0 + (cos0 * cd - sin0 * sd);
}

static inline real arcsine(real a)
{
    real t = a * a;
    return a + a * t * (1.0 / 6 + t * (3.0 / 40 + t * (15.0 / 336 + t * (105.0 / 3456
             + t * (945.0 / 42240)))));
}

/* e^a for a <= 0: 2^n by the exponent's bits, the rest by Taylor's polynomial of degree 11, which
 * leaves 6e-15 at ln(2)/2. Evaluated by pairs, for its latency. */
static inline real exponential(real a)
{
    const double shift = 6755399441055744.0; /* 1.5 * 2^52: rounds to whole numbers */
#if LANES > 1
    a = larger(a, (real){0} - 708.0);
    real rounded = a * 1.4426950408889634 + shift;
    whole bits = ((whole)rounded << 52) + 0x3ff0000000000000LL;
    real scale = (real)bits;
#else
    a = larger(a, -708.0);
    double rounded = a * 1.4426950408889634 + shift, scale;
    unsigned long long bits;
    memcpy(&bits, &rounded, sizeof bits);
    bits = (bits << 52) + 0x3ff0000000000000ULL;
    memcpy(&scale, &bits, sizeof scale);
#endif
    rounded -= shift;
    real r = a - rounded * 0.693147180369123816490;
    r -= rounded * 1.90821492927058770002e-10;
    real r2 = r * r, r4 = r2 * r2;
    real p0 = (1.0 + r) + r2 * (0.5 + r * (1.0 / 6));
    real p4 = (1.0 / 24 + r * (1.0 / 120)) + r2 * (1.0 / 720 + r * (1.0 / 5040));
    real p8 = (1.0 / 40320 + r * (1.0 / 362880)) + r2 * (1.0 / 3628800 + r * (1.0 / 39916800));
    return scale * (p0 + r4 * (p4 + r4 * p8));
}

#endif
