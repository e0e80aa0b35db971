"""Runs each peer on its workloads, checks its end state, and prints the table."""

import csv
import math
import os
import subprocess
import sys
import time
from pathlib import Path

from actuator import F, PARAMS, START, equal_steps, make_rates, segments

HERE = Path(__file__).resolve().parent
TARGET = Path(sys.argv[1])
BUILT = TARGET / "peers" / "built"
ROUNDS = 3
FLAGS = ["-O3", "-march=native", "-fno-math-errno", "-fno-trapping-math"]
#: Allowed difference of states in equal steps, relative to the largest of each, and of stage.x in W2.
SAME, POSITION = 1e-9, 1e-6
#: End, step and drive frequencies of the workloads in equal steps.
ONE = (0.1, 1e-7, [F])
MANY = (0.02, 2e-7, [100.0 + 1900.0 * i / 63.0 for i in range(64)])
NAMES = ["phi", "w", "xu", "vu", "xs", "vs", "z"]


class Left(Exception):
    """Why a peer has no row."""


def build(source, name, *defines):
    BUILT.mkdir(parents=True, exist_ok=True)
    program = BUILT / name
    done = subprocess.run([os.environ.get("CC", "gcc"), *FLAGS, *defines, source, "-o", program,
                           "-lm", "-pthread"], capture_output=True, text=True)
    if done.returncode:
        raise Left(done.stderr)
    return program


def hand_written(method, setting, until=0.1, frequencies=(F,)):
    program = build(HERE.parent / "baseline" / "double_rocker.c", "hand_written")
    place = PARAMS.index(F)
    lines = "\n".join(" ".join(repr(float(value)) for value in [*PARAMS[:place], frequency, *PARAMS[place + 1:]])
                      for frequency in frequencies)

    def run():
        out = subprocess.run([program, method, repr(setting), "0", repr(until), "s", "1", "0"],
                             input=lines, capture_output=True, text=True, check=True).stdout.splitlines()
        return float(out[0].split()[0]), [float(word) for line in out[1:] for word in line.split()[1:]]

    return run


def generated(text, name, work):
    BUILT.mkdir(parents=True, exist_ok=True)
    path = BUILT / f"{name}.h"
    path.write_text(text)
    program = build(HERE / "rk4.c", name, f'-DGENERATED="{path}"')

    until, step, frequencies = work

    def run():
        seconds, *states = subprocess.run([program], input=" ".join(map(repr, [until, step, *frequencies])),
                                          capture_output=True, text=True, check=True).stdout.splitlines()
        return float(seconds), [float(word) for state in states for word in state.split()]

    return run


def casadi_c(work):
    import casadi as ca

    symbols = [ca.SX.sym(name) for name in [*NAMES, "xp", "dxp"]]
    rates = make_rates(ca.sin, ca.cos, ca.sqrt, ca.exp, ca.asin, ca.fabs)
    inputs = [ca.vertcat(*symbols[:7]), symbols[7], symbols[8]]
    function = ca.Function("casadi_rates", inputs, [ca.cse(ca.vertcat(*rates(*symbols)))])
    generator = ca.CodeGenerator("casadi_rates", {"with_header": False})
    generator.add(function)
    call = """
static inline void rates(const double *x, double xp, double dxp, double *dx)
{
    const double *arguments[] = {x, &xp, &dxp};
    double *results[] = {dx};
    double work[%d];
    casadi_rates(arguments, results, 0, work, 0);
}
""" % max(function.sz_w(), 1)
    return generated(generator.dump() + call, "casadi", work)


def sympy_c(work):
    import sympy as sp

    symbols = sp.symbols([*NAMES, "xp", "dxp"], real=True)
    rates = make_rates(sp.sin, sp.cos, sp.sqrt, sp.exp, sp.asin, sp.Abs)(*symbols)
    shared, results = sp.cse(rates)
    lines = [f"const double {name} = x[{i}];" for i, name in enumerate(NAMES)]
    lines += [f"const double {name} = {sp.ccode(value)};" for name, value in shared]
    lines += [f"dx[{i}] = {sp.ccode(value)};" for i, value in enumerate(results)]
    head = "#include <math.h>\nstatic inline void rates(const double *x, double xp, double dxp, double *dx)\n"
    return generated(head + "{\n    " + "\n    ".join(lines) + "\n}\n", "sympy", work)


def numba_rates():
    import numba

    from actuator import dyad

    rates = make_rates(math.sin, math.cos, math.sqrt, math.exp, math.asin, abs, numba.njit(dyad))
    return numba.njit(rates)


def numba_rk4(work):
    import numba

    rates = numba_rates()

    @numba.njit
    def stretch(x, xp, rate, h, steps):
        for n in range(steps):
            xp1 = xp + rate * (n * h)
            xp2, xp4 = xp1 + rate * 0.5 * h, xp1 + rate * h
            a, b, c, d, e, f, g = x
            k = rates(a, b, c, d, e, f, g, xp1, rate)
            l = rates(a + 0.5 * h * k[0], b + 0.5 * h * k[1], c + 0.5 * h * k[2], d + 0.5 * h * k[3],
                      e + 0.5 * h * k[4], f + 0.5 * h * k[5], g + 0.5 * h * k[6], xp2, rate)
            m = rates(a + 0.5 * h * l[0], b + 0.5 * h * l[1], c + 0.5 * h * l[2], d + 0.5 * h * l[3],
                      e + 0.5 * h * l[4], f + 0.5 * h * l[5], g + 0.5 * h * l[6], xp2, rate)
            o = rates(a + h * m[0], b + h * m[1], c + h * m[2], d + h * m[3], e + h * m[4],
                      f + h * m[5], g + h * m[6], xp4, rate)
            s = h / 6.0
            x = (a + s * (k[0] + 2 * (l[0] + m[0]) + o[0]), b + s * (k[1] + 2 * (l[1] + m[1]) + o[1]),
                 c + s * (k[2] + 2 * (l[2] + m[2]) + o[2]), d + s * (k[3] + 2 * (l[3] + m[3]) + o[3]),
                 e + s * (k[4] + 2 * (l[4] + m[4]) + o[4]), f + s * (k[5] + 2 * (l[5] + m[5]) + o[5]),
                 g + s * (k[6] + 2 * (l[6] + m[6]) + o[6]))
        return x

    return in_stretches(stretch, tuple(START), work)


def jax_rk4(work):
    import jax
    import jax.numpy as jnp

    jax.config.update("jax_enable_x64", True)
    rates = make_rates(jnp.sin, jnp.cos, jnp.sqrt, jnp.exp, jnp.arcsin, jnp.abs)

    @jax.jit
    def stretch(x, xp, rate, h, steps):
        def slope(x, xp):
            return jnp.stack(jnp.broadcast_arrays(*rates(*x, xp, rate)))

        def step(n, x):
            xp1 = xp + rate * (n * h)
            k1 = slope(x, xp1)
            k2 = slope(x + 0.5 * h * k1, xp1 + rate * 0.5 * h)
            k3 = slope(x + 0.5 * h * k2, xp1 + rate * 0.5 * h)
            k4 = slope(x + h * k3, xp1 + rate * h)
            return x + h / 6.0 * (k1 + 2.0 * (k2 + k3) + k4)

        return jax.lax.fori_loop(0, steps, step, x)

    return in_stretches(stretch, jnp.array(START), work)


def in_stretches(stretch, start, work):
    """Trajectories by a compiled loop from kink to kink; compiled by the first, uncounted call."""
    until, step, frequencies = work

    def run():
        before, states = time.perf_counter(), []
        for frequency in frequencies:
            x = start
            for begin, end, xp, rate in segments(until, frequency):
                steps = equal_steps(begin, end, step)
                x = stretch(x, xp, rate, (end - begin) / steps, steps)
            states += [float(value) for value in x]
        return time.perf_counter() - before, states

    return run


def scipy_ivp(method, rtol):
    import numba
    import numpy as np
    from scipy.integrate import solve_ivp

    rates = numba_rates()

    @numba.njit
    def slope(t, x, begin, xp, rate):
        return np.array(rates(x[0], x[1], x[2], x[3], x[4], x[5], x[6], xp + rate * (t - begin), rate))

    scale = np.array([1e-3, 10.0, 1e-5, 0.1, 1e-5, 0.1, 1e-6])
    # A trial step may be so long that the linkage cannot close: it is rejected.
    np.seterr(invalid="ignore")

    def run():
        before, x = time.perf_counter(), np.array(START)
        for begin, end, xp, rate in segments(0.1):
            # Tolerances by the size of each state's motion; relative ones would be lost on the angle.
            done = solve_ivp(slope, (begin, end), x, method, t_eval=[end], args=(begin, xp, rate),
                             rtol=2.3e-14, atol=rtol * scale)
            if not done.success:
                raise Left(done.message)
            x = done.y[:, -1]
        return time.perf_counter() - before, list(x)

    return run


def heyoka_taylor(tolerance):
    import heyoka as hy

    x = hy.make_vars(*NAMES)
    # Params: drive at the start of the stretch, its rate, the stretch's start, the sign of v.
    xp = hy.par[0] + hy.par[1] * (hy.time - hy.par[2])
    slip = []

    def magnitude(v):
        slip.append(v)
        return hy.par[3] * v

    rates = make_rates(hy.sin, hy.cos, hy.sqrt, hy.exp, hy.asin, magnitude)(*x, xp, hy.par[1])
    v = slip[0]

    def turns(solver, direction):
        solver.pars[3] = direction
        return True

    # Its step control does not see the peak of exp(-(v/v_S)^2): steps end where v enters it.
    events = [hy.t_event(v, callback=turns)]
    events += [hy.t_event(v - factor * 1e-3, callback=lambda solver, direction: True)
               for factor in (-7, -4, -2, 2, 4, 7)]
    solver = hy.taylor_adaptive(list(zip(x, rates)), START, tol=tolerance, t_events=events,
                                pars=[0.0] * 4, compact_mode=True)
    slip_velocity = hy.cfunc([v], x)

    def run():
        before = time.perf_counter()
        solver.time, solver.state[:] = 0.0, START
        for begin, end, xp, rate in segments(0.1):
            solver.pars[:3] = xp, rate, begin
            if begin == 0.0:
                solver.pars[3] = 1.0
            outcome = solver.propagate_until(end)[0]
            if outcome != hy.taylor_outcome.time_limit:
                raise Left(f"stopped: {outcome}")
        return time.perf_counter() - before, list(solver.state)

    return run


def free_four_bar(tolerance):
    """The free four-bar by the actuator's C, without drive, contact and sections; 2 ms from 20 rad/s."""
    program = build(HERE.parent / "baseline" / "double_rocker.c", "hand_written")
    free = dict(h=2, ku=18, ln=23, Fp=25, sigma0=26, sigma1=27, sigma2=28)
    params = [float(value) for value in PARAMS]
    for name, place in free.items():
        params[place] = 1e-30 if name == "Fp" else 0.0
    line = " ".join(map(repr, params))

    def run():
        out = subprocess.run([program, "dop853", repr(tolerance), "0", "2e-3", "s", "1", "0", "20"],
                             input=line, capture_output=True, text=True, check=True).stdout.split()
        return float(out[0]), [float(out[4]) - START[0], float(out[5])]

    return run


def exudyn_four_bar(steps):
    import exudyn as exu
    from exudyn import itemInterface as items

    import actuator as a

    s1, c1, s2, c2, s3, c3 = a.dyad(a.PHI0, math.sin, math.cos, math.sqrt)
    s12, s13, s23 = s1 * c2 - c1 * s2, s1 * c3 - c1 * s3, s2 * c3 - c2 * s3
    w = [20.0, -20.0 * a.L1 * s13 / (a.L2 * s23), -20.0 * a.L1 * s12 / (a.L3 * s23)]
    # First end, its velocity, angle, length, mass of each bar.
    bars = [((0, 0), (0, 0), (c1, s1), a.L1, a.M1, w[0]),
            ((a.L1 * c1, a.L1 * s1), (-a.L1 * s1 * w[0], a.L1 * c1 * w[0]), (c2, s2), a.L2, a.M2, w[1]),
            ((a.L4, 0), (0, 0), (c3, s3), a.L3, a.M3, w[2])]

    def run():
        container = exu.SystemContainer()
        system = container.AddSystem()
        ground = system.AddObject(items.ObjectGround())
        fixed = system.AddNode(items.NodePointGround())
        angle = [system.AddMarker(items.MarkerNodeCoordinate(nodeNumber=fixed, coordinate=0))]
        ends, nodes = [], []
        for (x, y), (vx, vy), (c, s), length, mass, rate in bars:
            half = length / 2
            node = system.AddNode(items.NodeRigidBody2D(
                referenceCoordinates=[x + half * c, y + half * s, math.atan2(s, c)],
                initialVelocities=[vx - half * s * rate, vy + half * c * rate, rate]))
            body = system.AddObject(items.ObjectRigidBody2D(
                mass=mass, inertia=mass * length**2 / 12, nodeNumber=node))
            ends.append([system.AddMarker(items.MarkerBodyPosition(
                bodyNumber=body, localPosition=[place, 0, 0])) for place in (-half, half)])
            angle.append(system.AddMarker(items.MarkerNodeCoordinate(nodeNumber=node, coordinate=2)))
            system.AddLoad(items.LoadForceVector(
                markerNumber=system.AddMarker(items.MarkerBodyPosition(bodyNumber=body)),
                loadVector=[0, -mass * a.G, 0]))
            nodes.append(node)
        pins = [system.AddMarker(items.MarkerBodyPosition(bodyNumber=ground, localPosition=place))
                for place in ([0, 0, 0], [a.L4, 0, 0])]
        for pair in ((pins[0], ends[0][0]), (ends[0][1], ends[1][0]), (ends[1][1], ends[2][1]),
                     (pins[1], ends[2][0])):
            system.AddObject(items.ObjectJointRevolute2D(markerNumbers=list(pair)))
        for pair in ((0, 1), (1, 2), (2, 3), (0, 3)):
            system.AddObject(items.ObjectConnectorCoordinateSpringDamper(
                markerNumbers=[angle[i] for i in pair], stiffness=a.K))
        system.Assemble()
        settings = exu.SimulationSettings()
        settings.timeIntegration.numberOfSteps = steps
        settings.timeIntegration.endTime = 2e-3
        settings.timeIntegration.newton.useModifiedNewton = True
        settings.timeIntegration.verboseMode = 0
        settings.solution.file.write = False
        before = time.perf_counter()
        system.SolveDynamic(settings, solverType=exu.DynamicSolverType.TrapezoidalIndex2)
        seconds = time.perf_counter() - before
        moved = system.GetNodeOutput(nodes[0], exu.OutputVariableType.Coordinates)
        rate = system.GetNodeOutput(nodes[0], exu.OutputVariableType.Coordinates_t)
        return seconds, [moved[2], rate[2]]

    return run


def loosest(peer, settings, good):
    """The first of the settings that is good together with the next tighter one."""
    last = None
    for setting in settings:
        run = peer(setting)
        if not good(run()[1]):
            last = None
        elif last is not None:
            return last
        else:
            last = setting, run
    if last is None:
        raise Left(f"not accurate enough at {settings[-1]:g}")
    return last


def relative(a, b):
    return 0.0 if a == b else abs(a - b) / max(abs(a), abs(b))


def measured(workload, candidates, good, note):
    """Rows of the peers that are there and right; the first candidate is the baseline."""
    runs, remarks = {}, []
    for name, make in candidates:
        print(f"  {name}", file=sys.stderr)
        try:
            made = make()
            label, run = made if isinstance(made, tuple) else ("", made)
            state = run()[1]
            if not good(state):
                raise Left("its end state differs")
            runs[name + label] = run
        except ImportError as why:
            remarks.append(f"{workload} {name}: no row; not installed: {why}")
        except Exception as why:  # a peer that fails must not take the others along
            remarks.append(f"{workload} {name}: no row; {why}")
    seconds = {name: math.inf for name in runs}
    for _ in range(ROUNDS):
        for name, run in runs.items():
            seconds[name] = min(seconds[name], run()[0])
    base = next(iter(seconds.values()))
    rows = [(workload, name, 1, value, base / value, note(value)) for name, value in seconds.items()]
    return rows, remarks


def equal_stepping(workload, work):
    until, step, frequencies = work
    baseline = hand_written("rk4", step, until, frequencies)
    expected = baseline()[1]
    width = len(START)
    # Of many trajectories, rates that pass through zero are compared with their largest.
    largest = [max(abs(value) for value in expected[i::width]) for i in range(width)]

    def good(state):
        return len(state) == len(expected) and all(
            abs(a - b) <= SAME * largest[i % width] for i, (a, b) in enumerate(zip(state, expected)))

    peers = [("C libm", lambda: baseline), ("CasADi generated C", lambda: casadi_c(work)),
             ("SymPy generated C", lambda: sympy_c(work)), ("Numba", lambda: numba_rk4(work)),
             ("JAX", lambda: jax_rk4(work))]
    evaluations = sum(4 * equal_steps(begin, end, step) for frequency in frequencies
                      for begin, end, _, _ in segments(until, frequency))
    return measured(workload, peers, good, lambda s: f"{s / evaluations * 1e9:.1f} ns a right-hand side")


def to_an_accuracy():
    expected = hand_written("dop853", 1e-13)()[1][4]

    def good(state):
        return relative(state[4], expected) <= POSITION

    tolerances = [1e-4, 3e-5, 1e-5, 3e-6, 1e-6, 3e-7, 1e-7, 3e-8, 1e-8, 1e-9]

    def ladder(peer):
        def make():
            setting, run = loosest(peer, tolerances, good)
            return f", tolerance {setting:.0e}", run

        return make

    peers = [("C libm", ladder(lambda tolerance: hand_written("dop853", tolerance))),
             ("SciPy DOP853, Numba", ladder(lambda rtol: scipy_ivp("DOP853", rtol))),
             ("SciPy LSODA, Numba", ladder(lambda rtol: scipy_ivp("LSODA", rtol))),
             ("heyoka", ladder(heyoka_taylor))]
    return measured("W2", peers, good, lambda s: f"{s * 1e3:.1f} ms")


def four_bar():
    expected = free_four_bar(1e-12)()[1]

    def good(state):
        return abs(state[1] - expected[1]) <= 1e-4 * 20.0

    def ladder(peer, settings):
        def make():
            setting, run = loosest(peer, settings, good)
            return f" {setting:g}", run

        return make

    peers = [("C libm, tolerance", ladder(free_four_bar, [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8])),
             ("Exudyn, steps", ladder(exudyn_four_bar, [1000 * 2**n for n in range(8)]))]
    return measured("four-bar", peers, good, lambda s: f"{s * 1e3:.2f} ms")


def write(rows):
    """Adds rows to benchmarks.csv, in place of those of the same workload and implementation."""
    path = TARGET / "benchmarks.csv"
    head = ["workload", "implementation", "cores", "seconds", "ratio"]
    old = list(csv.reader(path.open()))[1:] if path.exists() else []
    new = [row for row in rows if not row[1].startswith("C ")]
    names = {(row[0], row[1]) for row in new}
    with path.open("w", newline="") as out:
        table = csv.writer(out, lineterminator="\n")
        table.writerow(head)
        table.writerows(row for row in old if (row[0], row[1]) not in names)
        table.writerows([row[0], row[1], row[2], f"{row[3]:.9f}", f"{row[4]:.4g}"] for row in new)
    return path


def main():
    workloads = {"W1": lambda: equal_stepping("W1", ONE), "W2": to_an_accuracy,
                 "W3": lambda: equal_stepping("W3", MANY), "four-bar": four_bar}
    wanted = sys.argv[2:] or list(workloads)
    rows, remarks = [], []
    for name in wanted:
        if name not in workloads:
            sys.exit(f"`{name}` is no workload; there are {', '.join(workloads)}")
        print(f"{name} …", file=sys.stderr)
        try:
            found, said = workloads[name]()
            rows += found
            remarks += said
        except (Left, OSError, subprocess.CalledProcessError) as why:
            remarks.append(f"{name}: no C to compare with: {why}")
    width = max([len(row[1]) for row in rows], default=14)
    print(f"\n{'workload':8}  {'implementation':{width}}  cores      seconds    ratio")
    for row in rows:
        print(f"{row[0]:8}  {row[1]:{width}}  {row[2]:5}  {row[3]:11.6f}  {row[4]:7.2g}  {row[5]}")
    for remark in remarks:
        print(f"  {remark}")
    print(f"\nin {write(rows)}")


main()
