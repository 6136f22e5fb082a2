"""What sets are made of: cameras, lights, fog, surfaces, and the files beside a scene.

Lengths in metres. A `chance` is a random.Random; a size, a place or a color is three numbers.
"""

import math
import struct


def scene(eye, target, fov, surfaces, lights=(), density=0.0, gaussians=(), environment=None, **optics):
    made = {
        "format": "brume-scene",
        "version": 1,
        "camera": {"eye": list(eye), "target": list(target), "vertical_fov": fov},
        "film": {"width": 96, "height": 64},
        "medium": {"density": density, "gaussians": list(gaussians), **optics},
        "lights": list(lights),
        "surfaces": list(surfaces),
    }
    if environment:
        made["environment"] = {"file": environment}
    return made


def optics(chance):
    """Phase function and albedo: half of all fog scatters forwards, half absorbs, some in colors."""
    albedo = chance.choice([1.0, 1.0, chance.uniform(0.8, 1.0), None])
    return {
        "anisotropy": chance.choice([0.0, 0.0, 0.3, 0.5, 0.7, 0.85]),
        "albedo": color(chance, 0.6, 1.0) if albedo is None else [albedo] * 3,
    }


def color(chance, low, high):
    return [chance.uniform(low, high) for _ in range(3)]


def tinted(chance, strength):
    """A light's color: red, green and blue between a third of its strength and all of it."""
    return [strength * c for c in color(chance, 0.33, 1.0)]


def between(chance, low, high):
    return [chance.uniform(a, b) for a, b in zip(low, high)]


def log_uniform(chance, low, high):
    return math.exp(chance.uniform(math.log(low), math.log(high)))


# Fog.


def gaussian(center, radius, depth, **values):
    """One of the given optical depth through its centre."""
    return {"center": list(center), "radius": radius, "density": depth / (1.77 * radius), **values}


def bank(chance, count, low, high, radii, depth):
    """Gaussians at random in a box, each of up to an optical depth."""
    return [gaussian(between(chance, low, high), chance.uniform(*radii),
                     depth * chance.uniform(0.2, 1.0))
            for _ in range(count)]


# Lights.


def point(position, intensity, **values):
    return {"type": "point", "position": list(position), "intensity": list(intensity), **values}


def spot(position, direction, intensity, inner, outer, **values):
    return {"type": "spot", "position": list(position), "direction": list(direction),
            "intensity": list(intensity), "inner_angle": inner, "outer_angle": outer, **values}


def sun(chance, irradiance, elevation, diameter=0.0):
    """At random over the horizon, between two elevations in degrees."""
    height, turn = math.radians(chance.uniform(*elevation)), chance.uniform(0.0, 2.0 * math.pi)
    direction = [math.cos(height) * math.cos(turn), -math.sin(height), math.cos(height) * math.sin(turn)]
    return {"type": "directional", "direction": direction,
            "irradiance": [irradiance * c for c in (1.0, 0.9, 0.75)],
            "angular_diameter": diameter}


def panel(position, direction, radiance, width, height):
    up = [0.0, 0.0, 1.0] if direction[1] else [0.0, 1.0, 0.0]
    return {"type": "rectangle", "position": list(position), "direction": list(direction), "up": up,
            "radiance": list(radiance), "width": width, "height": height}


def profile(chance, folder):
    """Writes an IES file of a street light, brightest at some angle from straight down."""
    brightest, width = chance.uniform(0.0, 60.0), chance.uniform(10.0, 40.0)
    angles = range(0, 95, 5)
    candelas = [round(1000.0 * math.exp(-(((a - brightest) / width) ** 2)) * (a < 90)) for a in angles]
    lines = ["IESNA:LM-63-2002", "TILT=NONE", f"1 -1 1 {len(candelas)} 1 1 2 0 0 0", "1 1 100",
             " ".join(map(str, angles)), "0", " ".join(map(str, candelas))]
    (folder / "light.ies").write_text("\n".join(lines) + "\n")
    return "light.ies"


def sky(chance, folder, strength=1.0):
    """Writes a Radiance picture of a sky over dark ground, bright around where the sun is."""
    width, height = 128, 64
    zenith = [strength * c for c in (0.25, 0.45, 0.9)]
    horizon = [strength * c for c in color(chance, 0.6, 1.2)]
    glow = log_uniform(chance, 1.0, 30.0) * strength
    turn, elevation = chance.uniform(-math.pi, math.pi), math.radians(chance.uniform(5.0, 50.0))
    towards = (math.cos(elevation) * math.sin(turn), math.sin(elevation),
               -math.cos(elevation) * math.cos(turn))
    data = bytearray(f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n".encode())
    for row in range(height):
        polar = math.pi * (row + 0.5) / height
        for column in range(width):
            angle = 2.0 * math.pi * ((column + 0.5) / width - 0.5)
            along = (math.sin(polar) * math.sin(angle), math.cos(polar),
                     -math.sin(polar) * math.cos(angle))
            if along[1] < 0.0:
                radiance = [0.1 * c for c in horizon]
            else:
                near = math.exp(-40.0 * (1.0 - sum(a * b for a, b in zip(along, towards))))
                radiance = [h + along[1] * (z - h) + glow * near for z, h in zip(zenith, horizon)]
            exponent = math.frexp(max(radiance))[1]
            data += struct.pack("4B", *(int(256.0 * math.ldexp(c, -exponent)) for c in radiance),
                                exponent + 128)
    (folder / "sky.hdr").write_bytes(data)
    return "sky.hdr"


# Surfaces.


def solid(kind, size, at, reflectance, turn=0.0):
    """A primitive; `turn` is an angle about the vertical in degrees."""
    half = math.radians(turn) / 2.0
    return {"primitive": {"type": kind, "size": list(size)}, "translate": list(at),
            "rotate": [math.cos(half), 0.0, math.sin(half), 0.0],
            "material": {"type": "diffuse", "reflectance": list(reflectance)}}


def floor(chance, width, length, low=0.1, high=0.6):
    return solid("plane", (width, 1.0, length), (0.0, 0.0, 0.0), color(chance, low, high))


def standing(kind, size, x, z, reflectance, turn=0.0):
    """A primitive on the ground."""
    return solid(kind, size, (x, size[1] / 2.0, z), reflectance, turn)


def room(size, at, reflectance, wall=0.2, window=None, ends=True):
    """Slabs around a space of a size whose floor has its middle at `at`.

    A window is (lower, upper, least z, greatest z) in the wall at +x; z is from the middle.
    """
    (x, y, z), (left, base, middle) = size, at
    wide, slabs = x + 2.0 * wall, []

    def slab(size, at):
        place = (left + at[0], base + at[1], middle + at[2])
        slabs.append(solid("box", size, place, reflectance))

    deep = z + 2.0 * wall if ends else z
    slab((wide, wall, deep), (0.0, -wall / 2.0, 0.0))
    slab((wide, wall, deep), (0.0, y + wall / 2.0, 0.0))
    side = (x + wall) / 2.0
    slab((wall, y, z), (-side, y / 2.0, 0.0))
    low, high, near, far = window or (y / 2.0, y / 2.0, 0.0, 0.0)
    slab((wall, low, z), (side, low / 2.0, 0.0))
    slab((wall, y - high, z), (side, (y + high) / 2.0, 0.0))
    if window:
        slab((wall, high - low, near + z / 2.0), (side, (low + high) / 2.0, (near - z / 2.0) / 2.0))
        slab((wall, high - low, z / 2.0 - far), (side, (low + high) / 2.0, (far + z / 2.0) / 2.0))
    for end in (-1.0, 1.0) if ends else ():
        slab((wide, y, wall), (0.0, y / 2.0, end * (z + wall) / 2.0))
    return slabs


def mesh(folder, name, polygons, reflectance):
    """Writes polygons, lists of places, as an OBJ file."""
    lines, count = [], 0
    for polygon in polygons:
        lines += [f"v {x:.5f} {y:.5f} {z:.5f}" for x, y, z in polygon]
        lines.append("f " + " ".join(str(count + i + 1) for i in range(len(polygon))))
        count += len(polygon)
    (folder / name).write_text("\n".join(lines) + "\n")
    return {"mesh": name, "material": {"type": "diffuse", "reflectance": list(reflectance)}}


def terrain(chance, folder, side, height, flat=0.0, cells=40):
    """Hills of some waves; flat ones are cut off below, by water."""
    waves = [(chance.uniform(1.0, 6.0) * math.pi / side, chance.uniform(0.0, 2.0 * math.pi),
              chance.uniform(0.0, 2.0 * math.pi)) for _ in range(6)]

    def place(i, j):
        x, z = side * (i / cells - 0.5), side * (j / cells - 0.5)
        y = sum(math.sin(f * (x * math.cos(a) + z * math.sin(a)) + phase) for f, a, phase in waves) / 6.0
        return (x, max(height * y, -height * (1.0 - flat)), z)

    squares = [[place(i, j), place(i, j + 1), place(i + 1, j + 1), place(i + 1, j)]
               for i in range(cells) for j in range(cells)]
    return mesh(folder, "terrain.obj", squares, color(chance, 0.1, 0.5))
