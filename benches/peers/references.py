"""Makes the reference values of the report that are computed here, each by two routes that must agree.

    python benches/peers/references.py tests/data

Route one is a Taylor integrator with 170-bit numbers (heyoka). Route two is a closed form with 50 digits (mpmath), or, where
there is none, the same integrator with 230 bits and the constants of the motion. What is solved is the exact problem: initial values, parameters
and the time between samples are doubles, the time of sample i is the double nearest to i * dt.
"""

import json
import sys
from pathlib import Path

import heyoka as hy
import mpmath as mp
import numpy as np

mp.mp.dps = 50
BITS = 170


def integrate(equations, start, times, bits):
    """States at the given times, as lists of mpf."""
    real = lambda x: hy.real(x, bits)
    solver = hy.taylor_adaptive(
        equations, [real(x) for x in start], time=real(0.0), fp_type=hy.real, prec=bits, compact_mode=True
    )
    rows = []
    for t in times:
        solver.propagate_until(real(t))
        rows.append([mp.mpf(str(x)) for x in solver.state])
    return rows


def difference(rows, others):
    """The largest difference of two lists of states."""
    assert len(rows) == len(others) > 0
    return max(abs(a - b) for row, other in zip(rows, others) for a, b in zip(row, other))


def write(folder, file, title, origin, start, samples, dt, index, rows, parameters):
    hi = [[float(x) for x in row] for row in rows]
    lo = [[float(f"{float(x - mp.mpf(h)):.3e}") for x, h in zip(row, head)] for row, head in zip(rows, hi)]
    data = {
        "title": title,
        "origin": origin,
        "par": parameters,
        "y0": start,
        "n": samples,
        "dt": dt,
        "index": index,
        "grid_hi": hi,
        "grid_lo": lo,
    }
    text = json.dumps(data).replace('"grid_', '\n"grid_').replace("], [", "],\n[")
    (folder / file).write_text(text + "\n")
    print(f"{file}: {len(rows)} of {samples + 1} samples, {len(text)} bytes")


def grid(dt, samples, every):
    index = sorted({*range(0, samples + 1, every), samples})
    return index, [float(i) * dt for i in index]


# A2: the washing machine through resonance. ----------------------------------------------------------------------------

def ramp(folder):
    offset, damping, alpha = 1.0, 0.01, 0.01
    x, y, vx, vy = hy.make_vars("x", "y", "vx", "vy")
    t = hy.time
    angle, rate = hy.par[0] * t * t / 2.0, hy.par[0] * t
    cos, sin = hy.cos(angle), hy.sin(angle)
    # The parameters are doubles; as hy.real they stay exactly those.
    exact = lambda value: hy.expression(hy.real(value, 400))
    equations = [
        (x, vx),
        (y, vy),
        (vx, rate * rate * cos + exact(alpha) * sin - x - exact(damping) * vx),
        (vy, rate * rate * sin - exact(alpha) * cos - y - exact(damping) * vy),
    ]
    equations = [(v, hy.subs(e, {hy.par[0]: exact(alpha)})) for v, e in equations]
    index, times = grid(2.0, 200, 2)
    rows = integrate(equations, [0.0] * 4, times, BITS)

    # z'' + Γz' + z = −b (e^{iφ})'': by the Green's function, b[−g + Σ ± λ²/(λ₁ − λ₂) ∫ e^{λ(t−s)} g(s) ds] and the start at rest,
    # with the Fresnel integral ∫₀ᵗ e^{−λs + iαs²/2} ds by erfc.
    b, gamma, a = mp.mpf(offset), mp.mpf(damping), mp.mpf(alpha)
    root = mp.sqrt(gamma * gamma / 4 - 1)
    roots = [-gamma / 2 + root, -gamma / 2 - root]

    def closed(time):
        time = mp.mpf(time)
        g = mp.e ** (1j * a * time * time / 2)

        def integral(rate):
            # −λs + iαs²/2 = (iα/2)(s + iλ/α)² + iλ²/(2α)
            c = mp.sqrt(-1j * a / 2)
            shift = 1j * rate / a
            area = mp.sqrt(mp.pi) / (2 * c) * (mp.erfc(c * shift) - mp.erfc(c * (time + shift)))
            return mp.e ** (rate * time + 1j * rate * rate / (2 * a)) * area

        # u = z + b g obeys u'' + Γu' + u = b(Γ g' + g), u(0) = b, u'(0) = 0. With g' integrated by parts,
        # ∫ e^{λ(t−s)} g' ds = g(t) − e^{λt} + λ ∫ e^{λ(t−s)} g ds.
        (l1, l2), gap = roots, roots[0] - roots[1]
        u = u_rate = mp.mpc(0)
        for rate, other, sign in ((l1, l2, 1), (l2, l1, -1)):
            homogeneous = -other * b * mp.e ** (rate * time)
            i = integral(rate)
            forced = b * (gamma * (g - mp.e ** (rate * time) + rate * i) + i)
            u += sign * (homogeneous + forced) / gap
            u_rate += sign * rate * (homogeneous + forced) / gap
        z, z_rate = u - b * g, u_rate - b * 1j * a * time * g
        return [z.real, z.imag, z_rate.real, z_rate.imag]

    mp.mp.dps = 70
    worst = difference(rows, [closed(time) for time in times])
    mp.mp.dps = 50
    print("ramp: Taylor against erfc", mp.nstr(worst, 3))
    assert worst < 1e-38
    write(folder, "through-resonance.json", "Washing machine that speeds up from rest through resonance: x, y, vx, vy of the shaft",
          "Taylor series, 170 bits; closed form by erfc, 70 digits", [0.0] * 4, 200, 2.0, index, rows,
          {"omega_0": 1.0, "b": offset, "Gamma": damping, "alpha": alpha})


# Bodies that turn: omega along the body's axes, then the quaternion, scalar first, body to space. ------------------------

def body(moments, drag=0.0):
    names = hy.make_vars("w1", "w2", "w3", "q0", "q1", "q2", "q3")
    w1, w2, w3, q0, q1, q2, q3 = names
    exact = lambda value: hy.expression(hy.real(value, 400))
    i1, i2, i3 = (exact(m) for m in moments)
    c = exact(drag)
    euler = [
        (w1, ((i2 - i3) * w2 * w3 - c * w1) / i1),
        (w2, ((i3 - i1) * w3 * w1 - c * w2) / i2),
        (w3, ((i1 - i2) * w1 * w2 - c * w3) / i3),
    ]
    attitude = [
        (q0, -0.5 * (q1 * w1 + q2 * w2 + q3 * w3)),
        (q1, 0.5 * (q0 * w1 + q2 * w3 - q3 * w2)),
        (q2, 0.5 * (q0 * w2 + q3 * w1 - q1 * w3)),
        (q3, 0.5 * (q0 * w3 + q1 * w2 - q2 * w1)),
    ]
    return euler, attitude


def in_space(q, v):
    q0, q1, q2, q3 = q
    return [
        (q0**2 + q1**2 - q2**2 - q3**2) * v[0] + 2 * (q1 * q2 - q0 * q3) * v[1] + 2 * (q1 * q3 + q0 * q2) * v[2],
        2 * (q1 * q2 + q0 * q3) * v[0] + (q0**2 - q1**2 + q2**2 - q3**2) * v[1] + 2 * (q2 * q3 - q0 * q1) * v[2],
        2 * (q1 * q3 - q0 * q2) * v[0] + 2 * (q2 * q3 + q0 * q1) * v[1] + (q0**2 - q1**2 - q2**2 + q3**2) * v[2],
    ]


def separatrix(folder):
    moments = [1.5, 0.5, 2.0]
    angle = mp.radians(mp.mpf("89.999"))
    omega = [float(mp.sin(angle) / 3), float(-mp.cos(angle)), 0.0]
    start = omega + [1.0, 0.0, 0.0, 0.0]
    # Axis 1 is the middle one. ω₃ starts at zero, where ω₁ is largest and ω₂ smallest: a quarter period after the usual start.
    i1, i2, i3 = (mp.mpf(m) for m in moments)
    w1, w2, _ = (mp.mpf(w) for w in omega)
    inertia = i2 * w2**2 * (i2 - i1)
    assert inertia < 0  # the momentum circles axis 2, and ω₁ = ω₁(0) cd, ω₂ = ω₂(0) nd, ω₃ is a multiple of sd
    energy2 = i1 * w1**2 + i2 * w2**2
    momentum2 = i1**2 * w1**2 + i2**2 * w2**2
    p = mp.sqrt((i1 - i2) * (i3 * energy2 - momentum2) / (i1 * i2 * i3))
    m = (i3 - i1) * (momentum2 - i2 * energy2) / ((i1 - i2) * (i3 * energy2 - momentum2))
    period = 4 * mp.ellipk(m) / p
    dt = float(mp.mpf("1.00037") * period)
    index, times = grid(dt, 1000, 8)
    euler, attitude = body(moments)
    rows = integrate(euler + attitude, start, times, BITS)

    def closed(time):
        u = p * mp.mpf(time)
        sn, cn, dn = (mp.ellipfun(kind, u, m=m) for kind in ("sn", "cn", "dn"))
        # ω₃' = (I₁ − I₂)/I₃ ω₁ω₂ at the start fixes the sign of ω₃, its size by the energy.
        slope = (i1 - i2) / i3 * w1 * w2
        return [w1 * cn / dn, w2 / dn, slope / p * sn / dn]

    mp.mp.dps = 70
    worst = difference([row[:3] for row in rows], [closed(time) for time in times])
    mp.mp.dps = 50
    print("separatrix: omega, Taylor against Jacobi", mp.nstr(worst, 3))
    assert worst < 1e-30
    momentum = [[*in_space(row[3:], [i * w for i, w in zip((i1, i2, i3), row[:3])])] for row in rows]
    worst = difference(momentum, [[i1 * w1, i2 * w2, mp.mpf(0)]] * len(rows))
    print("separatrix: angular momentum in space", mp.nstr(worst, 3))
    assert worst < 1e-30
    sharper = integrate(euler + attitude, start, times, 230)
    worst = difference(rows, sharper)
    print("separatrix: 170 against 230 bits", mp.nstr(worst, 3))
    assert worst < 1e-30
    write(folder, "near-separatrix.json", "Hoop pinned at 89.999 degrees: omega along the body's axes, quaternion (scalar first, body to space)",
          "Taylor series, 170 bits; omega by Jacobi's functions, 70 digits; attitude by 230 bits and the momentum in space",
          start, 1000, dt, index, rows, {"moments": moments, "theta_deg": 89.999, "period": mp.nstr(period, 34)})


def symmetric(folder, file, title, moments, omega):
    i1, _, i3 = (mp.mpf(m) for m in moments)
    w1, _, w3 = (mp.mpf(w) for w in omega)
    momentum = [i1 * w1, mp.mpf(0), i3 * w3]
    length = mp.sqrt(sum(x * x for x in momentum))
    dt = float(mp.mpf("1.00037") * 2 * mp.pi * i1 / length)
    index, times = grid(dt, 1000, 25)
    euler, attitude = body(moments)
    start = [*omega, 1.0, 0.0, 0.0, 0.0]
    rows = integrate(euler + attitude, start, times, BITS)

    def closed(time):
        # A turn with L/I₁ about the fixed momentum, then one with ω₃(I₁ − I₃)/I₁ about the body's axis.
        time = mp.mpf(time)
        half, own = length / i1 * time / 2, w3 * (i1 - i3) / i1 * time / 2
        s, c = mp.sin(half), mp.cos(half)
        a = [c, *(s * x / length for x in momentum)]
        so, co = mp.sin(own), mp.cos(own)
        q = [a[0] * co - a[3] * so, a[1] * co + a[2] * so, a[2] * co - a[1] * so, a[3] * co + a[0] * so]
        turn = 2 * own
        return [w1 * mp.cos(turn), -w1 * mp.sin(turn), w3, *q]

    worst = difference(rows, [closed(time) for time in times])
    print(f"{file}: Taylor against closed form", mp.nstr(worst, 3))
    assert worst < 1e-38
    write(folder, file, title, "Taylor series, 170 bits; two turns in closed form, 50 digits", start, 1000, dt, index, rows,
          {"moments": moments})


def air_drag(folder):
    moments, omega, drag = [0.25, 0.25, 0.5], [0.5, 0.0, 1.0], 1e-4
    i1, _, i3 = (mp.mpf(m) for m in moments)
    c = mp.mpf(drag)
    index, times = grid(10.0, 1000, 25)
    euler, _ = body(moments, drag)
    rows = integrate(euler, omega, times, BITS)

    def closed(time):
        time = mp.mpf(time)
        along = c / i3
        turn = mp.mpf(omega[2]) * (i3 - i1) / i1 * (1 - mp.e ** (-along * time)) / along
        across = mp.mpf(omega[0]) * mp.e ** (-c / i1 * time)
        return [across * mp.cos(turn), across * mp.sin(turn), mp.mpf(omega[2]) * mp.e ** (-along * time)]

    worst = difference(rows, [closed(time) for time in times])
    print("air drag: Taylor against closed form", mp.nstr(worst, 3))
    assert worst < 1e-38
    write(folder, "spun-down.json", "Disc that spins down in air: omega along the body's axes",
          "Taylor series, 170 bits; closed form, 50 digits", omega, 1000, 10.0, index, rows,
          {"moments": moments, "drag": drag})


def top(folder):
    # A symmetric body on a point of its axis 3, with the moments about that point; its weight's torque is mgl = 1 with a level axis. It
    # starts level, where the quaternion is exact, in the midst of a nod with loops.
    moments, weight = [1.0, 1.0, 0.5], 1.0
    omega, attitude_0 = [0.75, 0.25, 4.0], [0.5, 0.5, 0.5, 0.5]
    start = omega + attitude_0
    q0, q1, q2, q3 = hy.make_vars("q0", "q1", "q2", "q3")
    (first, second, third), attitude = body(moments)
    # The vertical in the body, across the axis, times 2mgl/I₁; I₁ is one.
    euler = [
        (first[0], first[1] + 2.0 * weight * (q2 * q3 + q0 * q1)),
        (second[0], second[1] - 2.0 * weight * (q1 * q3 - q0 * q2)),
        third,
    ]

    # With u = cos θ, in Euler's angles z-x-z, u'² = (α − βu)(1 − u²) − (b − au)² = β(u − u₁)(u − u₂)(u − u₃), and at the start
    # φ = π/2, ψ = 0, θ' = ω₁, φ' = ω₂.
    mp.mp.dps = 70
    i1, _, i3 = (mp.mpf(m) for m in moments)
    fall, b, spin = (mp.mpf(w) for w in omega)
    a, beta, alpha = i3 * spin / i1, 2 * weight / i1, fall**2 + b**2
    u1, u2, u3 = sorted(mp.polyroots([beta, -alpha - a * a, 2 * a * b - beta, alpha - b * b], maxsteps=200, extraprec=400))
    assert -1 < u1 < u2 < 1 < u3 and b - a * u1 > 0 > b - a * u2  # φ' has both signs: loops
    m, kappa = (u2 - u1) / (u3 - u1), mp.sqrt(beta * (u3 - u1)) / 2
    half = mp.ellipk(m)
    nod = 2 * half / kappa
    dt = float(mp.mpf("1.00037") * nod)
    index, times = grid(dt, 1000, 25)
    rows = integrate(euler + attitude, start, times, BITS)

    def halves(x):
        # ∫ (b + a)/2(1 + u) dt and ∫ (b − a)/2(1 − u) dt from the lowest point, where u = u₁ + (u₂ − u₁) sin² x.
        below = (b + a) / (1 + u1) * mp.ellippi((u1 - u2) / (1 + u1), x, m)
        above = (b - a) / (1 - u1) * mp.ellippi((u2 - u1) / (1 - u1), x, m)
        return below / (2 * kappa), above / (2 * kappa)

    x_0 = -mp.asin(mp.sqrt(-u1 / (u2 - u1)))  # it falls towards x = 0
    u_0, halves_0 = mp.ellipf(x_0, m), halves(x_0)

    def closed(time):
        time = mp.mpf(time)
        argument = kappa * time + u_0
        nods = mp.nint(argument / (2 * half))
        sn, cn, dn = (mp.ellipfun(kind, argument - 2 * nods * half, m=m) for kind in ("sn", "cn", "dn"))
        below, above = (now - then for now, then in zip(halves(mp.asin(sn) + nods * mp.pi), halves_0))
        u, rise = u1 + (u2 - u1) * sn**2, 2 * (u2 - u1) * kappa * sn * cn * dn
        # φ' = (b − au)/(1 − u²) and ψ' = ω₃ − uφ' in partial fractions.
        phi, psi = mp.pi / 2 + below + above, (spin - a) * time + below - above
        sine, theta = mp.sqrt(1 - u * u), mp.acos(u)
        tilting, across = -rise / sine, (b - a * u) / sine
        c, s = mp.cos(theta / 2), mp.sin(theta / 2)
        plus, minus = (phi + psi) / 2, (phi - psi) / 2
        return [tilting * mp.cos(psi) + across * mp.sin(psi), across * mp.cos(psi) - tilting * mp.sin(psi), spin,
                c * mp.cos(plus), s * mp.cos(minus), s * mp.sin(minus), c * mp.sin(plus)]

    worst = difference(rows, [closed(time) for time in times])
    mp.mp.dps = 50
    print("top: Taylor against Jacobi and Legendre", mp.nstr(worst, 3))
    assert worst < 1e-38
    write(folder, "thousand-nods.json", "Top under its weight that draws loops: omega along the body's axes, quaternion (scalar first, body to space)",
          "Taylor series, 170 bits; Jacobi's functions and Legendre's integrals, 70 digits", start, 1000, dt, index, rows,
          {"moments": moments, "mgl": weight, "nod": mp.nstr(nod, 34)})


# D: Euler's disk, with the film of air. ---------------------------------------------------------------------------------

STEP = 1.734375  # 111/64; after 200 of them the tilt is about a tenth of the 0.3 it starts with


def disk(folder):
    a, c, film, tilt = 0.25, 0.5, 1e-5, 0.3
    beta, w1, w2, w3, psi, x, y, phi = hy.make_vars("beta", "w1", "w2", "w3", "psi", "x", "y", "phi")
    exact = lambda value: hy.expression(hy.real(value, 400))
    sin, cos = hy.sin(beta), hy.cos(beta)
    o3 = w2 * cos / sin
    drag = exact(film) / (sin * sin * sin)
    equations = [
        (beta, w1),
        (w1, (a * w2 * o3 - (c + 1) * w2 * w3 - cos - drag * w1) / (a + 1)),
        (w2, (c * w1 * w3 - a * w1 * o3 - drag * w2) / a),
        (w3, w1 * w2 / (c + 1)),
        (psi, w2 / sin),
        (x, (o3 - w3) * hy.cos(psi)),
        (y, (o3 - w3) * hy.sin(psi)),
        (phi, w3 - o3),
    ]
    s = mp.sin(mp.mpf(tilt))
    start = [tilt, 0.0, float(s * mp.sqrt(4 / s)), 0.0, 0.0, 0.0, 0.0, 0.0]
    dt = STEP
    index, times = grid(dt, 200, 2)
    rows = integrate(equations, start, times, BITS)
    worst = difference(rows, integrate(equations, start, times, 230))
    print("disk: 170 against 230 bits", mp.nstr(worst, 3), "tilt at the end", mp.nstr(rows[-1][0], 5))
    assert worst < 1e-30

    # The power of the film is all that is lost: E' = −K (w1² + w2²)/sin³β, by differences of E against Simpson's rule on a fine grid.
    fine = [times[3] + k * mp.mpf(2) ** -11 for k in range(-2, 3)]
    near = integrate(equations, start, [float(t) for t in fine], BITS)

    def energy(row):
        b, u1, u2, u3 = row[:4]
        return ((a + 1) * u1**2 + a * u2**2 + (c + 1) * u3**2) / 2 + mp.sin(b)

    def power(row):
        return -mp.mpf(film) * (row[1] ** 2 + row[2] ** 2) / mp.sin(row[0]) ** 3

    lost = energy(near[-1]) - energy(near[0])
    step = mp.mpf(2) ** -11
    simpson = step / 3 * (power(near[0]) + 4 * power(near[1]) + 2 * power(near[2]) + 4 * power(near[3]) + power(near[4]))
    print("disk: energy lost against the film's power, relative", mp.nstr(abs(lost / simpson - 1), 3))
    assert abs(lost / simpson - 1) < 1e-9
    write(folder, "rolling-to-rest.json", "Disk that rolls to rest under a film of air: beta, w1, w2, w3, psi, x, y, phi",
          "Taylor series, 170 bits; the same with 230 bits; the loss of energy", start, 200, dt, index, rows,
          {"A": a, "C": c, "m": 1.0, "a": 1.0, "g": 1.0, "K": film})


if __name__ == "__main__":
    folder = Path(sys.argv[1])
    chosen = sys.argv[2:]
    tasks = {
        "ramp": lambda: ramp(folder),
        "toss": lambda: symmetric(folder, "tossed-coin.json",
            "Tossed coin: omega along the body's axes, quaternion (scalar first, body to space)", [0.25, 0.25, 0.5], [3.0, 0.0, 1.0]),
        "station": lambda: symmetric(folder, "struck-station.json",
            "Struck ring: omega along the body's axes, quaternion (scalar first, body to space)", [0.5, 0.5, 1.0], [0.1, 0.0, 1.0]),
        "drag": lambda: air_drag(folder),
        "top": lambda: top(folder),
        "disk": lambda: disk(folder),
        "separatrix": lambda: separatrix(folder),
    }
    for name, task in tasks.items():
        if not chosen or name in chosen:
            task()
