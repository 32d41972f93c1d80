#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/skeletonize: what it takes, leaves, says and returns."""

import contextlib
import json
import os
import pathlib
import signal
import subprocess
import time
import unittest

import shapes
from host_test import RESULT_FILES, SCRIPTS, HostTest, ply_header

COMMAND = SCRIPTS / "skeletonize"


def skeletonize(*words, folder):
    return subprocess.run(
        [COMMAND, *map(os.fspath, words)],
        cwd=folder,
        capture_output=True,
        encoding="utf-8",
        check=False,
    )


def report(folder):
    return json.loads((folder / "report.json").read_text(encoding="utf-8"))


class Results(HostTest):
    def test_torus_of_each_format_gives_one_loop_and_all_files(self):
        mesh = shapes.torus()
        inputs = [self.write(f"{kind}_torus.{kind}", mesh) for kind in shapes.WRITERS]
        done = skeletonize(*inputs, "--out", "out", "--jobs", "2", folder=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        for path in inputs:
            results = self.folder / "out" / path.stem
            self.assertEqual({entry.name for entry in results.iterdir()}, RESULT_FILES)
            said = report(results)
            self.assertEqual(said["input"]["file"], path.name)
            self.assertEqual(said["input"]["vertices"], len(mesh[0]))
            self.assertEqual(said["input"]["faces"], len(mesh[1]))
            self.assertEqual(said["input"]["genus"], 1)
            self.assertEqual((said["skeleton"]["b0"], said["skeleton"]["b1"]), (1, 1))
            self.assertEqual(said["skeleton"]["leaves"], 0)

    def test_files_have_the_promised_elements_and_properties(self):
        mesh = shapes.torus()
        self.write("torus.ply", mesh)
        done = skeletonize("torus.ply", "--out", "out", folder=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        results = self.folder / "out" / "torus"
        promised = {
            "medial_axis.ply": {
                "vertex": "x y z radius",
                "face": "vertex_indices contact_a contact_b mgf gradient_x gradient_y gradient_z",
            },
            "skeleton.ply": {
                "vertex": "x y z radius mgf eccentricity",
                "edge": "vertex1 vertex2 mgf eccentricity girth",
            },
            "segmentation.ply": {"vertex": "x y z", "face": "vertex_indices quality red green blue"},
            "circles.ply": {"vertex": "x y z eccentricity", "edge": "vertex1 vertex2"},
        }
        for name, elements in promised.items():
            header = ply_header(results / name)
            for element, properties in elements.items():
                self.assertLessEqual(set(properties.split()), set(header[element][1]), name)
        segmentation = ply_header(results / "segmentation.ply")
        self.assertEqual(segmentation["vertex"][0], len(mesh[0]))
        self.assertEqual(segmentation["face"][0], len(mesh[1]))

    def test_coordinates_keep_double_precision(self):
        """Far from the origin single precision would flatten the mesh."""
        vertices, triangles = shapes.torus()
        far = [(x + 1e6, y - 2e6, z + 3e6) for x, y, z in vertices]
        self.write("far.ply", (far, triangles))
        done = skeletonize("far.ply", "--out", "out", folder=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(report(self.folder / "out" / "far")["skeleton"]["b1"], 1)

    def test_same_input_gives_the_same_bytes(self):
        for name in ("first.off", "second.off"):
            self.write(name, shapes.torus())
        for words in (["first.off"], ["second.off", "--jobs", "2"]):
            done = skeletonize(*words, "--out", "out", folder=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
        for name in RESULT_FILES - {"report.json"}:
            first, second = (self.folder / "out" / s / name for s in ("first", "second"))
            self.assertEqual(first.read_bytes(), second.read_bytes(), name)

    def test_solids_that_overlap_have_their_files_and_a_warning(self):
        """Between them some contacts lie on different ones, so that no path joins them."""
        mesh = shapes.torus(24, 10)
        self.write("overlapping.off", shapes.joined(mesh, shapes.moved(mesh, 0.5, 0.1, 0.05)))
        done = skeletonize("overlapping.off", "--out", "out", folder=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        results = self.folder / "out" / "overlapping"
        self.assertEqual({entry.name for entry in results.iterdir()}, RESULT_FILES)
        said = report(results)
        self.assertEqual(said["status"], "warning")
        self.assertIn("self_intersections", [warning["code"] for warning in said["warnings"]])

    def test_theta_and_threshold_reach_the_filter(self):
        self.write("torus.off", shapes.torus())
        words = ["--theta", "-0.4", "--eccentricity-threshold", "1.7"]
        done = skeletonize("torus.off", "--out", "out", *words, folder=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        said = report(self.folder / "out" / "torus")
        self.assertEqual(said["theta"], -0.4)
        self.assertEqual(said["segmentation"]["eccentricity_threshold"], 1.7)

    def test_names_with_special_characters(self):
        names = ["-two words", 'quote " & <tag>', "größe 漢字", "back\\slash", "a.b.c"]
        for name in names:
            self.write(f"{name}.off", shapes.torus())
        inputs = [f"{name}.off" for name in names]
        done = skeletonize("--out=-out ü <&>", "--", *inputs, folder=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in names:
            results = self.folder / "-out ü <&>" / name
            self.assertEqual({entry.name for entry in results.iterdir()}, RESULT_FILES)

    def test_another_reader_opens_the_segmentation(self):
        from vtkmodules.vtkIOPLY import vtkPLYReader

        mesh = shapes.torus()
        self.write("torus.off", mesh)
        done = skeletonize("torus.off", "--out", "out", folder=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        reader = vtkPLYReader()
        reader.SetFileName(os.fspath(self.folder / "out" / "torus" / "segmentation.ply"))
        reader.Update()
        read = reader.GetOutput()
        self.assertEqual(read.GetNumberOfPoints(), len(mesh[0]))
        triangles = []
        for i in range(read.GetNumberOfCells()):
            ids = read.GetCell(i).GetPointIds()
            triangles.append(tuple(ids.GetId(k) for k in range(ids.GetNumberOfIds())))
        self.assertEqual(triangles, mesh[1])


class Failures(HostTest):
    def test_a_bad_input_is_named_with_its_reason_and_the_others_are_done(self):
        self.write("good.off", shapes.torus())
        self.write("open.off", shapes.open_torus())
        (self.folder / "text.ply").write_text("this is no mesh\n")
        inputs = ["open.off", "missing.off", "text.ply", "good.off"]
        done = skeletonize(*inputs, "--out", "out", folder=self.folder)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(done.stderr, r"open\.off: .*(hole|boundary|open|closed)")
        self.assertRegex(done.stderr, r"missing\.off: there is no such file")
        self.assertRegex(done.stderr, r"text\.ply: line 1: 'ply' should stand here")
        self.assertNotIn("good.off", done.stderr)
        self.assertEqual(report(self.folder / "out" / "good")["status"], "ok")
        for stem in ("open", "missing", "text"):
            results = self.folder / "out" / stem
            self.assertEqual([entry.name for entry in results.iterdir()], ["report.json"])
            self.assertEqual(report(results)["status"], "failed")
            self.assertTrue(report(results)["error"]["code"])

    def test_each_kind_of_broken_mesh_is_refused_with_count_and_remedy(self):
        meshes = shapes.broken_meshes()
        inputs = [self.write(f"{name}.off", mesh) for name, mesh, _ in meshes]
        inputs.append(self.folder / "empty.off")
        inputs[-1].touch()
        done = skeletonize(*inputs, "--out", "out", folder=self.folder)
        self.assertEqual(done.returncode, 1, done.stderr)
        for name, _, reason in [*meshes, ("empty", None, "the file is empty")]:
            with self.subTest(mesh=name):
                self.assertRegex(done.stderr, rf"{name}\.off: .*{reason}")
                results = self.folder / "out" / name
                self.assertEqual([entry.name for entry in results.iterdir()], ["report.json"])
                self.assertRegex(report(results)["error"]["message"], reason)

    def test_a_failure_clears_away_the_results_of_an_earlier_run_and_nothing_else(self):
        self.write("torus.off", shapes.torus())
        skeletonize("torus.off", "--out", "out", folder=self.folder)
        results = self.folder / "out" / "torus"
        (results / "notes.txt").write_text("mine")
        self.write("torus.off", shapes.open_torus())
        done = skeletonize("torus.off", "--out", "out", folder=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(
            {entry.name for entry in results.iterdir()}, {"report.json", "notes.txt"}
        )

    def test_an_interrupted_run_leaves_nothing_and_no_process(self):
        self.write("torus.off", shapes.torus(240, 80))
        running = subprocess.Popen([COMMAND, "torus.off", "--out", "out"], cwd=self.folder)
        deadline = time.monotonic() + 60
        while not list(self.folder.glob("out/.skeletonize-*/script.mlx")):
            self.assertLess(time.monotonic(), deadline, "the run never began")
            time.sleep(0.02)
        running.send_signal(signal.SIGTERM)
        self.assertEqual(running.wait(30), 128 + signal.SIGTERM)
        self.assertEqual(list((self.folder / "out").iterdir()), [])
        for process in pathlib.Path("/proc").glob("[0-9]*/cwd"):
            with contextlib.suppress(OSError):  # it ended, or belongs to somebody else
                self.assertNotIn(os.fspath(self.folder), os.readlink(process))

    def test_wrong_usage_returns_2_and_does_nothing(self):
        self.write("torus.off", shapes.torus())
        self.write("torus.ply", shapes.torus())
        for words in (
            [],
            ["torus.off"],
            ["torus.off", "--out"],
            ["torus.off", "--out", "out", "--theta", "-2"],
            ["torus.off", "--out", "out", "--theta", "much"],
            ["torus.off", "--out", "out", "--eccentricity-threshold", "0"],
            ["torus.off", "--out", "out", "--jobs", "0"],
            ["torus.off", "--out", "out", "--colour", "red"],
            ["torus.off", "torus.ply", "--out", "out"],
        ):
            with self.subTest(words=words):
                done = skeletonize(*words, folder=self.folder)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn("usage: skeletonize", done.stderr)
                self.assertFalse((self.folder / "out").exists())


class Check(HostTest):
    def test_says_what_is_wrong_and_writes_nothing(self):
        self.write("good.off", shapes.torus())
        self.write("open.off", shapes.open_torus())
        before = {entry.name for entry in self.folder.iterdir()}
        good = skeletonize("--check", "good.off", folder=self.folder)
        self.assertEqual(good.returncode, 0, good.stderr)
        bad = skeletonize("--check", "open.off", folder=self.folder)
        self.assertEqual(bad.returncode, 1, bad.stdout)
        self.assertRegex(bad.stdout, r"open\.off: error \| \w+ \| \d+ \| ")
        self.assertEqual({entry.name for entry in self.folder.iterdir()}, before)


if __name__ == "__main__":
    unittest.main()
