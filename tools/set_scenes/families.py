"""Twelve families of sets as designers make them; each function makes one from a random.Random.

Files go into `folder`. Sizes, lights and fog are random, the arrangement is the family's.
"""

import math

from shapes import (bank, between, color, floor, gaussian, log_uniform, mesh, optics, panel, point,
                    profile, room, scene, sky, solid, spot, standing, sun, terrain, tinted)

FAMILIES = {}


def family(function):
    FAMILIES[function.__name__] = function
    return function


@family
def ground(chance, folder):
    """Lamps over a ground whose side is 5 to 5,000 times their height."""
    height = chance.uniform(2.0, 8.0)
    side = height * log_uniform(chance, 5.0, 5000.0)
    near = min(side / 4.0, 2.0 * height)
    lights = [point((chance.uniform(-near, near), height, chance.uniform(-near, near)),
                    tinted(chance, 5.0 * height**2))
              for _ in range(chance.randint(1, 3))]
    distance = height * chance.uniform(2.0, 4.0)
    mist = bank(chance, 12, (-near, 0.0, -near), (near, height, near), (0.3 * height, height), 0.3)
    density = chance.uniform(0.1, 1.0) / distance
    return scene((chance.uniform(-1.0, 1.0), 1.7, distance), (0.0, 0.4 * height, 0.0), 45.0,
                 [floor(chance, side, side)], lights, density, chance.choice([[], mist]),
                 **optics(chance))


@family
def street(chance, folder):
    """Houses on both sides, and street lights that are spots, half of them with a profile."""
    wide = chance.uniform(8.0, 14.0)
    houses = [standing("box", (8.0, chance.uniform(4.0, 14.0), 8.0), side * (wide / 2.0 + 6.0),
                       20.0 - 9.5 * i, color(chance, 0.2, 0.6)) for side in (-1, 1) for i in range(9)]
    height, step = chance.uniform(4.5, 8.0), chance.uniform(9.0, 18.0)
    values = {"profile": profile(chance, folder)} if chance.random() < 0.5 else {}
    inner, outer = chance.uniform(5.0, 40.0), chance.uniform(45.0, 80.0)
    shine = tinted(chance, chance.uniform(50.0, 200.0))
    lights = [spot((side * wide / 2.0, height, 14.0 - step * i), (-0.3 * side, -1.0, 0.0), shine, inner,
                   outer, **values)
              for i, side in enumerate([1, -1] * chance.randint(2, 4))]
    mist = bank(chance, 25, (-wide / 2.0, 0.0, -40.0), (wide / 2.0, 4.0, 15.0), (1.0, 3.0), 0.15)
    return scene((chance.uniform(-1.0, 1.0), 1.7, 22.0), (0.0, 3.0, -10.0), 55.0,
                 [floor(chance, 120.0, 160.0), *houses],
                 lights, chance.uniform(0.004, 0.04), chance.choice([[], mist]), **optics(chance))


@family
def room_with_window(chance, folder):
    """Lit by the sky, half of them by the sun, too."""
    x, y, z = size = between(chance, (4.0, 2.5, 5.0), (9.0, 4.5, 10.0))
    low, width = chance.uniform(0.5, 1.0), chance.uniform(0.8, 0.4 * z)
    window = (low, low + chance.uniform(1.0, y - low - 0.3), -width, chance.uniform(0.3, width))
    things = [standing("box", between(chance, (0.4, 0.4, 0.4), (1.5, 1.2, 1.5)),
                       chance.uniform(-1.0, 1.0),
                       chance.uniform(-0.3 * z, 0.1 * z), color(chance, 0.1, 0.7),
                       chance.uniform(0.0, 90.0))
              for _ in range(3)]
    light = {**sun(chance, 8.0, (20.0, 45.0)),
             "direction": [-1.0, -chance.uniform(0.3, 1.0), chance.uniform(-0.5, 0.5)]}
    outside = [solid("plane", (60.0, 1.0, 60.0), (0.0, -0.21, 0.0), color(chance, 0.1, 0.4))]
    return scene((-0.3 * x, 1.6, 0.42 * z), (0.3 * x, 0.4 * y, -0.3 * z), 60.0,
                 [*room(size, (0.0, 0.0, 0.0), color(chance, 0.4, 0.8), window=window), *things,
                  *chance.choice([[], outside])],
                 chance.choice([[], [light]]), chance.uniform(0.01, 0.1), environment=sky(chance, folder),
                 **optics(chance))


@family
def closed_room(chance, folder):
    """A point, sphere or panel light, down to 3 cm below the ceiling."""
    x, y, z = size = between(chance, (3.0, 2.4, 3.0), (10.0, 4.0, 12.0))
    below = log_uniform(chance, 0.03, 0.6)
    at = (chance.uniform(-0.2, 0.2) * x, y - below, chance.uniform(-0.3, 0.2) * z)
    bulb = {"type": "sphere", "position": list(at), "radius": min(0.1, 0.5 * below),
            "radiance": tinted(chance, 300.0)}
    light = chance.choice([point(at, tinted(chance, 20.0)), bulb,
                           panel(at, (0.0, -1.0, 0.0), tinted(chance, 20.0), 1.2, 0.5)])
    things = [standing("box", between(chance, (0.4, 0.4, 0.4), (1.2, 1.8, 1.2)),
                       chance.uniform(-0.4, 0.4) * x,
                       chance.uniform(-0.4, 0.0) * z, color(chance, 0.1, 0.7)) for _ in range(3)]
    smoke = bank(chance, 15, (-x / 3.0, 0.5, -z / 3.0), (x / 3.0, y, z / 5.0), (0.2, 0.6), 0.3)
    return scene((-0.35 * x, 1.6, 0.42 * z), (0.1 * x, 0.45 * y, -0.2 * z), 60.0,
                 [*room(size, (0.0, 0.0, 0.0), color(chance, 0.3, 0.8)), *things], [light],
                 chance.uniform(0.01, 0.15), chance.choice([[], smoke]), **optics(chance))


@family
def forest(chance, folder):
    """Thin trunks and leaves before a sun."""
    side, trunks, leaves = 24.0, [], []
    for _ in range(chance.randint(40, 90)):
        x, z = between(chance, (-side / 2.0, -side), (side / 2.0, 4.0))
        radius, top = chance.uniform(0.06, 0.25), chance.uniform(6.0, 11.0)
        ring = [(x + radius * math.cos(a), z + radius * math.sin(a))
                for a in (i * math.pi / 4.0 for i in range(9))]
        trunks += [[(a, 0.0, b), (a, top, b), (c, top, d), (c, 0.0, d)]
                   for (a, b), (c, d) in zip(ring, ring[1:])]
        for _ in range(25):
            place = between(chance, (x - 2.0, 0.5 * top, z - 2.0), (x + 2.0, top + 1.0, z + 2.0))
            edges = [between(chance, (-0.5, -0.3, -0.5), (0.5, 0.3, 0.5)) for _ in range(2)]
            leaves.append([[p + a * e + b * f for p, e, f in zip(place, *edges)]
                           for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))])
    ground_mist = bank(chance, 40, (-8.0, 0.0, -16.0), (8.0, 1.5, 2.0), (0.5, 1.5), 0.1)
    values = {"environment": sky(chance, folder, 0.3)} if chance.random() < 0.5 else {}
    return scene((0.0, 1.7, 6.0), (0.0, 3.0, -6.0), 50.0,
                 [floor(chance, 60.0, 60.0, 0.05, 0.3),
                  mesh(folder, "trunks.obj", trunks, color(chance, 0.05, 0.3)),
                  mesh(folder, "leaves.obj", leaves, color(chance, 0.05, 0.4))],
                 [sun(chance, 10.0, (15.0, 50.0))], chance.uniform(0.005, 0.04), ground_mist,
                 **values, **optics(chance))


@family
def fires(chance, folder):
    """One to three camp fires under their own smoke, at night."""
    gaussians, things, far = [], [], []
    for i in range(chance.randint(1, 3)):
        x, z, size = 2.5 * i * chance.uniform(-1.0, 1.0), -1.5 * i, chance.uniform(0.15, 0.5)
        hue = (1.0, chance.uniform(0.3, 0.6), chance.uniform(0.05, 0.2))
        for _ in range(chance.randint(8, 16)):
            up = chance.random()
            place = (x + chance.gauss(0.0, 0.4 * size), size * (0.4 + 2.0 * up),
                     z + chance.gauss(0.0, 0.4 * size))
            gaussians.append(gaussian(place, size * chance.uniform(0.25, 0.5) * (1.2 - up), 0.2,
                                      albedo=[0.05] * 3,
                                      emission=[chance.uniform(10.0, 60.0) * c for c in hue]))
        for k in range(12):
            place = (x + 0.1 * k * chance.uniform(-1.0, 1.5) * size, size * (2.5 + k),
                     z + chance.gauss(0.0, 0.3 * size))
            gaussians.append(gaussian(place, size * (0.5 + 0.1 * k), chance.uniform(0.1, 0.6),
                                      albedo=[chance.uniform(0.3, 0.8)] * 3))
        things += [standing("box", (0.2, 0.15, 2.0 * size), x + size * math.sin(a),
                            z + size * math.cos(a),
                            color(chance, 0.05, 0.3), math.degrees(a)) for a in (0.0, 1.5, 3.3, 4.9)]
    if chance.random() < 0.5:
        far = [sun(chance, 0.05, (30.0, 60.0))]
    return scene((chance.uniform(-1.0, 1.0), 1.5, 6.0), (0.0, 1.0, 0.0), 45.0,
                 [floor(chance, 40.0, 40.0), *things],
                 far, log_uniform(chance, 0.002, 0.05), gaussians, **optics(chance))


@family
def stage(chance, folder):
    """Colored spots from above and a softbox, in haze."""
    wide, height = chance.uniform(8.0, 14.0), chance.uniform(5.0, 8.0)
    lights = []
    for i in range(chance.randint(3, 7)):
        outer = chance.uniform(6.0, 25.0)
        aim = (chance.uniform(-0.5, 0.5), -1.0, chance.uniform(-0.3, 0.5))
        lights.append(spot((wide * chance.uniform(-0.4, 0.4), height, chance.uniform(-2.0, 2.0)), aim,
                           [chance.choice([60.0, 300.0, 1000.0]) * c for c in color(chance, 0.02, 1.0)],
                           outer * chance.uniform(0.0, 1.0), outer))
    if chance.random() < 0.6:
        lights.append(panel((-wide / 2.0, 2.5, 3.0), (1.0, -0.2, -0.6), tinted(chance, 8.0), 1.5, 1.0))
    things = [standing("cylinder", (0.5, 1.75, 0.5), chance.uniform(-0.3, 0.3) * wide,
                       chance.uniform(-2.0, 2.0),
                       color(chance, 0.1, 0.7)) for _ in range(4)]
    haze = bank(chance, 40, (-wide / 2.0, 0.0, -3.0), (wide / 2.0, height, 3.0), (0.6, 1.6), 0.08)
    back = solid("box", (wide + 2.0, height + 1.0, 0.2), (0.0, height / 2.0, -4.0),
                 color(chance, 0.05, 0.4))
    return scene((0.0, 2.3, 11.0), (0.0, 2.2, 0.0), 42.0,
                 [floor(chance, wide + 6.0, 14.0), back, *things], lights,
                 chance.choice([0.0, chance.uniform(0.005, 0.04)]), haze, **optics(chance))


@family
def landscape(chance, folder):
    """Water, hills and a few houses under a sky, in banks of mist."""
    side = chance.uniform(100.0, 600.0)
    height = side * chance.uniform(0.02, 0.1)
    houses = [solid("box", (6.0, 14.0, 6.0),
                    (chance.uniform(-0.2, 0.2) * side, 0.0, -chance.uniform(0.05, 0.4) * side),
                    color(chance, 0.2, 0.7)) for _ in range(8)]
    mist = bank(chance, 40, (-side / 3.0, -height, -side / 3.0), (side / 3.0, height, side / 3.0),
                (0.02 * side, 0.1 * side), 0.3)
    lights = [point((chance.uniform(-0.1, 0.1) * side, height + 6.0, -0.1 * side * i),
                    tinted(chance, 200.0)) for i in range(3)]
    return scene((0.0, height + 5.0, 0.4 * side), (0.0, height, 0.0), 50.0,
                 [terrain(chance, folder, side, height, flat=0.7), *houses], chance.choice([[], lights]),
                 chance.uniform(0.0, 0.5) / side, mist, environment=sky(chance, folder),
                 **optics(chance))


@family
def tunnel(chance, folder):
    """Open at both ends, with lights along its ceiling."""
    size = between(chance, (5.0, 4.0, 40.0), (10.0, 6.0, 200.0))
    kind, shine, lights = chance.choice(["point", "spot", "panel"]), tinted(chance, 40.0), []
    step = chance.uniform(8.0, 15.0)
    for i in range(min(8, int(size[2] / step))):
        at = (chance.uniform(-0.1, 0.1), size[1] - chance.uniform(0.1, 0.4),
              size[2] / 2.0 - 4.0 - step * i)
        lights.append({"point": point(at, shine), "spot": spot(at, (0.0, -1.0, 0.0), shine, 30.0, 70.0),
                       "panel": panel(at, (0.0, -1.0, 0.0), shine, 1.2, 0.3)}[kind])
    cars = [standing("box", (1.8, 1.5, 4.2), chance.choice([-1.5, 1.5]), size[2] / 2.0 - 12.0 * (i + 1),
                     color(chance, 0.1, 0.7))
            for i in range(2)]
    return scene((chance.uniform(-1.0, 1.0), 1.7, size[2] / 2.0 - 1.0), (0.0, 2.0, -10.0), 55.0,
                 [*room(size, (0.0, 0.0, 0.0), color(chance, 0.2, 0.7), ends=False), *cars], lights,
                 chance.uniform(0.01, 0.06), **optics(chance))


@family
def cloud(chance, folder):
    """One over hills, before the sun."""
    size = chance.uniform(20.0, 300.0)
    puffs = bank(chance, chance.randint(30, 120), (-size, 1.5 * size, -0.7 * size),
                 (size, 2.3 * size, 0.7 * size),
                 (0.15 * size, 0.4 * size), log_uniform(chance, 0.1, 2.0))
    values = {"environment": sky(chance, folder, 0.5)} if chance.random() < 0.5 else {}
    return scene((0.0, 0.5 * size, 5.0 * size), (0.0, 1.4 * size, 0.0), 45.0,
                 [terrain(chance, folder, 12.0 * size, 0.3 * size)], [sun(chance, 10.0, (15.0, 60.0))],
                 chance.choice([0.0, 0.02 / size]), puffs, **values, **optics(chance))


@family
def kitchen(chance, folder):
    """Steam over pots, small and dense, under panels."""
    x, y, z = size = between(chance, (3.0, 2.4, 3.0), (5.0, 3.0, 6.0))
    lights = [panel((chance.uniform(-0.2, 0.2) * x, y - 0.05, chance.uniform(-0.3, 0.1) * z),
                    (0.0, -1.0, 0.0),
                    tinted(chance, 15.0), 0.6, 0.6) for _ in range(chance.randint(1, 2))]
    things, steam = [standing("box", (2.0, 0.9, 0.7), 0.0, -0.2 * z, color(chance, 0.3, 0.8))], []
    for i in range(chance.randint(1, 3)):
        left, middle = 0.5 * i - 0.5, -0.2 * z
        things.append(solid("cylinder", (0.3, 0.25, 0.3), (left, 1.025, middle),
                            color(chance, 0.1, 0.6)))
        for k in range(14):
            place = (left + chance.gauss(0.0, 0.03 + 0.01 * k), 1.18 + 0.06 * k,
                     middle + chance.gauss(0.0, 0.03 + 0.01 * k))
            steam.append(gaussian(place, 0.03 + 0.008 * k, chance.uniform(0.2, 1.5)))
    return scene((-0.2 * x, 1.6, 0.4 * z), (0.0, 1.25, -0.2 * z), 45.0,
                 [*room(size, (0.0, 0.0, 0.0), color(chance, 0.3, 0.8)), *things], lights,
                 chance.choice([0.0, chance.uniform(0.005, 0.05)]), steam, **optics(chance))


@family
def houses(chance, folder):
    """Closed ones on a plain under a sun; half of the cameras are in one, beside a light."""
    side = log_uniform(chance, 100.0, 3000.0)
    made = []
    for i in range(chance.randint(1, 4)):
        made += room(between(chance, (4.0, 2.5, 4.0), (9.0, 4.0, 9.0)), (-14.0 * i, 0.21, -4.0 * i),
                     color(chance, 0.3, 0.7))
    lights = [sun(chance, 5.0, (20.0, 60.0), chance.choice([0.0, 0.0, 0.53]))]
    inside = chance.random() < 0.5
    if inside:
        lights.append(point((0.5, 2.2, -0.5), tinted(chance, 2.0)))
    eye, target = (-4.0, 1.7, 24.0), (-6.0, 1.7, 0.0)
    if inside:
        eye, target = (-1.5, 1.6, 1.6), (0.7, 1.2, -1.0)
    return scene(eye, target, 60.0, [floor(chance, side, side), *made], lights,
                 chance.uniform(0.01, 0.05) if inside else 0.3 / side, **optics(chance))
