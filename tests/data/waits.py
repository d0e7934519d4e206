"""Writes waits.json: when a pinned hoop and a pinned disc first lose their rotation about the tangent.

Euler's equations about the pin, by Taylor series of order 60 with 60 digits; no elliptic function is used. The time is
found where the last series vanishes, by Newton's method.
"""
import json
from mpmath import mp, mpf, sqrt

mp.dps = 60
ORDER = 60
# Moments about the pin in units of m a², and the part of the rotation about the tangent that survives.
BODIES = {
    "hoop": ([mpf(3) / 2, mpf(1) / 2, mpf(2)], mpf(1) / 3),
    "disc": ([mpf(5) / 4, mpf(1) / 4, mpf(3) / 2], mpf(1) / 5),
}


def series(moments, start):
    """Coefficients of the three components of the angular velocity about one time."""
    i1, i2, i3 = moments
    factors = [(i2 - i3) / i1, (i3 - i1) / i2, (i1 - i2) / i3]
    w = [[value] for value in start]
    for n in range(ORDER):
        for axis, factor in enumerate(factors):
            a, b = w[(axis + 1) % 3], w[(axis + 2) % 3]
            product = sum(a[k] * b[n - k] for k in range(n + 1))
            w[axis].append(factor * product / (n + 1))
    return w


def value(coefficients, time):
    total = mpf(0)
    for coefficient in reversed(coefficients):
        total = total * time + coefficient
    return total


def wait(body, cosine):
    moments, survival = BODIES[body]
    state = [survival * sqrt(1 - cosine**2), -cosine, mpf(0)]
    time, step = mpf(0), mpf(1) / 4
    while True:
        w = series(moments, state)
        after = [value(c, step) for c in w]
        if after[0] <= 0:
            slope = [n * c for n, c in enumerate(w[0])][1:]
            left = step / 2
            for _ in range(12):
                left -= value(w[0], left) / value(slope, left)
            return time + left
        state, time = after, time + step


rows = []
for body in BODIES:
    for cosine in [0.5, 0.1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 1e-16, 1e-18, 1e-20]:
        # The cosine is the number that a program reads, bit for bit.
        found = wait(body, mpf(cosine))
        rows.append({"body": body, "cosine": cosine, "wait": mp.nstr(found, 32)})
with open("waits.json", "w") as file:
    json.dump({
        "title": "Time from the snap to the first tumble, in units of one over the spin before it",
        "origin": "waits.py: Taylor series of Euler's equations, order 60, 60 digits",
        "cases": rows,
    }, file, indent=1)
    file.write("\n")
