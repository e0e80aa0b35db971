/* Dormand and Prince's pair 8(5,3) with step control, by hand: straight code for every stage, as in
 * Hairer's DOP853 (E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I,
 * section II.5), without dense output.
 *
 * Before this file is included, define N, the number of states, and
 * `static inline void rates(const Context *c, double t, const double *x, double *dx)`. */

#include <math.h>
#include <string.h>

/* Steps of a run so far. */
typedef struct {
    long evaluations, accepted, rejected;
} Cost;

/* Rates padded to a whole number of vectors; the entries behind N stay zero. */
#define WIDE ((N + 7) / 8 * 8)

/* One step of length h from x with its rates k1: the end in y, the error there in units of what is
 * allowed returned. */
static inline double dop853_step(const Context *c, double t, double h, const double *restrict x,
                                 const double *restrict k1, const double *restrict allowed,
                                 double *restrict y)
{
    double k2[WIDE] = {0}, k3[WIDE] = {0}, k4[WIDE] = {0}, k5[WIDE] = {0}, k6[WIDE] = {0};
    double k7[WIDE] = {0}, k8[WIDE] = {0}, k9[WIDE] = {0}, k10[WIDE] = {0}, k11[WIDE] = {0};
    double k12[WIDE] = {0}, s[WIDE];

#define STAGE(k, time, sum)                                                                        \
    for (int i = 0; i < WIDE; i++)                                                                 \
        s[i] = x[i] + h * (sum);                                                                   \
    rates(c, t + (time) * h, s, k);

    STAGE(k2, 0.05260015195876773,
          0.05260015195876773 * k1[i])
    STAGE(k3, 0.0789002279381516,
          0.0197250569845379 * k1[i] + 0.0591751709536137 * k2[i])
    STAGE(k4, 0.1183503419072274,
          0.02958758547680685 * k1[i] + 0.08876275643042054 * k3[i])
    STAGE(k5, 0.2816496580927726,
          0.2413651341592667 * k1[i] - 0.8845494793282861 * k3[i]
          + 0.924834003261792 * k4[i])
    STAGE(k6, 0.3333333333333333,
          0.037037037037037035 * k1[i] + 0.17082860872947386 * k4[i]
          + 0.12546768756682242 * k5[i])
    STAGE(k7, 0.25,
          0.037109375 * k1[i] + 0.17025221101954405 * k4[i]
          + 0.06021653898045596 * k5[i] - 0.017578125 * k6[i])
    STAGE(k8, 0.3076923076923077,
          0.03709200011850479 * k1[i] + 0.17038392571223998 * k4[i]
          + 0.10726203044637328 * k5[i] - 0.015319437748624402 * k6[i]
          + 0.008273789163814023 * k7[i])
    STAGE(k9, 0.6512820512820513,
          0.6241109587160757 * k1[i] - 3.3608926294469414 * k4[i]
          - 0.868219346841726 * k5[i] + 27.59209969944671 * k6[i]
          + 20.154067550477894 * k7[i] - 43.48988418106996 * k8[i])
    STAGE(k10, 0.6,
          0.47766253643826434 * k1[i] - 2.4881146199716677 * k4[i]
          - 0.590290826836843 * k5[i] + 21.230051448181193 * k6[i]
          + 15.279233632882423 * k7[i] - 33.28821096898486 * k8[i]
          - 0.020331201708508627 * k9[i])
    STAGE(k11, 0.8571428571428571,
          -0.9371424300859873 * k1[i] + 5.186372428844064 * k4[i]
          + 1.0914373489967295 * k5[i] - 8.149787010746927 * k6[i]
          - 18.52006565999696 * k7[i] + 22.739487099350505 * k8[i]
          + 2.4936055526796523 * k9[i] - 3.0467644718982196 * k10[i])
    STAGE(k12, 1.0,
          2.273310147516538 * k1[i] - 10.53449546673725 * k4[i]
          - 2.0008720582248625 * k5[i] - 17.9589318631188 * k6[i]
          + 27.94888452941996 * k7[i] - 2.8589982771350235 * k8[i]
          - 8.87285693353063 * k9[i] + 12.360567175794303 * k10[i]
          + 0.6433927460157636 * k11[i])
#undef STAGE

    double third = 0.0, fifth = 0.0;
    for (int i = 0; i < WIDE; i++) {
        double sum = 0.054293734116568765 * k1[i] + 4.450312892752409 * k6[i]
                  + 1.8915178993145003 * k7[i] - 5.801203960010585 * k8[i]
                  + 0.3111643669578199 * k9[i] - 0.1521609496625161 * k10[i]
                  + 0.20136540080403034 * k11[i] + 0.04471061572777259 * k12[i];
        double e5 = 0.01312004499419488 * k1[i] - 1.2251564463762044 * k6[i]
                  - 0.4957589496572502 * k7[i] + 1.6643771824549864 * k8[i]
                  - 0.35032884874997366 * k9[i] + 0.3341791187130175 * k10[i]
                  + 0.08192320648511571 * k11[i] - 0.022355307863886294 * k12[i];
        double e3 = sum - (0.2440944881889764 * k1[i] + 0.7338466882816118 * k9[i]
                  + 0.022058823529411766 * k12[i]);
        y[i] = x[i] + h * sum;
        e5 *= allowed[i];
        e3 *= allowed[i];
        fifth += e5 * e5;
        third += e3 * e3;
    }
    double both = fifth + 0.01 * third;
    return both == 0.0 ? 0.0 : h * fifth / sqrt(both * N);
}

/* From `t` to `end` with errors below those whose reciprocals `allowed` holds (zero behind N); *h is
 * the step to begin with and then the one to go on with. Returns 0 if the step became too short. */
static int dop853(const Context *c, double t, double end, double *x, const double *allowed, double *h,
                  Cost *cost)
{
    double k1[WIDE] = {0}, y[WIDE];
    double last = 1e-4;
    int was_rejected = 0;
    rates(c, t, x, k1);
    cost->evaluations++;
    while (t < end) {
        double step = *h;
        int ends = step >= 0.999999 * (end - t);
        if (ends)
            step = end - t;
        else if (step > 0.5 * (end - t))
            step = 0.5 * (end - t);
        double error = dop853_step(c, t, step, x, k1, allowed, y);
        cost->evaluations += 11;
        if (!(error <= 1.0)) {
            cost->rejected++;
            *h = step * (isfinite(error) ? fmax(0.2, 0.9 * pow(error, -1.0 / 8.0)) : 0.25);
            was_rejected = 1;
            if (*h < 1e-15 * end)
                return 0;
            continue;
        }
        cost->accepted++;
        memcpy(x, y, sizeof y);
        t = ends ? end : t + step;
        if (t < end) {
            rates(c, t, x, k1);
            cost->evaluations++;
        }
        double grown = step * fmin(was_rejected ? 1.0 : 6.0,
                                   fmax(0.2, 0.9 * pow(error, 0.2 * 0.02 - 1.0 / 8.0)
                                                 * pow(last, 0.02)));
        *h = step < 0.99 * *h && grown < *h ? *h : grown;
        last = fmax(error, 1e-4);
        was_rejected = 0;
    }
    return 1;
}
