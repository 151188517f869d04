#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Scenes from seeds, to tune presets on and to judge them on what nobody has drawn.

  scenes.py SEED FOLDER    writes FOLDER/KIND_SEED.glb, a mesh for each object, and
                           FOLDER/KIND_SEED_merged.glb, all in one mesh; prints kind, files, radius
"""
import json
import math
import random
import struct
import sys

KINDS = ("room", "courtyard", "hall", "street", "lens", "foliage", "lowpoly", "above")

def sub(a, b):
    return tuple(p - q for p, q in zip(a, b))

def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])

def unit(a):
    size = math.sqrt(sum(p * p for p in a))
    return tuple(p / size for p in a) if size > 0 else (0.0, 1.0, 0.0)

class Part:
    """Triangles with normals."""

    def __init__(self):
        self.points, self.normals, self.indices = [], [], []

    def add(self, points, normals, faces):
        first = len(self.points)
        self.points += points
        self.normals += normals
        self.indices += [first + k for face in faces for k in face]
        return self

    def quad(self, a, b, c, d):
        """Counter-clockwise, seen from its front."""
        return self.add([a, b, c, d], [unit(cross(sub(b, a), sub(d, a)))] * 4, [(0, 1, 2), (0, 2, 3)])

    def triangles(self):
        return [self.indices[k:k + 3] for k in range(0, len(self.indices), 3)]

    def placed(self, at=(0, 0, 0), turn=0.0):
        c, s = math.cos(turn), math.sin(turn)
        rotate = lambda p: (c * p[0] + s * p[2], p[1], c * p[2] - s * p[0])
        self.points = [tuple(q + t for q, t in zip(rotate(p), at)) for p in self.points]
        self.normals = [rotate(n) for n in self.normals]
        return self

    def smooth(self):
        """One normal for all faces that meet at a place, as modellers that smooth everything make it."""
        places, points = {}, []
        for k in self.indices:
            if places.setdefault(tuple(round(v, 5) for v in self.points[k]), len(points)) == len(points):
                points.append(self.points[k])
        at = [places[tuple(round(v, 5) for v in self.points[k])] for k in self.indices]
        normals = [(0.0, 0.0, 0.0)] * len(points)
        for k in range(0, len(at), 3):
            a, b, c = (points[i] for i in at[k:k + 3])
            n = cross(sub(b, a), sub(c, a))
            for i in at[k:k + 3]:
                normals[i] = tuple(p + q for p, q in zip(normals[i], n))
        self.points, self.indices, self.normals = points, at, [unit(n) for n in normals]
        return self

    def outward(self):
        """Turns triangles whose front faces away from their normals."""
        turned = []
        for i, j, k in self.triangles():
            n = cross(sub(self.points[j], self.points[i]), sub(self.points[k], self.points[i]))
            turned += (i, j, k) if sum(p * q for p, q in zip(n, self.normals[i])) > 0 else (i, k, j)
        self.indices = turned
        return self

def join(*parts):
    whole = Part()
    for each in parts:
        whole.add(each.points, each.normals, each.triangles())
    return whole

def box(x, y, z, centre=(0, 0, 0), sides="xXyYzZ", inside=False):
    """Of those sides: x is the one towards -x. Seen from outside, or from inside."""
    part = Part()
    for side in sides:
        axis, sign = "xyz".index(side.lower()), -1 if side.islower() else 1
        corners = []
        for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            p = [a, b]
            p.insert(axis, sign)
            corners.append(tuple(m + q * size / 2 for m, q, size in zip(centre, p, (x, y, z))))
        n = [0.0, 0.0, 0.0]
        n[axis] = -sign if inside else sign
        part.add(corners, [tuple(n)] * 4, [(0, 1, 2), (0, 2, 3)])
    return part.outward()

def tube(path, radius, sides=10):
    """A closed pipe along a path of points."""
    part = Part()
    for k, at in enumerate(path):
        ahead = unit(sub(path[min(k + 1, len(path) - 1)], path[max(k - 1, 0)]))
        right = unit(cross(ahead, (0.3, 0.9, 0.4) if abs(ahead[1]) < 0.9 else (1, 0, 0)))
        up = cross(right, ahead)
        for i in range(sides):
            c, s = math.cos(2 * math.pi * i / sides), math.sin(2 * math.pi * i / sides)
            n = tuple(c * r + s * u for r, u in zip(right, up))
            part.points.append(tuple(a + radius * v for a, v in zip(at, n)))
            part.normals.append(n)
    for k in range((len(path) - 1) * sides):
        a, b = k, k - k % sides + (k + 1) % sides
        part.indices += [a, b, a + sides, b, b + sides, a + sides]
    for end, beside in ((0, 1), (len(path) - 1, len(path) - 2)):
        ring = part.points[end * sides:(end + 1) * sides]
        part.add(ring, [unit(sub(path[end], path[beside]))] * sides, [(0, i, i + 1) for i in range(1, sides - 1)])
    return part.outward()

def grid(count, at):
    """An open surface: at(u, v) is its point, u and v in 0..1."""
    part, d = Part(), 1.0 / count
    for k in range((count + 1) ** 2):
        u, v = k % (count + 1) * d, k // (count + 1) * d
        part.points.append(at(u, v))
        part.normals.append(unit(cross(sub(at(u, v + 1e-4), at(u, v - 1e-4)), sub(at(u + 1e-4, v), at(u - 1e-4, v)))))
        if u < 1 - d / 2 and v < 1 - d / 2:
            part.indices += [k, k + count + 1, k + 1, k + 1, k + count + 1, k + count + 2]
    return part.outward()

def ball(radius, rings, rough, rng):
    part, waves = Part(), [[rng.uniform(-3, 3) for _ in range(4)] for _ in range(4)]
    for j in range(rings + 1):
        for i in range(2 * rings + 1):
            a, b = math.pi * i / rings, math.pi * j / rings
            n = (math.sin(b) * math.cos(a), math.cos(b), math.sin(b) * math.sin(a))
            bump = sum(math.sin(x * n[0] + y * n[1] + z * n[2] + c) for x, y, z, c in waves) * rough / 4
            part.points.append(tuple(radius * (1 + bump) * v for v in n))
            part.normals.append(n)
            if i < 2 * rings and j < rings:
                k = j * (2 * rings + 1) + i
                part.indices += [k, k + 1, k + 2 * rings + 1, k + 1, k + 2 * rings + 2, k + 2 * rings + 1]
    return part.outward().smooth()

# Things that stand at the origin: lists of parts, each an object.

def table(rng):
    w, d, h, leg = rng.uniform(0.8, 2), rng.uniform(0.6, 1.1), rng.uniform(0.45, 0.8), rng.uniform(0.03, 0.07)
    legs = [box(leg, h, leg, (i * (w / 2 - leg), h / 2, j * (d / 2 - leg))) for i in (-1, 1) for j in (-1, 1)]
    return [box(w, 0.05, d, (0, h + 0.03, 0)), join(*legs)]

def shelf(rng):
    w, h, d = rng.uniform(0.7, 1.3), rng.uniform(1.2, 2.2), 0.32
    boards = [box(w, 0.025, d, (0, h * k / 5 + 0.02, 0)) for k in range(6)]
    books = [box(0.035, rng.uniform(0.12, 0.22), rng.uniform(0.14, 0.24),
                 (-w / 2 + 0.08 + 0.04 * k, h * row / 5 + 0.15, 0)) for row in range(4) for k in range(rng.randint(2, 14))]
    return [join(*boards, *[box(0.025, h, d, (i * w / 2, h / 2, 0)) for i in (-1, 1)]), join(*books)]

def crates(rng):
    parts, y = [], 0.0
    for _ in range(rng.randint(1, 3)):
        s = rng.uniform(0.3, 0.7)
        parts.append(box(s, s, s, (0, s / 2, 0)).placed((rng.uniform(-.05, .05), y, 0), rng.uniform(0, 0.4)))
        y += s + 1e-3
    return parts

def rock(rng):
    return [ball(rng.uniform(0.15, 0.8), rng.choice((4, 9)), rng.uniform(0, 0.5), rng)]

def ladder(rng):
    h = rng.uniform(1.6, 2.6)
    return [tube([(i * 0.22, 0, 0), (i * 0.22, h, -0.5)], 0.02, 8) for i in (-1, 1)] + [
        tube([(-0.22, t * h, -0.5 * t), (0.22, t * h, -0.5 * t)], 0.014, 8) for t in (0.15, 0.3, 0.45, 0.6, 0.75, 0.9)]

def stairs(rng):
    n, w = rng.randint(4, 9), rng.uniform(0.9, 1.8)
    return [join(*[box(w, 0.17 * (k + 1), 0.28, (0, 0.085 * (k + 1), k * 0.28)) for k in range(n)])]

def fence(rng):
    length, h = rng.uniform(2, 5), rng.uniform(0.7, 1.2)
    posts = [box(0.05, h, 0.02, (x * 0.16, h / 2, 0)) for x in range(int(length / 0.16))]
    return [join(*posts, *[box(length, 0.06, 0.03, (length / 2, y * h, -0.03)) for y in (0.25, 0.8)])]

def house(rng, shell=False):
    """With `shell` walls and roof have no inside, as kits for views from one side are."""
    w, d, h, roof = rng.uniform(3, 6), rng.uniform(3, 5), rng.uniform(2.5, 6), rng.uniform(0.8, 2)
    a, b, top = w / 2 + rng.uniform(0.15, 0.5), d / 2 + rng.uniform(0.15, 0.5), h + 1e-3
    slopes, ridge = Part(), [(-a, top + roof, 0), (a, top + roof, 0)]
    slopes.quad((-a, top, b), (a, top, b), ridge[1], ridge[0])
    slopes.quad((a, top, -b), (-a, top, -b), ridge[0], ridge[1])
    if not shell:
        slopes.quad((-a, top, -b), (a, top, -b), (a, top, b), (-a, top, b))
        for x, end in ((-a, ridge[0]), (a, ridge[1])):
            slopes.add([(x, top, b), end, (x, top, -b)], [(math.copysign(1.0, x), 0.0, 0.0)] * 3, [(0, 1, 2)])
    parts = [box(w, h, d, (0, h / 2, 0), "xXzZ" if shell else "xXyYzZ"), slopes.outward()]
    for storey in range(int(h / 2.3)):
        for k in range(int(w / 1.3)):
            x, y = -w / 2 + 0.9 + k * 1.3, 1.3 + 2.3 * storey
            for z, out in ((d / 2, 1), (-d / 2, -1)):
                frame = [box(0.06, 1.1, 0.06, (x + i * 0.4, y, z + out * 0.03)) for i in (-1, 1)]
                parts += [box(0.9, 0.07, 0.14, (x, y - 0.55, z + out * 0.07)), join(*frame)]
    return parts + [box(1.0, 0.15, 0.8, (0, 0.075, d / 2 + 0.4))]

def tree(rng):
    h = rng.uniform(1.8, 3.5)
    crown = Part()
    for _ in range(rng.randint(150, 400)):
        c, n = [rng.gauss(0, 0.42) for _ in range(3)], unit([rng.gauss(0, 1) for _ in range(3)])
        s, r = rng.uniform(0.05, 0.13), unit(cross(n, (0.2, 0.5, 0.84)))
        u = cross(n, r)
        crown.quad(*[(c[0] + s * (i * r[0] + j * u[0]), c[1] + h + s * (i * r[1] + j * u[1]),
                      c[2] + s * (i * r[2] + j * u[2])) for i, j in ((-1, -1.6), (1, -1.6), (1, 1.6), (-1, 1.6))])
    return [tube([(0, 0, 0), (0, h / 2, 0), (rng.uniform(-.2, .2), h, rng.uniform(-.2, .2))], 0.09, 9), crown]

def banner(rng, x, y, z, w, h):
    k, f = rng.uniform(3, 9), rng.uniform(0.03, 0.1)
    return grid(16, lambda u, v: (x + (u - 0.5) * w, y - v * h, z + f * math.sin(k * u * 3 + v)))

def terrain(rng, size, height, count=48):
    waves = [(rng.uniform(-9, 9), rng.uniform(-9, 9), rng.uniform(0, 6.3), k + 1) for k in range(7)]
    ground = lambda x, z: height / 2 * sum(math.sin(k * (a * x + b * z) / size + c) / k for a, b, c, k in waves)
    place = lambda u, v: ((u - .5) * size, ground((u - .5) * size, (v - .5) * size), (v - .5) * size)
    return grid(count, place), ground

FURNITURE = (table, shelf, crates, rock, ladder, stairs)

def scatter(rng, makers, count, half, ground=lambda x, z: 0.0, eye=None):
    """Things at random places, none within the circle of another or within a metre of the eye."""
    parts, taken = [], [(*eye, 1)] if eye else []
    for _ in range(count * 8):
        things = rng.choice(makers)(rng)
        reach = max(math.hypot(p[0], p[2]) for part in things for p in part.points)
        x, z = rng.uniform(-half[0], half[0]), rng.uniform(-half[1], half[1])
        beyond = abs(x) > half[0] - reach or abs(z) > half[1] - reach
        if len(taken) >= count or beyond or any(math.hypot(x - a, z - b) < reach + r for a, b, r in taken):
            continue
        taken.append((x, z, reach))
        turn = rng.choice((0, 0.5, 1, 1.5)) * math.pi + rng.uniform(-0.3, 0.3) * (rng.random() < 0.6)
        parts += [part.placed((x, ground(x, z), z), turn) for part in things]
    return parts

# Scenes: objects, eye, the point looked at, field of view in degrees.

def scene_room(rng):
    w, h, d = rng.uniform(4, 7), rng.uniform(2.4, 3.2), rng.uniform(4, 6)
    parts = [box(w, h, d, (0, h / 2, 0), inside=True)] + scatter(rng, FURNITURE, 9, (w / 2, d / 2), eye=(0.4 - w / 2, d / 2 - 0.4))
    for _ in range(rng.randint(2, 5)):
        r, y, z = rng.uniform(0.03, 0.09), rng.uniform(0.4, 0.95) * h, -d / 2 + rng.uniform(0.12, 0.3)
        parts.append(tube([(-w / 2 + 0.1, y, z), (w / 2 - 0.3, y, z), (w / 2 - 0.3, 0.1, z)], r, 12))
    parts.append(banner(rng, 0.3 * w, h * 0.9, -d / 2 + 0.15, 1.0, h * 0.7))
    return parts, (-w / 2 + 0.4, rng.uniform(1.2, h - 0.4), d / 2 - 0.4), (w * 0.15, 0.5, -d * 0.15), rng.uniform(55, 70)

def scene_hall(rng):
    w, h, d = rng.uniform(9, 14), rng.uniform(4.5, 7), rng.uniform(12, 20)
    parts = [box(w, h, d, (0, h / 2, 0), inside=True)]
    for k in range(int(d / 3)):
        for x in (-w / 2 + 1.5, w / 2 - 1.5):
            z, r = -d / 2 + 1.5 + 3 * k, rng.uniform(0.2, 0.35)
            parts += [tube([(x, 0.2, z), (x, h - 0.2, z)], r, 16), box(3 * r, 0.25, 3 * r, (x, 0.125, z))]
            if rng.random() < 0.5:
                parts.append(banner(rng, x * 0.75, h * 0.95, z + 0.4, 0.9, h * 0.5))
    for _ in range(rng.randint(3, 6)):
        x, y = rng.uniform(-w / 3, w / 3), h - rng.uniform(0.3, 0.9)
        parts.append(tube([(x, y, -d / 2 + .1), (x, y, 0), (x + 0.5, y - 0.3, d / 4), (x + 0.5, y - 0.3, d / 2 - .1)],
                          rng.uniform(0.04, 0.15), 12))
    parts += scatter(rng, FURNITURE, 14, (w / 2 - 2, d / 2 - 1))
    return parts, (rng.uniform(-1, 1), rng.uniform(1.6, 3.5), d / 2 - 0.6), (0, 0.8, -d * 0.1), rng.uniform(50, 65)

def scene_courtyard(rng):
    parts = [Part().quad((-14, 0, 14), (14, 0, 14), (14, 0, -14), (-14, 0, -14))]
    for k in range(8):
        turn, r = 2 * math.pi * k / 8 + rng.uniform(-0.15, 0.15), rng.uniform(7.5, 9.5)
        at = (r * math.sin(turn), 0, r * math.cos(turn))
        parts += [part.placed(at, turn + math.pi) for part in house(rng, True)]
    parts += scatter(rng, (crates, stairs, rock, table, fence), 9, (4, 4))
    return parts, (rng.uniform(-2, 2), rng.uniform(1.6, 4), 4.8), (0, 0.8, -2), rng.uniform(50, 70)

def scene_street(rng):
    surface, ground = terrain(rng, 60, 0.8)
    parts = [surface]
    for x in (-6, 6):
        z = -22
        while z < 10:
            things = house(rng)
            reach = max(abs(p[2]) for part in things for p in part.points)
            z += reach + 0.5
            parts += [part.placed((x, ground(x, z) - 0.3, z), -math.copysign(math.pi / 2, x)) for part in things]
            z += reach
    parts += scatter(rng, (rock, rock, fence, crates, stairs), 22, (3.2, 14), ground)
    return parts, (rng.uniform(-1, 1), ground(0, 13) + rng.uniform(1.7, 4), 13.5), (0, 0.8, 2), rng.uniform(50, 65)

def scene_lens(rng):
    parts, eye, _, _ = scene_street(rng)
    return parts, (eye[0], eye[1] + 1.5, 27), (rng.uniform(-2, 2), 1.0, -2), 18.0

def scene_foliage(rng):
    surface, ground = terrain(rng, 24, 0.35)
    parts = [surface] + scatter(rng, (tree, tree, rock), 16, (5, 6), ground)
    for _ in range(5):  # wires
        y, x = rng.uniform(2, 3.2), rng.uniform(-3, 3)
        parts.append(tube([(x + 0.2 * t, y - 0.4 + t * t / 40, 1.5 * t) for t in range(-4, 5)], 0.012, 6))
    grass = Part()
    for _ in range(900):
        x, z, t = rng.uniform(-5, 5), rng.uniform(-5, 6), rng.uniform(0, 6.3)
        y, dx, dz = ground(x, z) - 0.02, 0.02 * math.cos(t), 0.02 * math.sin(t)
        tip = (x + rng.uniform(-.1, .1), y + rng.uniform(0.12, 0.4), z + rng.uniform(-.1, .1))
        grass.add([(x - dx, y, z - dz), (x + dx, y, z + dz), tip], [unit((-dz, 0, dx))] * 3, [(0, 1, 2)])
    return parts + [grass.outward()], (rng.uniform(-1, 1), rng.uniform(1.2, 2.4), 7.5), (0, 1.2, 0), rng.uniform(45, 60)

def scene_lowpoly(rng):
    """A castle of few, smoothed faces."""
    surface, ground = terrain(rng, 16, 0.5, 14)
    parts = [surface, box(1.6, 2.4, 1.6, (0, 1.2, 0)).smooth()]
    for x, z in ((-2.5, -2.5), (2.5, -2.5), (2.5, 2.5), (-2.5, 2.5)):
        h, r = rng.uniform(1.8, 2.8), rng.uniform(0.45, 0.7)
        for low, high, wide in ((-0.5, h, 1), (h, h + 1.1, 1.25)):
            parts.append(tube([(0, low, 0), (0, high, 0)], r * wide, 7).smooth().placed((x, ground(x, z), z)))
        wall = (5, 2.2, 0.4, (0, 0.7, z)) if x * z > 0 else (0.4, 2.2, 5, (x, 0.7, 0))
        parts.append(box(*wall).smooth())
    parts += [part.smooth() for part in scatter(rng, (rock, crates), 14, (6, 6), ground)]
    turn = rng.uniform(0, 6.3)
    return parts, (7.5 * math.sin(turn), rng.uniform(3, 5), 7.5 * math.cos(turn)), (0, 0.6, 0), rng.uniform(40, 55)

def scene_above(rng):
    parts, _, _, fov = rng.choice((scene_street, scene_courtyard, scene_lowpoly))(rng)
    return parts, (0.01, rng.uniform(12, 20), 0.3), (0, 0, 0), fov

def write(path, objects, eye, at, fov):
    data, views, accessors, meshes, nodes = bytearray(), [], [], [], []

    def accessor(values, form, kind, component):
        values = [struct.pack("<" + form, *v) for v in values]
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": sum(map(len, values))})
        data.extend(b"".join(values))
        entry = {"bufferView": len(views) - 1, "componentType": component, "count": len(values), "type": kind}
        if kind == "VEC3":
            columns = list(zip(*[struct.unpack("<3f", v) for v in values]))
            entry.update(min=[min(c) for c in columns], max=[max(c) for c in columns])
        accessors.append(entry)
        return len(accessors) - 1

    for part in objects:
        meshes.append({"primitives": [{
            "attributes": {"POSITION": accessor(part.points, "3f", "VEC3", 5126),
                           "NORMAL": accessor(part.normals, "3f", "VEC3", 5126)},
            "indices": accessor([(k,) for k in part.indices], "I", "SCALAR", 5125)}]})
        nodes.append({"mesh": len(nodes)})
    z = unit(sub(eye, at))
    x = unit(cross((0, 1, 0), z))
    nodes.append({"camera": 0, "matrix": [*x, 0, *cross(z, x), 0, *z, 0, *eye, 1]})
    lens = {"yfov": math.radians(fov), "aspectRatio": 16 / 9, "znear": 0.1, "zfar": 200}
    text = json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes,
        "meshes": meshes, "cameras": [{"type": "perspective", "perspective": lens}], "accessors": accessors,
        "bufferViews": views, "buffers": [{"byteLength": len(data)}]}).encode()
    text += b" " * (-len(text) % 4)
    with open(path, "wb") as file:
        file.write(struct.pack("<IIIII", 0x46546C67, 2, 28 + len(text) + len(data), len(text), 0x4E4F534A))
        file.write(text + struct.pack("<II", len(data), 0x4E4942) + data)

def main():
    seed, folder = int(sys.argv[1]), sys.argv[2]
    rng, kind = random.Random(seed), KINDS[seed % len(KINDS)]
    parts, eye, at, fov = globals()["scene_" + kind](rng)
    # In pixels of a picture of 540 rows, at the point that is looked at.
    pixels = math.exp(rng.uniform(math.log(12), math.log(150)))
    radius = pixels * 2 * math.dist(eye, at) * math.tan(math.radians(fov) / 2) / 540
    split, merged = (f"{folder}/{kind}_{seed}{end}.glb" for end in ("", "_merged"))
    write(split, parts, eye, at, fov)
    write(merged, [join(*parts)], eye, at, fov)
    print(kind, split, merged, f"{radius:.2g}")

main()
