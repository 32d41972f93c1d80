#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/demo_mesh makes what the demo promises."""

import collections
import math
import subprocess
import unittest

from host_test import SCRIPTS, HostTest


class DemoMesh(HostTest):
    def test_is_a_closed_manifold_with_a_handle_and_4000_vertices(self):
        path = self.folder / "demo.off"
        subprocess.run([SCRIPTS / "demo_mesh", path], check=True)
        lines = path.read_text().splitlines()
        vertex_count, face_count, _ = map(int, lines[1].split())
        points = [tuple(map(float, line.split())) for line in lines[2 : 2 + vertex_count]]
        faces = [tuple(map(int, line.split()[1:])) for line in lines[2 + vertex_count :]]
        self.assertGreaterEqual(vertex_count, 4000)
        self.assertEqual(len(faces), face_count)

        sides = collections.Counter(side for a, b, c in faces for side in ((a, b), (b, c), (c, a)))
        self.assertEqual(set(sides.values()), {1})
        self.assertTrue(all((b, a) in sides for a, b in sides))
        self.assertEqual(vertex_count - len(sides) // 2 + face_count, 0, "genus 1")
        self.assertGreater(min(math.dist(points[a], points[b]) for a, b in sides), 1e-3)


if __name__ == "__main__":
    unittest.main()
