"""Renders airlight, and says how far pictures of it are apart."""

import os
import re
import statistics
import subprocess

WIDTH, HEIGHT, BLOCK = 96, 64, 8
PICTURE, AIRLIGHT = 0, 5  # first channels of a frame's


def render(program, scene, picture, *options):
    """CPU seconds of the whole process."""
    command = [program, "render", str(scene), "-o", str(picture), "--size", f"{WIDTH}x{HEIGHT}",
               "--samples", "1", "--backend", "cpu", *options]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                          text=True) as process:
        said = process.stderr.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise RuntimeError(f"{scene}: {said.strip()}")
    return usage.ru_utime + usage.ru_stime


def read(picture, first=AIRLIGHT):
    """Three channels of all pixels."""
    dump = subprocess.run(["oiiotool", "--dumpdata", str(picture)], capture_output=True, text=True,
                          check=True).stdout
    pixels = re.findall(r"Pixel \(\d+, \d+\): ([^(\n]*)", dump)
    if len(pixels) != WIDTH * HEIGHT:
        raise RuntimeError(f"{picture}: {len(pixels)} pixels")
    return [[float(value) for value in pixel.split()[first:first + 3]] for pixel in pixels]


def blocks(values):
    """Sums over blocks of one number per pixel."""
    sums = [0.0] * (WIDTH // BLOCK * (HEIGHT // BLOCK))
    for i, value in enumerate(values):
        sums[i // WIDTH // BLOCK * (WIDTH // BLOCK) + i % WIDTH // BLOCK] += value
    return sums


def root(square):
    return max(square, 0.0) ** 0.5


def difference(picture, one, other):
    """The error of a picture against the mean of two independent ones, whose noise adds nothing.

    `error` is the relative RMSE, between `low` and `high` in 95% of cases; `bias` that of the mean;
    `blocks` the median error of the means of blocks, `noise` the median noise of theirs.
    """
    def products(a, b):
        return [sum(x * y for x, y in zip(p, q)) for p, q in zip(a, b)]

    def less(a, b):
        return [[x - y for x, y in zip(p, q)] for p, q in zip(a, b)]

    squares = blocks(products(less(picture, one), less(picture, other)))
    power = sum(products(one, other))
    if power <= 0.0:
        error = float("inf") if any(map(any, picture)) else 0.0
        return {"error": error, "low": error, "high": error, "bias": 0.0, "blocks": error,
                "noise": 0.0}
    spread = statistics.stdev(squares) * len(squares) ** 0.5
    means = [[blocks(channel) for channel in zip(*values)] for values in (picture, one, other)]
    errors, noises = [], []
    least = (1e-3 * BLOCK**2) ** 2 * power / (WIDTH * HEIGHT)
    for i in range(len(squares)):
        found, a, b = ([channel[i] for channel in mean] for mean in means)
        size = sum((x + y) ** 2 for x, y in zip(a, b)) / 4.0
        if size > least:
            errors.append(sum((f - x) * (f - y) for f, x, y in zip(found, a, b)) / size)
            noises.append(sum((x - y) ** 2 for x, y in zip(a, b)) / 4.0 / size)
    truth = sum(map(sum, one)) + sum(map(sum, other))
    return {
        "error": root(sum(squares) / power),
        "low": root((sum(squares) - 2.0 * spread) / power),
        "high": root((sum(squares) + 2.0 * spread) / power),
        "bias": 2.0 * sum(map(sum, picture)) / truth - 1.0,
        "blocks": root(statistics.median(errors)),
        "noise": root(statistics.median(noises)),
    }
