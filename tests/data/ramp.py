"""Writes ramp.json: a drum that speeds up, at times too far away for an integrator. mpmath 1.3, 70 digits.

z = -b (g + (l1^2 P1 - l2^2 P2)/(l1 - l2)) + free motion, with P the integral of e^{l (t - s)} e^{i phi(s)} from the start, as a
difference of error functions; where it can be afforded, checked against quadrature of the force with Green's function.
"""
import json, random
import mpmath as mp

mp.mp.dps = 70
I = mp.mpc(0, 1)


def through(root, spin, alpha, t):
    """The integral of e^{root (t - s)} e^{i phi(s)} over s from 0 to t."""
    scale = mp.sqrt(alpha / 2) * mp.e ** (-I * mp.pi / 4)
    kappa = mp.sqrt(mp.pi / (2 * alpha)) * mp.e ** (I * mp.pi / 4)
    z0, z1 = [scale * (s + (spin + I * root) / alpha) for s in (0, t)]
    # e^{root t + i phi} times erfc: large and small factors are put together before they meet.
    e0, e1 = root * t, I * (spin * t + alpha * t * t / 2)  # exponents of what starts at 0 and at t

    def scaled(z, exponent):  # e^{exponent} e^{z^2} erfc(z), for Re z >= 0
        if abs(z) > 12:
            term, total = mp.mpf(1), mp.mpf(0)
            for n in range(1, 400):
                total += term
                new = -term * (2 * n - 1) / (2 * z * z)
                if abs(new) < mp.mpf(10) ** -(mp.mp.dps + 5) or abs(new) > abs(term):
                    break
                term = new
            if abs(z) > 14:
                return mp.e ** exponent * total / (z * mp.sqrt(mp.pi))
        return mp.e ** exponent * mp.e ** (z * z) * mp.erfc(z)

    # The integral is kappa e^{e0 + z0^2} (erf z1 - erf z0), and e0 + z0^2 = e1 + z1^2.
    if z0.real >= 0 and z1.real >= 0:
        return kappa * (scaled(z0, e0) - scaled(z1, e1))
    if z0.real < 0 and z1.real < 0:
        return kappa * (scaled(-z1, e1) - scaled(-z0, e0))
    sign = 1 if z0.real < 0 else -1
    whole = 2 * mp.e ** (e0 + z0 * z0)
    a, b = (scaled(-z0, e0), scaled(z1, e1)) if sign > 0 else (scaled(z0, e0), scaled(-z1, e1))
    return sign * kappa * (whole - a - b)


def motion(damping, spin, alpha, start, t):
    if alpha < 0:
        z, v, free = motion(damping, -spin, -alpha, [start[0], -start[1], start[2], -start[3]], t)
        return mp.conj(z), mp.conj(v), free
    gap = mp.sqrt(mp.mpc(damping * damping / 4 - 1))
    if gap == 0:
        gap = mp.mpf(10) ** -25
    roots = [-damping / 2 + gap, -damping / 2 - gap]
    basis = lambda power: sum(s * l ** power * mp.e ** (l * t) for s, l in zip((1, -1), roots)) / (2 * gap)
    place, rate = basis(1) + damping * basis(0), basis(0)
    place_rate, rate_rate = -basis(0), basis(1)
    z0, v0 = mp.mpc(*start[:2]) + 1, mp.mpc(*start[2:]) + (I * spin - damping)
    p = [through(l, spin, alpha, t) for l in roots]
    g = mp.e ** (I * (spin * t + alpha * t * t / 2))
    forced = [sum(s * l ** n * q for s, l, q in zip((1, -1), roots, p)) / (2 * gap) for n in (2, 3)]
    z = z0 * place + v0 * rate - g - forced[0]
    v = z0 * place_rate + v0 * rate_rate - g * (I * (spin + alpha * t) - damping) - forced[1]
    return z, v, [abs(place), abs(place_rate), abs(rate), abs(rate_rate)]


def by_quadrature(damping, spin, alpha, start, t):
    gap = mp.sqrt(mp.mpc(damping * damping / 4 - 1)) or mp.mpf(10) ** -25
    a, b = -damping / 2 + gap, -damping / 2 - gap
    green = lambda u: (mp.e ** (a * u) - mp.e ** (b * u)) / (2 * gap)
    slope = lambda u: (a * mp.e ** (a * u) - b * mp.e ** (b * u)) / (2 * gap)
    force = lambda s: ((spin + alpha * s) ** 2 - I * alpha) * mp.e ** (I * (spin * s + alpha * s * s / 2))
    pieces = int(abs(spin * t) + abs(alpha * t * t) + abs(t) + abs(damping * t)) // 2 + 4
    points = [t * k / pieces for k in range(pieces + 1)]
    z0, v0 = mp.mpc(*start[:2]), mp.mpc(*start[2:])
    return z0 * (slope(t) + damping * green(t)) + v0 * green(t) + mp.quad(lambda s: green(t - s) * force(s), points)


def main():
    random.seed(8)
    decades = lambda low, high: 10 ** random.uniform(low, high)
    cases, checked = [], 0
    while len(cases) < 240:
        damping = random.choice([0.0, decades(-12, 0), 2.0 * (1 + random.choice([-1, 1]) * decades(-15, -1)), decades(0, 3), decades(3, 15)])
        spin = random.choice([0.0, 1.0, decades(-3, 3), -decades(-3, 3), 1.0 + decades(-12, -1), 1.0 - decades(-12, -1)])
        acceleration = random.choice([-1, 1]) * decades(-12, random.choice([0, 12]))
        start = [random.uniform(-2, 2) for _ in range(4)]
        passing = (random.choice([-1, 0, 1]) - spin) / acceleration
        time = random.choice([passing, passing * random.uniform(0.3, 3), decades(-3, 6), -decades(-3, 1), 0.0])
        if not abs(time) * (abs(spin) + abs(acceleration * time)) < 1e13 or damping * -time > 300 or damping * time > 1e6:
            continue
        exact = [mp.mpf(number) for number in (damping, spin, acceleration, *start, time)]
        z, v, free = motion(*exact[:3], exact[3:7], exact[7])
        if abs(time) * (abs(spin) + abs(acceleration * time) + damping) < 60 and acceleration > 0 and checked < 40:
            away = abs(by_quadrature(*exact[:3], exact[3:7], exact[7]) - z)
            assert away < mp.mpf(10) ** -30 * (1 + abs(z)), (damping, spin, acceleration, start, time, away)
            checked += 1
        text = lambda number: mp.nstr(number, 22)
        cases.append({
            "damping": damping, "spin": spin, "acceleration": acceleration, "start": start, "time": time,
            "state": [text(part) for part in (z.real, z.imag, v.real, v.imag)],
            "free": [float(number) for number in free],
        })
    assert checked >= 20, checked
    with open(__file__.replace("ramp.py", "ramp.json"), "w") as file:
        file.write("[\n" + ",\n".join(json.dumps(case) for case in cases) + "\n]\n")


main()
