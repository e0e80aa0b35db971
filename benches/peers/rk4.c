/* The classical Runge–Kutta method around a generated right-hand side, as the hand-written C does it: one
 * trajectory for each drive frequency. Reads the end, the step and the frequencies. `GENERATED` is the file that has
 * `static inline void rates(const double *x, double xp, double dxp, double *dx)`. */

#define _GNU_SOURCE
#include <math.h>
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

/* From kink to kink, or to the end, in the fewest equal steps that are no longer than `step`. */
static void between(double *x, double begin, double end, double until, double step, double xp, double rate)
{
    end = end < until ? end : until;
    if (begin < end) {
        int steps = (int)ceil((end - begin) / step * (1.0 - 1e-9));
        steps = steps < 1 ? 1 : steps;
        stretch(x, xp, rate, (end - begin) / steps, steps);
    }
}

int main(void)
{
    static struct { double x[STATES]; } result[1024];
    double until, step, frequency[1024];
    int count = 0;
    if (scanf("%lf %lf", &until, &step) != 2)
        return 2;
    while (count < 1024 && scanf("%lf", &frequency[count]) == 1)
        count++;
    struct timespec before, after;
    clock_gettime(CLOCK_MONOTONIC, &before);
    for (int run = 0; run < count; run++) {
        double *x = result[run].x, f = frequency[run];
        x[0] = 80.0 * 3.14159265358979323846 / 180.0;
        for (int cycle = 0; cycle / f < until; cycle++) {
            between(x, cycle / f, (cycle + 0.95) / f, until, step, 0.0, 20e-6 * f / 0.95);
            between(x, (cycle + 0.95) / f, (cycle + 1) / f, until, step, 20e-6, -20e-6 * f / (1.0 - 0.95));
        }
    }
    clock_gettime(CLOCK_MONOTONIC, &after);
    printf("%.9f\n", after.tv_sec - before.tv_sec + 1e-9 * (after.tv_nsec - before.tv_nsec));
    for (int run = 0; run < count; run++) {
        for (int i = 0; i < STATES; i++)
            printf("%.17g ", result[run].x[i]);
        printf("\n");
    }
    return 0;
}
