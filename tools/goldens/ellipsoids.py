#!/usr/bin/env python3
"""Goldens of ellipsoidal Gaussians, with 40 digits (mpmath): optical depths by quadrature of the
density along the segment, single scattering by quadrature over the ray. Prints JSON:

    tools/goldens/ellipsoids.py > tests/golden/ellipsoids.json
"""

import json

from mpmath import exp, matrix, mp, mpf, pi, quad, sqrt

mp.dps = 40


def rotation(q):
    """The matrix of a quaternion w x y z, of any length."""
    n = sqrt(sum(mpf(x) ** 2 for x in q))
    w, x, y, z = (mpf(c) / n for c in q)
    return matrix([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                   [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                   [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


class Ellipsoid:
    def __init__(self, gaussian):
        self.center = [mpf(c) for c in gaussian["center"]]
        self.radii = [mpf(r) for r in gaussian["radii"]]
        self.density = mpf(gaussian["density"])
        self.axes = rotation(gaussian["rotate"])

    def scaled(self, v):
        """A vector along its own axes, in radii."""
        return [sum(self.axes[row, k] * v[row] for row in range(3)) / self.radii[k]
                for k in range(3)]

    def at(self, x):
        q = self.scaled([a - b for a, b in zip(x, self.center)])
        return self.density * exp(-sum(c * c for c in q))

    def middle(self, start, w):
        """Where on a line it is densest, and how long its radius is there."""
        q = self.scaled([a - b for a, b in zip(start, self.center)])
        v = self.scaled(w)
        square = sum(c * c for c in v)
        return -sum(a * b for a, b in zip(q, v)) / square, 1 / sqrt(square)


def line(a, b):
    d = [mpf(y) - mpf(x) for x, y in zip(a, b)]
    length = sqrt(sum(c * c for c in d))
    return [mpf(c) for c in a], [c / length for c in d], length


def pieces(places, length):
    inside = sorted(p for p in places if 0 < p < length)
    return [mpf(0), *inside, length]


def depth(gaussians, start, w, length):
    total = mpf(0)
    for g in gaussians:
        t, r = g.middle(start, w)
        places = pieces([t + k * r for k in (-8, -4, -2, -1, 0, 1, 2, 4, 8)], length)
        total += quad(lambda s: g.at([a + s * b for a, b in zip(start, w)]), places)
    return total


def airlight(gaussians, eye, target, light):
    """Of an isotropic light of radiant intensity 1, without surfaces."""
    start, w, length = line(eye, target)
    source = [mpf(c) for c in light]

    def scattered(t):
        x = [a + t * b for a, b in zip(start, w)]
        density = sum(g.at(x) for g in gaussians)
        if density < mpf(10) ** -30:
            return mpf(0)
        from_light, direction, distance = line(source, x)
        extinct = depth(gaussians, start, w, t) + depth(gaussians, from_light, direction, distance)
        return density * exp(-extinct) / (4 * pi * distance * distance)

    places = []
    for g in gaussians:
        t, r = g.middle(start, w)
        places += [t + k * r for k in (-6, -3, -1, 0, 1, 3, 6)]
    foot = sum((s - a) * b for s, a, b in zip(source, start, w))
    return quad(scattered, pieces([*places, foot], length))


NEEDLE = {"center": [0.1, -0.2, 0.05], "radii": [0.001, 1.0, 0.001], "density": 40.0,
          "rotate": [0.8, 0.3, -0.4, 0.2]}
DISC = {"center": [0.3, 0.1, -0.2], "radii": [0.9, 0.002, 0.7], "density": 25.0,
        "rotate": [0.5, -0.1, 0.6, 0.4]}
EGG = {"center": [0.0, 0.2, 0.1], "radii": [0.5, 0.8, 0.3], "density": 1.7,
       "rotate": [0.9, 0.1, 0.2, -0.3]}
FLAT = {"center": [0.0, 0.0, 0.0], "radii": [1.0, 0.001, 1.0], "density": 3.0,
        "rotate": [1.0, 0.0, 0.0, 0.0]}
ROD = {"center": [0.0, 0.0, 0.0], "radii": [0.001, 0.001, 1.0], "density": 3.0,
       "rotate": [1.0, 0.0, 0.0, 0.0]}

DEPTHS = [
    ("an egg across", EGG, [-2.0, 0.1, 0.3], [2.0, 0.4, -0.2]),
    ("an egg, ending inside", EGG, [-2.0, 0.1, 0.3], [0.1, 0.25, 0.0]),
    ("inside of an egg", EGG, [0.05, 0.1, 0.1], [0.2, 0.3, 0.15]),
    ("a short segment in an egg", EGG, [0.05, 0.1, 0.1], [0.05003, 0.1, 0.10001]),
    ("the tail of an egg", EGG, [1.6, 0.9, 0.8], [2.4, 1.3, 0.9]),
    ("a needle 1000 : 1 across its middle", NEEDLE, [-1.9, 1.8, 2.05], [2.1, -2.2, -1.95]),
    ("a needle along itself", ROD, [0.0005, 0.0, -3.0], [0.0005, 0.0, 3.0]),
    ("a needle almost along itself", ROD, [0.0005, 0.0, -3.0], [-0.0004, 0.001, 3.0]),
    ("from inside of a needle", ROD, [0.0002, -0.0003, 0.1], [0.5, 0.6, 0.9]),
    ("a needle grazed", ROD, [-1.0, 0.0015, 0.2], [1.0, 0.0015, 0.4]),
    ("a disc from above", FLAT, [0.3, 2.0, 0.2], [0.3, -2.0, 0.2]),
    ("a disc edge-on", FLAT, [-3.0, 0.0003, 0.1], [3.0, 0.0003, 0.1]),
    ("a disc almost edge-on", FLAT, [-3.0, 0.002, 0.1], [3.0, -0.001, 0.1]),
    ("within a disc", FLAT, [-0.2, 0.0001, 0.1], [0.4, 0.0002, -0.3]),
    ("beside a disc", FLAT, [-2.0, 0.0032, 0.1], [2.0, 0.0032, 0.1]),
    ("a turned disc", DISC, [-1.0, 2.0, 1.0], [1.5, -1.7, -1.4]),
    ("a turned disc, ending in it", DISC, [-1.0, 2.0, 1.0], [0.3, 0.1, -0.2]),
]

AIRLIGHTS = [
    ("an egg, lit from aside", [EGG], [-2.0, 0.1, 0.3], [2.0, 0.4, -0.2], [0.5, 2.0, 1.0]),
    ("the eye inside of an egg", [EGG], [0.1, 0.1, 0.1], [2.0, 0.4, -0.2], [0.5, 2.0, 1.0]),
    ("the light inside of an egg", [EGG], [-2.0, 0.1, 0.3], [2.0, 0.4, -0.2], [0.1, 0.35, 0.2]),
    ("a turned disc", [DISC], [-1.0, 2.0, 1.0], [1.5, -1.7, -1.4], [-0.4, 1.0, -1.2]),
    ("an egg in the shadow of a disc", [EGG, DISC], [-2.0, 0.1, 0.3], [2.0, 0.4, -0.2],
     [1.2, -1.0, -0.8]),
]


def digits(value):
    return mp.nstr(value, 20)


def main():
    cases = []
    for name, g, a, b in DEPTHS:
        start, w, length = line(a, b)
        value = digits(depth([Ellipsoid(g)], start, w, length))
        cases.append({"name": name, "quantity": "depth", "gaussians": [g], "from": a, "to": b,
                      "value": float(value), "digits": value})
    mp.dps = 20
    for name, gaussians, eye, target, light in AIRLIGHTS:
        value = digits(airlight([Ellipsoid(g) for g in gaussians], eye, target, light))
        cases.append({"name": name, "quantity": "airlight", "gaussians": gaussians, "from": eye,
                      "to": target, "light": light, "value": float(value), "digits": value})
    lines = ",\n".join("  " + json.dumps(case) for case in cases)
    print('{"cases": [\n' + lines + "\n]}")


if __name__ == "__main__":
    main()
