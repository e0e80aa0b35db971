/* Runs of the article's actuator, timed.
 *
 *     double_rocker rk4|dop853 SETTING FROM UNTIL UNIT THREADS PERTURBATION [RATE] < PARAMS
 *
 * SETTING is the step in s of rk4 or the tolerance of dop853; FROM and UNTIL are times in s, or in
 * periods of the drive if UNIT is `cycles`; PERTURBATION in rad is added to the crank's angle at the start.
 * RATE in rad/s is that of the crank at the start. Every line of PARAMS is a parameter set. First line of the output: seconds for all runs (preparing
 * them included), evaluations of the right-hand side, the process's largest memory in bytes. Then a
 * line for each run: position of the stage at FROM, and the state at UNTIL.
 *
 * Between two kinks of the drive rk4 takes the fewest equal steps that are no longer than its step.
 * With LANES above 1 (rk4 alone), LANES runs go side by side, each with steps of its own, and one
 * that is done makes room for the next. */

#define _GNU_SOURCE
#include <pthread.h>
#include <sys/resource.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "double_rocker.h"

typedef struct {
    double from_position, state[STATES];
} Result;

static int count, adaptive, in_cycles;
static double setting, from_time, until_time, perturbation, initial_rate;
static double (*params)[PARAMS];
static Result *results;
static atomic_int next_run, failed;
static atomic_long evaluations;

/* The drive between two kinks: xp = start + rate (t - from). */
typedef struct {
    const Design *design;
    double from_time, until;
    double t, end, start, rate;
    long cycle;
    int falling, from_done;
} Segment;

static void enter(Segment *s)
{
    const Design *d = s->design;
    double kink = s->falling ? (s->cycle + 1.0) / d->f : (s->cycle + d->rise) / d->f;
    double from = s->falling ? (s->cycle + d->rise) / d->f : s->cycle / d->f;
    s->rate = s->falling ? -d->stroke * d->f / (1.0 - d->rise) : d->stroke * d->f / d->rise;
    s->start = (s->falling ? d->stroke : 0.0) + s->rate * (s->t - from);
    s->end = kink;
    if (!s->from_done && s->from_time < s->end)
        s->end = s->from_time;
    if (s->until < s->end)
        s->end = s->until;
}

static Segment begin(const Design *d)
{
    double unit = in_cycles ? 1.0 / d->f : 1.0;
    Segment s = {.design = d, .from_time = from_time * unit, .until = until_time * unit};
    s.from_done = s.from_time <= 0.0;
    enter(&s);
    return s;
}

/* Goes on behind the end of the segment, at stage position x; 0 at the end of the run. */
static int advance(Segment *s, double x, Result *result)
{
    const Design *d = s->design;
    s->t = s->end;
    if (!s->from_done && s->t >= s->from_time) {
        s->from_done = 1;
        result->from_position = x;
    }
    if (s->t >= s->until)
        return 0;
    if (s->t >= (s->falling ? (s->cycle + 1.0) / d->f : (s->cycle + d->rise) / d->f)) {
        s->cycle += s->falling;
        s->falling = !s->falling;
    }
    enter(s);
    return 1;
}

static long equal_steps(const Segment *s)
{
    double steps = ceil((s->end - s->t) / setting * (1.0 - 1e-9));
    return steps < 1.0 ? 1 : (long)steps;
}

#ifdef SERIES
#define WATCH_REACH(reach, m, x)                                                                   \
    do {                                                                                           \
        reach = larger(magnitude(x[0] - (m)->phi0), reach);                                        \
    } while (0)
#else
#define WATCH_REACH(reach, m, x) (void)reach
#endif

/* `steps` steps of length h with the drive xp at their start and its rate. */
static inline __attribute__((always_inline)) void rk4(const Model *restrict m, real h, real xp,
                                                      real rate, long steps, real *restrict x,
                                                      real *reach_seen)
{
    real k1[STATES], k2[STATES], k3[STATES], k4[STATES], s[STATES], reach = *reach_seen;
    real half = 0.5 * h, sixth = h / 6.0, step = xp * 0.0;
    for (long n = 0; n < steps; n++) {
        real xp1 = xp + rate * (step * h), xp2 = xp1 + rate * half, xp4 = xp1 + rate * h;
        step += 1.0;
        rhs(m, xp1, rate, x, k1);
        for (int i = 0; i < STATES; i++)
            s[i] = x[i] + half * k1[i];
        rhs(m, xp2, rate, s, k2);
        for (int i = 0; i < STATES; i++)
            s[i] = x[i] + half * k2[i];
        rhs(m, xp2, rate, s, k3);
        for (int i = 0; i < STATES; i++)
            s[i] = x[i] + h * k3[i];
        rhs(m, xp4, rate, s, k4);
        for (int i = 0; i < STATES; i++)
            x[i] += sixth * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
        WATCH_REACH(reach, m, x);
    }
    *reach_seen = reach;
}

#if LANES == 1

typedef struct {
    const Model *model;
    double t, xp, rate;
} Context;

static inline __attribute__((always_inline)) void rates(const Context *c, double t, const double *x,
                                                        double *dx)
{
    rhs(c->model, c->xp + c->rate * (t - c->t), c->rate, x, dx);
}

#define N STATES
#include "dop853.h"

/* What an error of one tolerance is: sizes of the motion, in rad, rad/s, m, m/s. */
static const double size[STATES] = {1e-3, 10.0, 1e-5, 0.1, 1e-5, 0.1, 1e-6};

static void *work(void *unused)
{
    (void)unused;
    Cost cost = {0};
    double reach = 0.0;
    for (int run; (run = next_run++) < count;) {
        Design d = prepare(params[run]);
        Model m;
#define X(name) m.name = d.name;
        CONSTANTS(X)
#undef X
        double x[WIDE] = {d.phi0 + perturbation, initial_rate}, allowed[WIDE] = {0}, h = 1e-8;
        for (int i = 0; i < STATES; i++)
            allowed[i] = 1.0 / (setting * size[i]);
        Segment s = begin(&d);
        results[run].from_position = 0.0;
        do {
            if (adaptive) {
                Context c = {&m, s.t, s.start, s.rate};
                if (!dop853(&c, s.t, s.end, x, allowed, &h, &cost))
                    failed = 1;
                WATCH_REACH(reach, &m, x);
            } else {
                long steps = equal_steps(&s);
                rk4(&m, (s.end - s.t) / steps, s.start, s.rate, steps, x, &reach);
                cost.evaluations += 4 * steps;
            }
        } while (!failed && advance(&s, x[4], &results[run]));
        memcpy(results[run].state, x, sizeof results[run].state);
    }
    evaluations += cost.evaluations;
#ifdef SERIES
    if (!(reach <= REACH))
        failed = 1;
#endif
    return NULL;
}

#else

static void *work(void *unused)
{
    (void)unused;
    Design d[LANES];
    Segment s[LANES];
    Model m;
    real x[STATES], h, xp, rate, reach;
    int run[LANES];
    long left[LANES], done = 0;
    memset(&m, 0, sizeof m), memset(x, 0, sizeof x), memset(&reach, 0, sizeof reach);
    for (int lane = 0; lane < LANES; lane++)
        run[lane] = -2, left[lane] = 0;
    for (;;) {
        int busy = 0;
        long steps = 1L << 62;
        for (int lane = 0; lane < LANES; lane++) {
            if (run[lane] >= 0 && left[lane] == 0) {
                Result *result = &results[run[lane]];
                if (advance(&s[lane], x[4][lane], result)) {
                    left[lane] = equal_steps(&s[lane]);
                    h[lane] = (s[lane].end - s[lane].t) / left[lane];
                    xp[lane] = s[lane].start, rate[lane] = s[lane].rate;
                } else {
                    for (int i = 0; i < STATES; i++)
                        result->state[i] = x[i][lane];
                    run[lane] = -2;
                }
            } else if (run[lane] >= 0) {
                xp[lane] = s[lane].start
                         + s[lane].rate * ((equal_steps(&s[lane]) - left[lane]) * h[lane]);
            }
            if (run[lane] == -2) {
                int next = next_run++;
                run[lane] = next < count ? next : -1;
                if (next < count) {
                    d[lane] = prepare(params[next]);
                    s[lane] = begin(&d[lane]);
                    results[next].from_position = 0.0;
                    left[lane] = equal_steps(&s[lane]);
                    h[lane] = (s[lane].end - s[lane].t) / left[lane];
                    xp[lane] = s[lane].start, rate[lane] = s[lane].rate;
                    for (int i = 0; i < STATES; i++)
                        x[i][lane] = 0.0;
                    x[0][lane] = d[lane].phi0 + perturbation, x[1][lane] = initial_rate;
#define X(name) m.name[lane] = d[lane].name;
                    CONSTANTS(X)
#undef X
                } else {
                    h[lane] = 0.0; /* stands still from here on */
                }
            }
            if (run[lane] >= 0) {
                busy++;
                steps = left[lane] < steps ? left[lane] : steps;
            }
        }
        if (!busy)
            break;
        rk4(&m, h, xp, rate, steps, x, &reach);
        done += 4 * steps * busy;
        for (int lane = 0; lane < LANES; lane++)
            left[lane] -= run[lane] >= 0 ? steps : 0;
    }
    evaluations += done;
    for (int lane = 0; lane < LANES; lane++)
        if (!(reach[lane] <= REACH))
            failed = 1;
    return NULL;
}

#endif

int main(int argc, char **argv)
{
    if (argc != 8 && argc != 9)
        return 2;
    adaptive = !strcmp(argv[1], "dop853");
    setting = atof(argv[2]);
    from_time = atof(argv[3]), until_time = atof(argv[4]);
    in_cycles = !strcmp(argv[5], "cycles");
    int threads = atoi(argv[6]);
    perturbation = atof(argv[7]);
    initial_rate = argc == 9 ? atof(argv[8]) : 0.0;
    if (threads < 1 || threads > 1024 || (adaptive && LANES > 1))
        return 2;
    size_t room = 0;
    for (double value; scanf("%lf", &value) == 1; count++) {
        if (count / PARAMS >= (int)room)
            params = realloc(params, (room = 2 * room + 1) * sizeof *params);
        params[count / PARAMS][count % PARAMS] = value;
    }
    count /= PARAMS;
    results = calloc(count, sizeof *results);

    struct timespec before, after;
    clock_gettime(CLOCK_MONOTONIC, &before);
    pthread_t thread[1024];
    for (int i = 1; i < threads; i++)
        pthread_create(&thread[i], NULL, work, NULL);
    work(NULL);
    for (int i = 1; i < threads; i++)
        pthread_join(thread[i], NULL);
    clock_gettime(CLOCK_MONOTONIC, &after);

    if (failed) {
        fprintf(stderr, "a run failed, or left the range of the series\n");
        return 1;
    }
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    printf("%.9f %ld %ld\n", after.tv_sec - before.tv_sec + 1e-9 * (after.tv_nsec - before.tv_nsec),
           (long)evaluations, usage.ru_maxrss * 1024);
    for (int i = 0; i < count; i++) {
        printf("%.17g", results[i].from_position);
        for (int j = 0; j < STATES; j++)
            printf(" %.17g", results[i].state[j]);
        printf("\n");
    }
    return 0;
}
