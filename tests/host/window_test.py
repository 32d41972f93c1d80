#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The filters in MeshLab's window, as a user finds and runs them."""

import unittest

import shapes
from host_test import HostTest

import meshlab_host as host

# Filter, something its dialog asks for, layers it adds, what its log says.
FILTERS = [
    ("Medial Axis (Voronoi)", "Sampling", ["medial axis"], "acet"),
    ("Medial Geodesic Function", "Sampling", ["medial geodesic function"], "eodesic"),
    (
        "Curve Skeleton (MGF)",
        "Divergence threshold",
        ["curve skeleton", "smooth curve skeleton", "curve skeleton tubes"],
        "keleton",
    ),
    (
        "Tubular and Flat Segmentation (Geodesic Circles)",
        "Eccentricity threshold",
        ["geodesic circles"],
        "ubular",
    ),
    ("Part Decomposition by Curve Skeleton", "Pruning", [], "ranch"),
]
OTHER_FILTERS = [
    "Curve Skeleton Level of Detail",
    "Check Mesh for Curve Skeleton",
    "Export Curve Skeleton Files",
]


class Window(HostTest):
    def do(self, *commands, mesh):
        """Opens a mesh, carries out the commands, and gives what was seen, by command."""
        path = self.write("torus.ply", mesh)
        seen = host.meshlab_window([path], [("wait_layers", 1), *commands, ("quit",)])
        for line in seen:
            if "command" in line:
                self.assertTrue(line["ok"], line)
        return seen

    def seen(self, lines, key):
        return [line[key] for line in lines if key in line]

    def test_every_filter_stands_in_the_menu(self):
        [names] = self.seen(self.do(("filters",), mesh=shapes.torus()), "filters")
        for name in [name for name, *_ in FILTERS] + OTHER_FILTERS:
            self.assertIn(name, names)

    def test_each_filter_opens_its_dialog_and_gives_its_layers_and_log(self):
        commands = []
        for name, *_ in FILTERS:
            commands += [("start", name), ("dialog",), ("apply",), ("close",), ("layers",)]
            commands += [("log",), ("select", "torus")]
        lines = self.do(*commands, mesh=shapes.torus())
        self.assertEqual(self.seen(lines, "box"), [])
        titles, labels = self.seen(lines, "title"), self.seen(lines, "labels")
        layers, logs = self.seen(lines, "layers"), self.seen(lines, "log")
        expected = 1
        for i, (name, label, added, said) in enumerate(FILTERS):
            with self.subTest(filter=name):
                self.assertEqual(titles[i], name)
                self.assertIn("Dey", labels[i][0], "the help text names its source")
                self.assertIn(label, labels[i])
                expected += len(added)
                self.assertEqual(len(layers[i]), expected, layers[i])
                for layer in added:
                    self.assertIn(f"torus {layer}", layers[i])
                self.assertIn(said, logs[i])

    def test_level_of_detail_works_from_the_cached_skeleton(self):
        lines = self.do(
            ("start", "Curve Skeleton (MGF)"),
            ("apply",),
            ("close",),
            ("select", "torus"),
            ("start", "Curve Skeleton Level of Detail"),
            ("apply",),
            ("layers",),
            mesh=shapes.torus(),
        )
        self.assertEqual(self.seen(lines, "box"), [])
        [layers] = self.seen(lines, "layers")
        self.assertIn("torus level of detail", layers)

    def test_the_check_asks_nothing_and_says_what_it_found(self):
        lines = self.do(("start", "Check Mesh for Curve Skeleton"), ("log",), mesh=shapes.torus())
        [log] = self.seen(lines, "log")
        self.assertIn("can be served", log)

    def test_the_exporter_writes_the_folder_that_it_is_told(self):
        target = self.folder / "files"
        self.do(
            ("start", "Export Curve Skeleton Files"),
            ("set", "Output folder", target),
            ("apply",),
            mesh=shapes.torus(),
        )
        self.assertTrue((target / "report.json").exists())

    def test_a_mesh_that_is_open_is_refused_and_the_document_stays_as_it_was(self):
        names = [name for name, *_ in FILTERS]
        commands = [("layers",)]
        for name in names:
            commands += [("start", name), ("apply",), ("close",), ("layers",)]
        lines = self.do(*commands, mesh=shapes.open_torus())
        boxes = self.seen(lines, "box")
        self.assertEqual(len(boxes), len(names), boxes)
        for name, box in zip(names, boxes):
            self.assertIn(name, box)
            self.assertRegex(box, "hole|boundary|open|closed")
        for layers in self.seen(lines, "layers"):
            self.assertEqual(layers, ["torus"])

    def test_a_second_apply_while_a_filter_runs_is_refused_and_the_first_one_ends_well(self):
        lines = self.do(
            ("start", "Curve Skeleton (MGF)"),
            ("apply_twice",),
            ("layers",),
            mesh=shapes.torus(),
        )
        [box] = self.seen(lines, "box")
        self.assertIn("is running", box)
        [layers] = self.seen(lines, "layers")
        self.assertEqual(layers.count("torus curve skeleton"), 1, layers)

    def test_a_value_out_of_range_is_refused_by_name(self):
        lines = self.do(
            ("start", "Curve Skeleton (MGF)"),
            ("set", "Divergence threshold", "5"),
            ("apply",),
            ("layers",),
            mesh=shapes.torus(),
        )
        [box] = self.seen(lines, "box")
        self.assertIn("Divergence threshold", box)
        self.assertEqual(self.seen(lines, "layers"), [["torus"]])


if __name__ == "__main__":
    unittest.main()
