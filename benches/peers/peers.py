"""The Python peers as a contestant: heyoka, SciPy and MuJoCo, as many of them as can be imported.

The lines in which it speaks are those of `benches/speed/contest.rs`. Each solver fills the whole grid of samples in one call of its own, so that
what Python costs is a few microseconds a run; SciPy and MuJoCo, whose loops run in Python, pay it at every step.
"""

import json
import sys
import time
from pathlib import Path

import numpy as np

DATA = Path(__file__).resolve().parents[2] / "tests" / "data"
SLICE = 0.004


class Problem:
    """A problem and its reference, as in `benches/speed/problems.rs`."""

    def __init__(self, name, file, turning=False):
        data = json.loads((DATA / file).read_text())
        self.name, self.turning = name, turning
        self.start = np.array(data["y0"])
        self.times = np.arange(data["n"] + 1) * data["dt"]
        self.dt = data["dt"]
        self.index = np.array(data.get("index", range(data["n"] + 1)))
        self.high, self.low = np.array(data["grid_hi"]), np.array(data["grid_lo"])

    def error(self, samples):
        if samples.shape != (len(self.times), len(self.start)) or not np.isfinite(samples).all():
            return float("nan")
        found = samples[self.index]
        if not self.turning:
            return float(np.abs((found - self.high) - self.low).max())
        omega = np.linalg.norm((found[:, :3] - self.high[:, :3]) - self.low[:, :3], axis=1)
        a, b, c, d = self.high[:, 3:].T
        sign = np.where((self.high[:, 3:] * found[:, 3:]).sum(axis=1) < 0, -1.0, 1.0)[:, None]
        e, f, g, h = ((sign * found[:, 3:] - self.high[:, 3:]) - self.low[:, 3:]).T
        vector = [a * f - b * e - c * h + d * g, a * g + b * h - c * e - d * f, a * h - b * g + c * f - d * e]
        angle = 2 * np.arctan2(np.sqrt(sum(v * v for v in vector)), 1 + a * e + b * f + c * g + d * h)
        return float(max(omega.max(), angle.max()))


PROBLEMS = {
    problem.name: problem
    for problem in (
        Problem("washer", "two-hundred-turns.json"),
        Problem("ramp", "through-resonance.json"),
        Problem("hoop", "thousand-periods.json", turning=True),
        Problem("separatrix", "near-separatrix.json", turning=True),
        Problem("disk", "rolling-two-hundred.json"),
        Problem("rest", "rolling-to-rest.json"),
        Problem("toss", "tossed-coin.json", turning=True),
        Problem("station", "struck-station.json", turning=True),
        Problem("drag", "spun-down.json"),
        Problem("top", "thousand-nods.json", turning=True),
    )
}


def rates(name, t, y, sin, cos):
    """The right-hand side as a list, for numbers and for heyoka's expressions."""
    if name in ("washer", "ramp"):
        x, yy, vx, vy = y
        if name == "washer":
            fx, fy = 9.0 * cos(3.0 * t), 9.0 * sin(3.0 * t)
        else:
            spin = 0.01 * t
            angle = 0.5 * spin * t
            fx = spin * spin * cos(angle) + 0.01 * sin(angle)
            fy = spin * spin * sin(angle) - 0.01 * cos(angle)
        return [vx, vy, fx - x - 0.01 * vx, fy - yy - 0.01 * vy]
    if name in ("disk", "rest"):
        beta, w1, w2, w3, psi = y[:5]
        s, c = sin(beta), cos(beta)
        o3 = w2 * c / s
        one = 0.25 * w2 * o3 - 1.5 * w2 * w3 - c
        two = 0.5 * w1 * w3 - 0.25 * w1 * o3
        if name == "rest":
            drag = 1e-5 / (s * s * s)
            one, two = one - drag * w1, two - drag * w2
        return [w1, one / 1.25, two / 0.25, w1 * w2 / 1.5, w2 / s, (o3 - w3) * cos(psi), (o3 - w3) * sin(psi), w3 - o3]
    w1, w2, w3 = y[:3]
    if name == "drag":
        return [-w2 * w3 - 4e-4 * w1, w3 * w1 - 4e-4 * w2, -2e-4 * w3]
    q0, q1, q2, q3 = y[3:]
    if name == "top":
        euler = [0.5 * w2 * w3 + 2.0 * (q2 * q3 + q0 * q1), -0.5 * w3 * w1 - 2.0 * (q1 * q3 - q0 * q2), 0.0 * w1]
    else:
        euler = [-w2 * w3, w3 * w1, 0.5 * w1 * w2 if name in ("hoop", "separatrix") else 0.0 * w1]
    return [
        *euler,
        -0.5 * (q1 * w1 + q2 * w2 + q3 * w3),
        0.5 * (q0 * w1 + q2 * w3 - q3 * w2),
        0.5 * (q0 * w2 + q3 * w1 - q1 * w3),
        0.5 * (q0 * w3 + q1 * w2 - q2 * w1),
    ]


def heyoka_entries():
    import heyoka as hy

    def entry(problem, tolerance, mode):
        solver = None  # compiled at the first run, which is not timed

        def solve():
            nonlocal solver
            if solver is None:
                names = hy.make_vars(*(f"y{i}" for i in range(len(problem.start))))
                right = rates(problem.name, hy.time, names, hy.sin, hy.cos)
                solver = hy.taylor_adaptive(list(zip(names, right)), problem.start, tol=tolerance, **mode)
            solver.time = 0.0
            solver.state[:] = problem.start
            return solver.propagate_grid(problem.times)[-1]

        return solve

    modes = {"": {}, " with fast_math": {"fast_math": True}, " with high_accuracy": {"high_accuracy": True}}
    for problem in PROBLEMS.values():
        for exponent in (3, 5, 7, 9, 11, 13, 16):
            tolerance = 2.220446049250313e-16 if exponent == 16 else float(f"1e-{exponent}")
            for words, mode in modes.items():
                setting = ("tolerance 2.2e-16" if exponent == 16 else f"tolerance 1e-{exponent}") + words
                yield problem, "heyoka", "Taylor", setting, entry(problem, tolerance, mode)


def scipy_entries():
    from math import cos, sin

    from scipy.integrate import solve_ivp

    def entry(problem, tolerance):
        def solve():
            right = lambda t, y: rates(problem.name, t, y.tolist(), sin, cos)
            end = problem.times[-1]
            found = solve_ivp(right, (0.0, end), problem.start, "DOP853", problem.times, rtol=tolerance, atol=tolerance)
            return found.y.T

        return solve

    for problem in PROBLEMS.values():
        for exponent in (4, 7, 10, 13):
            yield problem, "scipy", "DOP853", f"tolerance 1e-{exponent}", entry(problem, float(f"1e-{exponent}"))


def mujoco_entries():
    import mujoco

    problem = PROBLEMS["hoop"]

    def entry(steps):
        # A ball joint at the pin; the moments are those about the pin. RK4, no contacts, no gravity.
        model = mujoco.MjModel.from_xml_string(
            f"""<mujoco><option integrator="RK4" timestep="{problem.dt / steps!r}" gravity="0 0 0">
            <flag contact="disable" constraint="disable"/></option>
            <worldbody><body><joint type="ball"/>
            <inertial pos="0 0 0" mass="1" diaginertia="1.5 0.5 2"/></body></worldbody></mujoco>"""
        )
        data = mujoco.MjData(model)

        def solve():
            mujoco.mj_resetData(model, data)
            data.qvel[:] = problem.start[:3]
            data.qpos[:] = problem.start[3:]
            samples = np.empty((len(problem.times), 7))
            samples[0] = problem.start
            for sample in samples[1:]:
                mujoco.mj_step(model, data, steps)
                sample[:3], sample[3:] = data.qvel, data.qpos
            return samples

        return solve

    for steps in (100, 400, 1600):
        yield problem, "mujoco", "engine with RK4", f"{steps} steps a sample", entry(steps)


def contestants():
    entries, versions, notes = [], [], []
    for name, make in (("heyoka", heyoka_entries), ("scipy", scipy_entries), ("mujoco", mujoco_entries)):
        try:
            found = list(make())
            module = __import__(name)
        except ImportError:
            notes.append(("all", name, "not installed"))
            continue
        entries += found
        versions.append((name, module.__version__))
    versions += [("numpy", np.__version__), ("python", sys.version.split()[0])]
    notes.append(("all", "scipy", "its loop runs in Python and calls rates written in Python"))
    return entries, versions, notes


def measure(problem, solve):
    runs, began = 0, time.perf_counter()
    while runs == 0 or time.perf_counter() - began < SLICE:
        samples = solve()
        runs += 1
    seconds = (time.perf_counter() - began) / runs
    return problem.error(samples), seconds


def main():
    entries, versions, notes = contestants()
    warm = set()
    for line in sys.stdin:
        line = line.strip()
        if line == "list":
            for name, version in versions:
                print(f"version\t{name}\t{version}")
            for note in notes:
                print("note\t" + "\t".join(note))
            for problem, contestant, method, setting, _ in entries:
                print(f"entry\t{problem.name}\t{contestant}\t{method}\t{setting}")
            print("end")
        else:
            try:
                number = int(line.removeprefix("run "))
                problem, _, _, _, solve = entries[number]
                if number not in warm:
                    solve()  # compiles
                    warm.add(number)
                error, seconds = measure(problem, solve)
                print(f"{error:e}\t-\t{seconds:e}")
            except Exception as cause:  # whatever a peer raises, the contest goes on
                print("failed\t" + str(cause).replace("\n", " ").replace("\t", " "))
        sys.stdout.flush()


if __name__ == "__main__":
    main()
