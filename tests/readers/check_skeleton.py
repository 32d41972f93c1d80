#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens the files of a folder with software that isn't ours and checks that all tell the same.

Usage: check_skeleton.py FOLDER

Readers: VTK (PLY, VTP), meshio (PLY of triangles), networkx (GraphML), numpy (SWC), and Python's
csv and json. The counts come from report.json; any difference ends the run with status 1.
"""

import collections
import csv
import json
import sys
from pathlib import Path

import meshio
import networkx
import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy


def read_vtk(reader, path):
    """The poly data that a VTK reader finds, with its complaints turned into failures."""
    complaints = []
    reader.AddObserver("ErrorEvent", lambda *_: complaints.append("error"))
    reader.AddObserver("WarningEvent", lambda *_: complaints.append("warning"))
    reader.SetFileName(str(path))
    reader.Update()
    assert not complaints, f"VTK complains about {path.name}"
    return reader.GetOutput()


def columns(attributes):
    """The arrays of VTK point or cell data by name."""
    return {
        attributes.GetArrayName(i): vtk_to_numpy(attributes.GetArray(i))
        for i in range(attributes.GetNumberOfArrays())
    }


def check_vtp(folder, report):
    data = read_vtk(vtk.vtkXMLPolyDataReader(), folder / "skeleton.vtp")
    assert data.GetNumberOfPoints() == report["skeleton"]["nodes"]
    assert data.GetNumberOfLines() == report["skeleton"]["edges"]
    nodes = columns(data.GetPointData())
    edges = columns(data.GetCellData())
    assert set(nodes) == {"radius", "mgf", "eccentricity", "branch", "kind"}
    if data.GetNumberOfLines() > 0:
        assert set(edges) == {"mgf", "eccentricity", "girth", "theta_birth", "branch",
                              "circumference"}
        ends = vtk_to_numpy(data.GetLines().GetConnectivityArray())
        edges["ends"] = ends.reshape(-1, 2)
    points = vtk_to_numpy(data.GetPoints().GetData())
    assert numpy.isfinite(points).all()
    return points, nodes, edges


def check_graphml(folder, report, points, nodes, edges):
    graph = networkx.read_graphml(folder / "skeleton.graphml", force_multigraph=True)
    assert not graph.is_directed()
    assert graph.number_of_nodes() == report["skeleton"]["nodes"]
    assert graph.number_of_edges() == report["skeleton"]["edges"]
    components = networkx.number_connected_components(graph)
    loops = graph.number_of_edges() - graph.number_of_nodes() + components
    assert components == report["skeleton"]["b0"]
    assert loops == report["skeleton"]["b1"]
    degrees = [degree for _, degree in graph.degree()]
    assert sum(degree == 1 for degree in degrees) == report["skeleton"]["leaves"]
    assert sum(degree > 2 for degree in degrees) == report["skeleton"]["junctions"]
    for i in range(len(points)):
        node = graph.nodes[f"n{i}"]
        assert (node["x"], node["y"], node["z"]) == tuple(points[i])
        for name, values in nodes.items():
            assert node[name] == values[i], (name, i)
    seen = collections.Counter()
    for a, b, key, data in graph.edges(keys=True, data=True):
        i = int(key[1:])
        seen[i] += 1
        assert {a, b} == {f"n{end}" for end in edges["ends"][i]}
        for name in ("mgf", "eccentricity", "girth", "theta_birth", "branch", "circumference"):
            assert data[name] == edges[name][i], (name, i)
    assert all(count == 1 for count in seen.values())


def check_swc(folder, report, points):
    table = numpy.loadtxt(folder / "skeleton.swc", comments="#", ndmin=2)
    assert table.shape == (report["skeleton"]["nodes"], 7)
    assert (table[:, 0] == numpy.arange(1, len(table) + 1)).all()
    assert (table[:, 6] < table[:, 0]).all(), "a parent comes after its child"
    assert (table[:, 6] == -1).sum() == report["skeleton"]["b0"]
    assert sorted(map(tuple, table[:, 2:5])) == sorted(map(tuple, points))
    assert (table[:, 5] >= 0).all()
    with open(folder / "skeleton.swc", encoding="ascii") as file:
        cuts = [line for line in file if line.startswith("# cut ")]
    assert len(cuts) == report["skeleton"]["b1"]


def check_csv(folder, report):
    with open(folder / "branches.csv", newline="", encoding="ascii") as file:
        rows = list(csv.DictReader(file, strict=True))
    assert len(rows) == len(report["branches"])
    for row, branch in zip(rows, report["branches"]):
        assert set(row) == set(branch)
        for name, text in row.items():
            value = branch[name]
            assert float(text) == (-1 if value is None else float(value)), name
    return rows


def check_ply_surface(path):
    """A mesh as VTK reads it."""
    data = read_vtk(vtk.vtkPLYReader(), path)
    assert data.GetNumberOfPoints() > 0
    assert data.GetNumberOfCells() > 0
    assert numpy.isfinite(vtk_to_numpy(data.GetPoints().GetData())).all()
    return data


def check_ply_files(folder, report):
    for name in ("skeleton.ply", "skeleton_smooth.ply", "circles.ply"):
        data = read_vtk(vtk.vtkPLYReader(), folder / name)  # VTK reads no edges from PLY
        if name == "skeleton.ply":
            assert data.GetNumberOfPoints() == report["skeleton"]["nodes"]
    medial_axis = check_ply_surface(folder / "medial_axis.ply")
    assert medial_axis.GetNumberOfPoints() == report["medial_axis"]["vertices"]
    assert medial_axis.GetNumberOfPolys() == report["medial_axis"]["facets"]
    for name in ("segmentation.ply", "parts.ply"):
        mesh = check_ply_surface(folder / name)
        assert mesh.GetNumberOfPoints() == report["input"]["vertices"]
        assert mesh.GetNumberOfPolys() == report["input"]["faces"]
        colours = columns(mesh.GetCellData())["RGB"]
        assert colours.shape == (report["input"]["faces"], 3)


def check_tubes(folder):
    tubes = check_ply_surface(folder / "tubes.ply")
    assert columns(tubes.GetPointData())["RGB"].shape[1] == 3
    mesh = meshio.read(folder / "tubes.ply")
    assert len(mesh.points) == tubes.GetNumberOfPoints()
    assert [block.type for block in mesh.cells] == ["triangle"]
    assert len(mesh.cells[0].data) == tubes.GetNumberOfPolys()
    assert {"quality", "red", "green", "blue"} <= set(mesh.point_data)
    edges = vtk.vtkFeatureEdges()
    edges.SetInputData(tubes)
    edges.FeatureEdgesOff()
    edges.BoundaryEdgesOn()
    edges.NonManifoldEdgesOn()
    edges.ManifoldEdgesOff()
    edges.Update()
    assert edges.GetOutput().GetNumberOfCells() == 0, "the tubes are not closed"


def refuse(text):
    raise ValueError(f"{text} is no JSON")


def main(folder):
    report = json.loads((folder / "report.json").read_text(encoding="utf-8"),
                        parse_constant=refuse)
    points, nodes, edges = check_vtp(folder, report)
    check_graphml(folder, report, points, nodes, edges)
    check_swc(folder, report, points)
    check_csv(folder, report)
    check_ply_files(folder, report)
    check_tubes(folder)
    leftovers = [path.name for path in folder.iterdir() if path.name.startswith(".")]
    assert not leftovers, leftovers


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]))
