# SPDX-License-Identifier: GPL-3.0-or-later
"""Small meshes for the host tests, and the ways to write them down."""

import math
import struct


def torus(around=36, across=14, radius=1.0, thickness=0.35):
    """Vertices and triangles of a torus: genus 1, one loop."""
    vertices, triangles = [], []
    for i in range(around):
        for j in range(across):
            # Turned a little from ring to ring, so that no four vertices lie on a circle.
            u = 2 * math.pi * i / around
            v = 2 * math.pi * (j + 0.37 * i) / across
            distance = radius + thickness * math.cos(v)
            vertices.append(
                (distance * math.cos(u), distance * math.sin(u), thickness * math.sin(v))
            )
    # After the last ring the turning adds up to `shift` places of the first ring.
    shift = round(0.37 * around)
    for i in range(around):
        for j in range(across):
            back = shift if i == around - 1 else 0
            a = i * across + j
            b = i * across + (j + 1) % across
            c = (i + 1) % around * across + (j + back) % across
            d = (i + 1) % around * across + (j + 1 + back) % across
            triangles += [(a, c, d), (a, d, b)]
    return vertices, triangles


def open_torus():
    """A torus with a hole: the filters refuse it."""
    vertices, triangles = torus()
    return vertices, triangles[:-6]


def moved(mesh, x, y, z):
    vertices, triangles = mesh
    return [(a + x, b + y, c + z) for a, b, c in vertices], triangles


def joined(first, second):
    vertices, triangles = first
    shift = len(vertices)
    return vertices + second[0], triangles + [tuple(v + shift for v in t) for t in second[1]]


def broken_meshes():
    """Meshes that the filters refuse: name, mesh, and the words of the reason."""
    vertices, triangles = torus()
    fin = vertices + [(0, 0, 9)], [*triangles, (*triangles[0][:2], len(vertices))]
    turned = vertices, [t[::-1] for t in triangles[:3]] + triangles[3:]
    infinite = [(math.inf, 0, 0), *vertices[1:]], triangles
    nan = [(math.nan, 0, 0), *vertices[1:]], triangles
    lens = vertices[:3], [(0, 1, 2), (0, 2, 1)]
    inner = torus(radius=1.0, thickness=0.2)
    return [
        ("open", open_torus(), r"1 hole\. .*Close Holes"),
        ("fin", fin, r"1 edge belongs to more than two faces\. .*Repair non Manifold Edges"),
        ("turned", turned, r"3 faces look the other way .*Re-Orient"),
        ("infinite", infinite, r"1 vertex has a coordinate that isn't a finite number\. .*Delete"),
        ("nan", nan, r"1 vertex has a coordinate that isn't a finite number\. .*Delete"),
        ("lens", lens, r"1 closed piece encloses no volume\. .*Remove"),
        ("triangle", (vertices[:3], [(0, 1, 2)]), r"1 hole\. .*Close Holes"),
        ("nested", joined(torus(), inner), r"1 piece lies inside another one\. .*cavities"),
        ("far", moved(torus(), 1e15, -1e15, 1e15), r"place of another one: \d+\. .*origin"),
        ("points", (vertices, []), r"no face with an area\. .*Surface Reconstruction"),
        ("nothing", ([], []), r"no vertices\. .*Choose a layer"),
    ]


def off(mesh):
    vertices, triangles = mesh
    lines = [f"OFF\n{len(vertices)} {len(triangles)} 0"]
    lines += [f"{x:.17g} {y:.17g} {z:.17g}" for x, y, z in vertices]
    lines += [f"3 {a} {b} {c}" for a, b, c in triangles]
    return ("\n".join(lines) + "\n").encode()


def obj(mesh):
    vertices, triangles = mesh
    lines = [f"v {x:.17g} {y:.17g} {z:.17g}" for x, y, z in vertices]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in triangles]
    return ("\n".join(lines) + "\n").encode()


def ply(mesh):
    vertices, triangles = mesh
    header = (
        f"ply\nformat binary_little_endian 1.0\nelement vertex {len(vertices)}\n"
        "property double x\nproperty double y\nproperty double z\n"
        f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    data = b"".join(struct.pack("<3d", *vertex) for vertex in vertices)
    return header.encode() + data + b"".join(struct.pack("<B3i", 3, *t) for t in triangles)


def stl(mesh):
    vertices, triangles = mesh
    data = bytes(80) + struct.pack("<I", len(triangles))
    for triangle in triangles:
        corners = [x for index in triangle for x in vertices[index]]
        data += struct.pack("<12fH", 0, 0, 0, *corners, 0)
    return data


WRITERS = {"off": off, "obj": obj, "ply": ply, "stl": stl}
