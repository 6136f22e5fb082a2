"""Airlight and transmittance of a scene's pixels to many digits, in MPFR's arithmetic (gmpy2).

Written apart from Brume's own code, from the definitions alone: what tests it must not share its
mistakes. L = sum of lights I / (4 pi) int b(t) p(t) exp(-(T(eye, x) + T(light, x)) / w) / d(t)^2 dt
with the conventions of the manual (scene-file.md): camera, least distance of a light, phase
function of Henyey and Greenstein, albedo w. Surfaces are squares.
"""

import math

import gmpy2
from gmpy2 import mpfr

gmpy2.get_context().precision = 106
PI = gmpy2.const_pi()
RELATIVE_ERROR = mpfr("1e-11")
# Optical depth of a whole line that is left out.
NEGLIGIBLE = mpfr("1e-20")


def vec(values):
    return tuple(mpfr(v) for v in values)


def add(a, b, scale=1):
    return tuple(x + scale * y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a):
    return gmpy2.sqrt(dot(a, a))


def unit(a):
    size = length(a)
    return tuple(x / size for x in a)


def rotated(q, p):
    """By a unit quaternion w x y z, made one of exactly."""
    size = gmpy2.sqrt(sum(x * x for x in q))
    w, axis = q[0] / size, tuple(x / size for x in q[1:])
    t = tuple(2 * x for x in cross(axis, p))
    return add(add(p, t, w), cross(axis, t))


def erf(x):
    """To 106 bits of 1: differences are good to 1e-30, which is all that depths need."""
    return gmpy2.erf(x) if abs(x) < 9 else gmpy2.copy_sign(mpfr(1), x)


class Medium:
    def __init__(self, medium):
        self.fog = mpfr(medium["density"])
        together = {}
        for g in medium["gaussians"]:
            key = (vec(g["center"]), mpfr(g["radius"]))
            together[key] = together.get(key, mpfr(0)) + mpfr(g["density"])
        self.gaussians = [(*key, density) for key, density in together.items()]

    def on_line(self, eye, w):
        """Each Gaussian as a ray meets it: where, its radius, its density there."""
        terms = []
        for center, radius, density in self.gaussians:
            q = add(center, eye, -1)
            at = dot(q, w)
            gap2 = dot(q, q) - at * at
            peak = density * gmpy2.exp(-gap2 / radius**2)
            if peak * radius > NEGLIGIBLE:
                terms.append((at, radius, peak))
        return Line(self.fog, terms)


class Line:
    def __init__(self, fog, terms):
        self.fog = fog
        self.terms = terms
        half_root_pi = gmpy2.sqrt(PI) / 2
        self.integrals = [(at, r, c * r * half_root_pi, erf(-at / r)) for at, r, c in terms]

    def density(self, t):
        return self.fog + sum(c * gmpy2.exp(-(((t - at) / r) ** 2)) for at, r, c in self.terms)

    def depth(self, t):
        """Over [0, t]."""
        return self.fog * t + sum(
            scale * (erf((t - at) / r) - start) for at, r, scale, start in self.integrals
        )


class Camera:
    def __init__(self, camera, film):
        self.eye = vec(camera["eye"])
        self.target = vec(camera["target"])
        view = add(self.target, self.eye, -1)
        self.forward = unit(view)
        side = cross(self.forward, vec(camera["up"]))
        if length(side) < mpfr("1e-12"):
            other = (0, 1, 0) if abs(self.forward[1]) < 0.9 else (0, 0, -1)
            side = cross(self.forward, vec(other))
        self.right = unit(side)
        self.up = cross(self.right, self.forward)
        self.width, self.height = film["width"], film["height"]
        self.half_height = gmpy2.tan(mpfr(camera["vertical_fov"]) * PI / 360)

    def ray(self, x, y):
        half_width = self.half_height * self.width / self.height
        u = (2 * (x + mpfr("0.5")) / self.width - 1) * half_width
        v = (1 - 2 * (y + mpfr("0.5")) / self.height) * self.half_height
        return unit(add(add(self.forward, self.right, u), self.up, v))

    def least_distance(self, light):
        """A twentieth of a pixel where the light is."""
        distance = max(length(add(light, self.eye, -1)),
                       length(add(self.target, self.eye, -1)) / 100)
        return mpfr("0.1") * gmpy2.atan(self.half_height / self.height) * distance


class Square:
    """Of side 2 around the origin across z, scaled, turned and moved."""

    def __init__(self, surface):
        def place(p):
            p = tuple(mpfr(surface["scale"]) * x for x in p)
            return add(rotated(vec(surface["rotate"]), p), vec(surface["translate"]))

        self.corners = [place(vec(p)) for p in ((-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0))]
        self.side = add(self.corners[1], self.corners[0], -1)
        self.other = add(self.corners[3], self.corners[0], -1)
        self.normal = cross(self.side, self.other)

    def hit(self, origin, w):
        """The parameter where a line meets it, or None."""
        facing = dot(w, self.normal)
        if facing == 0:
            return None
        t = dot(add(self.corners[0], origin, -1), self.normal) / facing
        p = add(add(origin, w, t), self.corners[0], -1)
        u = dot(p, self.side) / dot(self.side, self.side)
        v = dot(p, self.other) / dot(self.other, self.other)
        return t if 0 <= u <= 1 and 0 <= v <= 1 else None

    def shadow_edges(self, light, eye, w):
        """Parameters of the ray where the square's shadow may begin or end."""
        planes = [(self.corners[i], self.corners[(i + 1) % 4]) for i in range(4)]
        found = []
        for a, b in planes:
            normal = cross(add(a, light, -1), add(b, light, -1))
            if dot(normal, w) != 0:
                found.append(dot(add(light, eye, -1), normal) / dot(normal, w))
        if dot(self.normal, w) != 0:
            found.append(dot(add(self.corners[0], eye, -1), self.normal) / dot(self.normal, w))
        return found


def phase(cosine, g):
    return (1 - g * g) / (1 + g * g - 2 * g * cosine) ** mpfr("1.5")


# Gauss-Legendre's points and weights on [-1, 1].
def legendre(n):
    points = []
    for i in range(n):
        x = gmpy2.cos(PI * (i + mpfr("0.75")) / (n + mpfr("0.5")))
        for _ in range(60):
            p, q = mpfr(1), mpfr(0)
            for k in range(n):
                p, q = ((2 * k + 1) * x * p - k * q) / (k + 1), p
            slope = n * (x * p - q) / (x * x - 1)
            step = p / slope
            x -= step
            if abs(step) < mpfr("1e-28"):
                break
        points.append((x, 2 / ((1 - x * x) * slope * slope)))
    return points


POINTS = legendre(14)


def rule(f, a, b):
    middle, half = (a + b) / 2, (b - a) / 2
    return half * sum(weight * f(middle + half * x) for x, weight in POINTS)


def integral(f, breaks):
    """Over the stretches between `breaks`, halved until both halves say what the whole said."""
    stretches = [(a, b, rule(f, a, b), 0) for a, b in zip(breaks, breaks[1:]) if b > a]
    total = sum(abs(s[2]) for s in stretches)
    result = mpfr(0)
    while stretches:
        a, b, whole, level = stretches.pop()
        middle = (a + b) / 2
        left, right = rule(f, a, middle), rule(f, middle, b)
        total = max(total, abs(left) + abs(right))
        if abs(left + right - whole) <= RELATIVE_ERROR * total or level > 60:
            result += left + right
        else:
            stretches += [(a, middle, left, level + 1), (middle, b, right, level + 1)]
    return result


def inverse_depth(line, level, end):
    """A parameter where the depth is about `level`."""
    low, high = mpfr(0), end
    for _ in range(60):
        middle = gmpy2.sqrt(low * high) if low > 0 else high / 1024
        if line.depth(middle) < level:
            low = middle
        else:
            high = middle
        if low > 0 and high < low * mpfr("1.01"):
            break
    return high


def of_light(scene, light, camera, medium, squares, eye, w, line, end, albedo):
    """Radiance per unit of radiant intensity."""
    source = vec(light["position"])
    g = mpfr(scene["medium"].get("anisotropy", 0))
    q = add(source, eye, -1)
    nearest = dot(q, w)
    gap = length(add(q, w, -nearest))
    h = max(gap, camera.least_distance(source), abs(nearest) * mpfr("1e-12"))

    def is_lit(t):
        x = add(eye, w, t)
        way = add(x, source, -1)
        hits = [square.hit(source, way) for square in squares]
        return not any(hit is not None and 0 < hit < 1 for hit in hits)

    def integrand(angle):
        t = nearest + h * gmpy2.tan(angle)
        x = add(eye, w, t)
        way = add(x, source, -1)
        distance = length(way)
        towards = medium.on_line(source, unit(way)).depth(distance) if distance > 0 else mpfr(0)
        cosine = (nearest - t) / distance if distance > 0 else mpfr(0)
        dimmed = gmpy2.exp(-(line.depth(t) + towards) / albedo)
        return line.density(t) * phase(cosine, g) * dimmed / (4 * PI * h)

    last = PI / 2 if end is None else gmpy2.atan((end - nearest) / h)
    breaks = [gmpy2.atan(-nearest / h), last]

    def cut(t):
        if t > 0 and (end is None or t < end):
            breaks.append(gmpy2.atan((t - nearest) / h))

    for at, radius, _ in line.terms:
        for k in (0, 2, 6):
            cut(at + k * radius)
            cut(at - k * radius)
    for k in (0, 1, 10, 100, 1000):
        cut(nearest + k * gap)
        cut(nearest - k * gap)
    far = end if end is not None else mpfr("1e9")
    for level in (0.01, 0.1, 0.5, 1, 2, 4, 8, 16, 32, 64):
        if line.depth(far) / albedo > level:
            cut(inverse_depth(line, level * albedo, far))
    for square in squares:
        for t in square.shadow_edges(source, eye, w):
            cut(t)
    breaks = sorted(set(breaks))
    value = mpfr(0)
    # One stretch of shadow or light after the other.
    lit = []
    for a, b in zip(breaks, breaks[1:]):
        t = nearest + h * gmpy2.tan((a + b) / 2)
        if is_lit(t):
            lit += [a, b] if not lit or lit[-1] != a else [b]
            continue
        if lit:
            value += integral(integrand, lit)
        lit = []
    if lit:
        value += integral(integrand, lit)
    return value


def pixel(scene, x, y):
    """(airlight RGB, transmittance RGB) as floats of a pixel."""
    camera = Camera(scene["camera"], scene["film"])
    medium = Medium(scene["medium"])
    squares = [Square(s) for s in scene["surfaces"]]
    eye, w = camera.eye, camera.ray(x, y)
    hits = [t for t in (square.hit(eye, w) for square in squares) if t is not None and t > 0]
    end = min(hits) if hits else None
    line = medium.on_line(eye, w)
    everything = mpfr("1e14")
    depth = line.depth(end if end is not None else everything)
    albedo = [mpfr(a) for a in scene["medium"].get("albedo", [1, 1, 1])]
    transmittance = [float(gmpy2.exp(-depth / a)) for a in albedo]
    known = {}
    airlight = [mpfr(0)] * 3
    for light in scene["lights"]:
        for channel, intensity in enumerate(light["intensity"]):
            if intensity == 0:
                continue
            key = (tuple(light["position"]), albedo[channel])
            if key not in known:
                known[key] = of_light(scene, light, camera, medium, squares, eye, w, line, end,
                                      albedo[channel])
            airlight[channel] += mpfr(intensity) * known[key]
    if not all(math.isfinite(float(a)) for a in airlight):
        raise ValueError("not finite")
    return [float(a) for a in airlight], transmittance
