# SPDX-License-Identifier: GPL-3.0-or-later
"""What the host tests share: a folder to work in, and the scripts folder to import from."""

import os
import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRIPTS = ROOT / "scripts"
sys.path.insert(0, os.fspath(SCRIPTS))

import shapes  # noqa: E402

RESULT_FILES = {
    "medial_axis.ply",
    "skeleton.ply",
    "skeleton_smooth.ply",
    "skeleton.swc",
    "skeleton.graphml",
    "skeleton.vtp",
    "branches.csv",
    "circles.ply",
    "segmentation.ply",
    "parts.ply",
    "tubes.ply",
    "report.json",
}


class HostTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, mesh):
        """Writes a mesh, in the format that the name tells; gives the path."""
        path = self.folder / name
        path.write_bytes(shapes.WRITERS[path.suffix[1:].lower()](mesh))
        return path


def ply_header(path):
    """The elements of a PLY file: name to (count, [property names])."""
    elements, last = {}, None
    with open(path, "rb") as file:
        for line in file:
            words = line.decode("ascii", errors="replace").split()
            if words[0] == "element":
                last = elements.setdefault(words[1], (int(words[2]), []))
            elif words[0] == "property":
                last[1].append(words[-1])
            elif words[0] == "end_header":
                return elements
    raise ValueError(f"{path} has no PLY header")
