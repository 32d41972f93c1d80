#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every shipped sample script through meshlabserver. meshlabserver's exit status says little, so
what counts are the files."""

import os
import subprocess
import unittest

import shapes
from host_test import RESULT_FILES, ROOT, SCRIPTS, HostTest, ply_header

import meshlab_host as host

SAMPLES = SCRIPTS / "mlx"


class Samples(HostTest):
    def setUp(self):
        super().setUp()
        self.mesh = shapes.torus()
        self.write("torus.ply", self.mesh)

    def run_sample(self, names, *save):
        """Runs samples on the torus, one after the other; gives what meshlabserver said."""
        scripts = [word for name in names.split() for word in ("-s", SAMPLES / f"{name}.mlx")]
        output, status = host.meshlabserver("-i", "torus.ply", *scripts, *save, folder=self.folder)
        self.assertEqual(status, 0, output)
        self.assertNotIn("Error (", output)
        return output

    def saved(self, name="saved.ply"):
        return ply_header(self.folder / name)

    def test_samples_are_what_the_filters_describe(self):
        subprocess.run([SCRIPTS / "make_samples", self.folder / "mlx"], check=True)
        shipped = {path.name: path.read_text() for path in SAMPLES.iterdir()}
        made = {path.name: path.read_text() for path in (self.folder / "mlx").iterdir()}
        self.assertEqual(shipped, made, "run scripts/make_samples")

    def test_medial_axis_adds_a_layer_of_facets(self):
        self.run_sample("medial_axis", "-o", "saved.ply", "-l", "x", "-m", "vq")
        self.assertGreater(self.saved()["face"][0], len(self.mesh[1]) / 2)
        self.assertIn("quality", self.saved()["vertex"][1])

    def test_medial_geodesic_function_paints_the_input_and_adds_the_medial_axis(self):
        self.run_sample(
            "medial_geodesic_function",
            *("-o", "input.ply", "-l", "0", "-m", "vq", "fq"),
            *("-o", "axis.ply", "-l", "x", "-m", "fq", "fc"),
        )
        painted = self.saved("input.ply")
        self.assertEqual(painted["face"][0], len(self.mesh[1]))
        self.assertIn("quality", painted["vertex"][1])
        self.assertIn("quality", painted["face"][1])
        self.assertLessEqual({"quality", "red"}, set(self.saved("axis.ply")["face"][1]))

    def test_curve_skeleton_adds_tubes_with_colour(self):
        self.run_sample("curve_skeleton", "-o", "saved.ply", "-l", "x", "-m", "fq", "fc")
        self.assertGreater(self.saved()["face"][0], 0)
        self.assertLessEqual({"quality", "red"}, set(self.saved()["face"][1]))

    def test_curve_skeleton_lines_are_closed_to_one_loop(self):
        self.run_sample("curve_skeleton", "-o", "saved.obj", "-l", "1")
        lines = (self.folder / "saved.obj").read_text().splitlines()
        ends = [word for line in lines if line.startswith("l ") for word in line.split()[1:]]
        self.assertGreater(len(ends), 0)
        self.assertEqual({ends.count(end) for end in ends}, {2})

    def test_level_of_detail_follows_the_curve_skeleton(self):
        self.run_sample("curve_skeleton level_of_detail", "-o", "saved.ply", "-l", "x", "-m", "fq")
        self.assertGreater(self.saved()["face"][0], 0)

    def test_segmentation_paints_the_faces_of_the_input(self):
        self.run_sample("segmentation", "-o", "saved.ply", "-l", "0", "-m", "fq", "fc")
        self.assertEqual(self.saved()["face"][0], len(self.mesh[1]))
        self.assertLessEqual({"quality", "red"}, set(self.saved()["face"][1]))

    def test_part_decomposition_paints_the_faces_of_the_input(self):
        self.run_sample("part_decomposition", "-o", "saved.ply", "-l", "0", "-m", "fq", "fc")
        self.assertEqual(self.saved()["face"][0], len(self.mesh[1]))
        self.assertLessEqual({"quality", "red"}, set(self.saved()["face"][1]))

    def test_check_mesh_reports(self):
        output = self.run_sample("check_mesh")
        self.assertRegex(output, r"can be served")

    def test_export_files_writes_all_files(self):
        self.run_sample("export_files")
        written = {entry.name for entry in (self.folder / "curve_skeleton_files").iterdir()}
        self.assertEqual(written, RESULT_FILES)


class BadInput(HostTest):
    def test_each_filter_refuses_an_open_mesh_with_a_reason(self):
        self.write("open.ply", shapes.open_torus())
        for sample in sorted(SAMPLES.glob("*.mlx")):
            if sample.stem in ("check_mesh", "level_of_detail"):  # the one tells, the other needs a skeleton
                continue
            with self.subTest(sample=sample.name):
                output, status = host.meshlabserver(
                    "-i", "open.ply", "-s", sample, "-o", "saved.ply", folder=self.folder
                )
                self.assertEqual(status, 255, output)
                self.assertRegex(output, r"Error \(\w+\): .*(hole|boundary|open|closed)")
                self.assertFalse((self.folder / "saved.ply").exists())


class Installation(HostTest):
    def test_install_puts_the_plugin_where_meshlab_looks(self):
        subprocess.run(
            ["cmake", "--install", host.BUILD],
            env={**os.environ, "DESTDIR": os.fspath(self.folder)},
            check=True,
            capture_output=True,
        )
        installed = list(self.folder.rglob("libfilter_mgf_skeleton.so"))
        self.assertEqual(len(installed), 1)
        original = "/" / installed[0].relative_to(self.folder).parent
        self.assertTrue((original / "libfilter_measure.so").exists(), "beside the stock plugins")

    def test_stage_leaves_the_installed_meshlab_alone(self):
        self.assertNotIn(ROOT, [host.STAGE.resolve()])
        self.assertFalse((host.STAGE / "bin" / "meshlab").is_symlink())
        self.assertFalse((host.STAGE / "bin" / "meshlabserver").is_symlink())


if __name__ == "__main__":
    unittest.main()
