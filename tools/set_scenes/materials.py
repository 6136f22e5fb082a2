"""Families of what surfaces and lights do: mirrors, what shines, panes, holes, pictures in beams."""

import math
import struct
import zlib

from families import family
from shapes import color, log_uniform, panel, point, scene, solid, spot, standing, sun, tinted


def metallic_roughness(reflectance, roughness, metallic=0.0, **values):
    return {"type": "metallic_roughness", "base_color": list(reflectance), "roughness": roughness,
            "metallic": metallic, **values}


def of(surface, **material):
    """A surface with another material."""
    return {**surface, "material": metallic_roughness(**material)}


def picture(folder, name, value, size=64):
    """Writes a PNG; value(x, y) are channels in [0, 1], with x and y in [0, 1)."""
    rows = [[value((x + 0.5) / size, (y + 0.5) / size) for x in range(size)] for y in range(size)]
    kind = {1: 0, 3: 2, 4: 6}[len(rows[0][0])]
    data = b"".join(b"\0" + bytes(round(255 * c) for pixel in row for c in pixel) for row in rows)

    def chunk(tag, content):
        return (struct.pack(">I", len(content)) + tag + content
                + struct.pack(">I", zlib.crc32(tag + content)))

    header = struct.pack(">IIBBBBB", size, size, 8, kind, 0, 0, 0)
    (folder / name).write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
                                + chunk(b"IDAT", zlib.compress(data)) + chunk(b"IEND", b""))
    return {"file": name}


def things(chance, count=4):
    """Boxes and cylinders on the ground."""
    return [standing(chance.choice(["box", "cylinder"]), [chance.uniform(0.4, 1.4) for _ in range(3)],
                     chance.uniform(-3.0, 3.0), chance.uniform(-3.0, 1.0), color(chance, 0.1, 0.8),
                     chance.uniform(0.0, 90.0)) for _ in range(count)]


def seen(chance, surfaces, lights):
    """From a person's height, in haze."""
    return scene((chance.uniform(-1.0, 1.0), 1.6, 7.0), (0.0, 0.8, 0.0), 45.0, surfaces, lights,
                 log_uniform(chance, 0.01, 0.1), anisotropy=chance.choice([0.0, 0.3, 0.6]))


def ground(chance):
    return solid("plane", (20.0, 1.0, 20.0), (0.0, 0.0, 0.0), color(chance, 0.1, 0.5))


def lamp(chance):
    return point((chance.uniform(-2.0, 2.0), chance.uniform(2.0, 4.0), chance.uniform(-1.0, 3.0)),
                 tinted(chance, 30.0))


@family
def wet_floor(chance, _):
    """Things on a dark floor that mirrors them."""
    wet = of(ground(chance), reflectance=[0.02] * 3, roughness=chance.uniform(0.02, 0.25))
    return seen(chance, [wet, *things(chance)], [lamp(chance)])


@family
def metal(chance, _):
    """Things on a floor of metal."""
    plate = of(ground(chance), reflectance=color(chance, 0.5, 0.95), metallic=1.0,
               roughness=chance.uniform(0.1, 0.5))
    return seen(chance, [plate, *things(chance)], [lamp(chance)])


@family
def neon(chance, _):
    """Tubes and signs that shine, near floor and walls."""
    signs = [of(solid("box", [chance.choice([0.06, 0.5, 1.5]) for _ in range(3)],
                      [chance.uniform(-2.5, 2.5), chance.uniform(0.9, 2.5), chance.uniform(-2.0, 1.0)],
                      (0.0, 0.0, 0.0), chance.uniform(0.0, 90.0)),
                reflectance=[0.0] * 3, roughness=1.0, emissive=tinted(chance, 20.0))
             for _ in range(chance.randint(1, 4))]
    return seen(chance, [ground(chance), *things(chance, 2), *signs], [])


@family
def lights_at_surfaces(chance, _):
    """Spheres and panels a hand's breadth from the floor."""
    height = log_uniform(chance, 0.02, 0.5)
    lights = [{"type": "sphere", "position": [chance.uniform(-2.0, 0.0), height + 0.2, 0.0],
               "radius": 0.2, "radiance": tinted(chance, 40.0)},
              panel((chance.uniform(0.5, 2.0), height, 0.5), (0.0, -1.0, 0.0), tinted(chance, 40.0),
                    chance.uniform(0.3, 1.5), 0.4)]
    return seen(chance, [ground(chance), *things(chance)], chance.sample(lights, chance.randint(1, 2)))


@family
def leaves(chance, folder):
    """Cards with holes before a sun or a lamp."""
    waves = [(chance.uniform(4.0, 12.0), chance.uniform(0.0, 6.3)) for _ in range(2)]

    def leaf(x, y):
        there = math.sin(waves[0][0] * x + waves[0][1]) * math.sin(waves[1][0] * y + waves[1][1]) > 0.0
        return (0.4, 0.6, 0.2, 1.0 if there else 0.0)

    card = {"reflectance": [1.0] * 3, "roughness": 0.8, "alpha": "cutout",
            "base_color_texture": picture(folder, "leaf.png", leaf)}
    cards = [of(standing("plane", (1.5, 1.0, 1.5), chance.uniform(-2.5, 2.5), chance.uniform(-2.0, 1.0),
                         (0.0, 0.0, 0.0)), **card) for _ in range(6)]
    for each in cards:
        each["translate"][1:2] = [chance.uniform(0.6, 2.0)]
        turn = math.radians(chance.uniform(20.0, 90.0)) / 2.0
        each["rotate"] = [math.cos(turn), math.sin(turn), 0.0, 0.0]
    return seen(chance, [ground(chance), *cards],
                [chance.choice([sun(chance, 3.0, (30.0, 60.0)), lamp(chance)])])


@family
def panes(chance, _):
    """Colored and half open panes in the way of the light, and before the eye."""
    sheets = []
    for _ in range(chance.randint(1, 4)):
        sheet = of(standing("box", (chance.uniform(0.8, 2.0), chance.uniform(0.8, 2.0), 0.02),
                            chance.uniform(-2.0, 2.0), chance.uniform(-1.0, 2.0), (0.0, 0.0, 0.0),
                            chance.uniform(0.0, 90.0)), reflectance=color(chance, 0.3, 1.0),
                   roughness=0.7, **chance.choice([{"transmission": color(chance, 0.0, 1.0)},
                                                   {"alpha": "blend", "opacity": 0.5}]))
        sheets.append(sheet)
    return seen(chance, [ground(chance), *things(chance, 3), *sheets],
                [chance.choice([sun(chance, 3.0, (20.0, 50.0)), lamp(chance)])])


@family
def gobos(chance, folder):
    """Spots with pictures in their beams."""
    lights = []
    for i in range(chance.randint(1, 3)):
        lines = chance.randint(2, 6)
        file = picture(folder, f"gobo_{i}.png",
                       lambda x, y, n=lines: [float(int(n * x) % 2 == int(n * y) % 2)], 128)
        outer = chance.uniform(10.0, 30.0)
        lights.append(spot((chance.uniform(-3.0, 3.0), 5.0, chance.uniform(-2.0, 2.0)),
                           (chance.uniform(-0.4, 0.4), -1.0, chance.uniform(-0.4, 0.4)),
                           tinted(chance, 200.0), 0.8 * outer, outer, texture=file))
    return seen(chance, [ground(chance), *things(chance)], lights)
