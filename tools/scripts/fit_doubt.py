#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What ssao/doubt must weigh for a config, and how good its estimates are, over scenes from seeds.

  fit_doubt.py fit CREVICE CONFIG FIRST COUNT    prints the three weights that fit best
  fit_doubt.py check CREVICE CONFIG FIRST COUNT  prints, for each seed, what is estimated and true

Scenes are those of tests/unseen/scenes.py, half of them as one mesh, half at 480x270, half at 960x540.
"""
import array
import json
import math
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
SCENES = os.path.join(HERE, "..", "..", "tests", "unseen", "scenes.py")
WEIGHTS = ("doubt_noise", "doubt_hidden", "doubt_pixel")
FACTOR = 1.35  # within which an estimate is called right
BAD = 0.1      # an error above this is to be found
EVERY = 7      # so many pixels tell how well it is

def run(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout.decode()

def pixels(path):
    with open(path, "rb") as file:
        file.readline(), file.readline(), file.readline()
        values = array.array("f")
        values.frombytes(file.read())
        return values

class View:
    """A scene of a seed, as one config draws it."""

    def __init__(self, crevice, config, seed, folder):
        self.kind, split, merged, self.radius = run("python3", SCENES, str(seed), folder).split()
        self.draw = [crevice, "render", config, "--scene", merged if seed // 16 % 2 else split,
                     "--size", "960x540" if seed // 8 % 2 else "480x270", "--set", "radius=" + self.radius]
        self.folder = folder
        run(crevice, "reference", *self.draw[3:7], "--radius", self.radius, "--out", self.path("truth"))
        run(*self.draw, "--out", "ao=" + self.path("ao"), "--out", "doubt=" + self.path("doubt"))
        self.rmse = json.loads(run(crevice, "compare", self.path("ao"), self.path("truth"), "--json"))["rmse"]

    def path(self, name):
        return os.path.join(self.folder, name + ".pfm")

    def estimate(self, weights=()):
        sets = [text for name, value in weights for text in ("--set", f"{name}={value}")]
        run(*self.draw, *sets, "--out", "doubt_rmse=" + self.path("rmse"))
        return pixels(self.path("rmse"))[0]

    def areas(self):
        """Areas under the curve by which doubt, and darkness alone, find pixels that are off by more than BAD."""
        truth, ao, doubt = (pixels(self.path(name)) for name in ("truth", "ao", "doubt"))
        seen = [i for i in range(0, len(truth), EVERY) if truth[i] == truth[i]]
        bad = {i for i in seen if abs(ao[i] - truth[i]) > BAD}
        if len(bad) < 10:
            return None
        return area(seen, bad, doubt), area(seen, bad, [1 - value for value in ao])

def area(seen, bad, score):
    ranks, ordered, first = 0.0, sorted(seen, key=lambda i: score[i]), 0
    while first < len(ordered):
        end = first
        while end < len(ordered) and score[ordered[end]] == score[ordered[first]]:
            end += 1
        ranks += 0.5 * (first + end - 1) * sum(i in bad for i in ordered[first:end])
        first = end
    return (ranks - len(bad) * (len(bad) - 1) / 2) / (len(bad) * (len(seen) - len(bad)))

def fitted(rows, squares):
    """Weights, none below 0, by which the rows' sums come nearest to the squares, as shares of these."""
    weights = [1.0] * len(WEIGHTS)
    shares = [[value / square for value in row] for row, square in zip(rows, squares)]
    for _ in range(500):
        for k in range(len(weights)):
            rest = [1 - sum(w * s for j, (w, s) in enumerate(zip(weights, row)) if j != k) for row in shares]
            over = sum(row[k] * row[k] for row in shares)
            weights[k] = max(0.0, sum(row[k] * r for row, r in zip(shares, rest)) / max(over, 1e-30))
    # Right in the middle, as a factor.
    off = [math.log(sum(w * s for w, s in zip(weights, row)) + 1e-9) for row in shares]
    return [w * math.exp(-sum(off) / len(off)) for w in weights]

def summary(estimates, rmses):
    logs = [math.log(max(e, 1e-4) / r) for e, r in zip(estimates, rmses)]
    mean = sum(map(math.log, rmses)) / len(rmses)
    near = sum(abs(log) < math.log(FACTOR) for log in logs)
    nearer = sum(abs(log) < abs(mean - math.log(r)) for log, r in zip(logs, rmses))
    return f"within a factor of {FACTOR} in {near} of {len(logs)}, nearer than the mean error in {nearer}"

def fit(crevice, config, seeds, folder):
    rows, rmses = [], []
    for seed in seeds:
        view = View(crevice, config, seed, folder)
        rows.append([view.estimate([(n, int(n == name)) for n in WEIGHTS]) ** 2 for name in WEIGHTS])
        rmses.append(view.rmse)
    left_out = []
    for k in range(len(rows)):
        weights = fitted(rows[:k] + rows[k + 1:], [r * r for r in rmses[:k] + rmses[k + 1:]])
        left_out.append(math.sqrt(sum(w * m for w, m in zip(weights, rows[k]))))
    print(config, json.dumps({n: float(f"{w:.2g}") for n, w in zip(WEIGHTS, fitted(rows, [r * r for r in rmses]))}))
    print("  each left out of its own fit:", summary(left_out, rmses))

def check(crevice, config, seeds, folder):
    estimates, rmses, areas = [], [], []
    for seed in seeds:
        view = View(crevice, config, seed, folder)
        estimates.append(view.estimate())
        rmses.append(view.rmse)
        pair = view.areas()
        areas += [pair] if pair else []
        text = ", area {:.3f}, darkness alone {:.3f}".format(*pair) if pair else ""
        print(f"{seed} {view.kind}: {rmses[-1]:.4f} true, {estimates[-1]:.4f} estimated" + text, flush=True)
    above = sum(doubt > dark for doubt, dark in areas)
    print(f"{config}: {summary(estimates, rmses)}; area above darkness alone in {above} of {len(areas)}")

def main():
    if len(sys.argv) != 6 or sys.argv[1] not in ("fit", "check"):
        sys.exit(__doc__)
    what, crevice, config, first, count = sys.argv[1:]
    seeds = range(int(first), int(first) + int(count))
    with tempfile.TemporaryDirectory() as folder:
        (fit if what == "fit" else check)(crevice, config, seeds, folder)

main()
