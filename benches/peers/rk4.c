/* The classical Runge–Kutta method around a generated right-hand side: W1, as the hand-written C
 * does it. `GENERATED` is the file that has
 * `static inline void rates(const double *x, double xp, double dxp, double *dx)`. */

#define _GNU_SOURCE
#include <stdio.h>
#include <time.h>
#include GENERATED

#define STATES 7

static void stretch(double *x, double xp, double rate, double h, int steps)
{
    double k1[STATES], k2[STATES], k3[STATES], k4[STATES], s[STATES];
    for (int n = 0; n < steps; n++) {
        double xp1 = xp + rate * (n * h), xp2 = xp1 + rate * (0.5 * h), xp4 = xp1 + rate * h;
        rates(x, xp1, rate, k1);
        for (int i = 0; i < STATES; i++)
            s[i] = x[i] + 0.5 * h * k1[i];
        rates(s, xp2, rate, k2);
        for (int i = 0; i < STATES; i++)
            s[i] = x[i] + 0.5 * h * k2[i];
        rates(s, xp2, rate, k3);
        for (int i = 0; i < STATES; i++)
            s[i] = x[i] + h * k3[i];
        rates(s, xp4, rate, k4);
        for (int i = 0; i < STATES; i++)
            x[i] += h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
    }
}

int main(void)
{
    double x[STATES] = {80.0 * 3.14159265358979323846 / 180.0};
    struct timespec before, after;
    clock_gettime(CLOCK_MONOTONIC, &before);
    for (int cycle = 0; cycle < 100; cycle++) {
        stretch(x, 0.0, 20e-6 / 0.95e-3, 1e-7, 9500);
        stretch(x, 20e-6, -20e-6 / 0.05e-3, 1e-7, 500);
    }
    clock_gettime(CLOCK_MONOTONIC, &after);
    printf("%.9f\n", after.tv_sec - before.tv_sec + 1e-9 * (after.tv_nsec - before.tv_nsec));
    for (int i = 0; i < STATES; i++)
        printf("%.17g ", x[i]);
    return 0;
}
