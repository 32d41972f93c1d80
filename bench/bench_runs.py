# SPDX-License-Identifier: GPL-3.0-or-later
"""What the benchmark drivers have in common: programs, meshes, repeated runs, tables."""

import json
import math
import os
import signal
import statistics
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROJECT = HERE.parent
MODELS = PROJECT.parent / "shared" / "models"


class Unavailable(Exception):
    """Something that the benchmark needs is not there."""


def add_common_arguments(parser, runs):
    parser.add_argument("--build", type=Path, default=PROJECT / "build", metavar="DIR",
                        help="CMake's build folder (default: build)")
    parser.add_argument("--runs", type=int, default=runs, metavar="N",
                        help="runs per mesh and program; medians are shown (default: %(default)s)")
    parser.add_argument("--threads", type=int, default=0, metavar="N",
                        help="threads for our program (default: all)")
    parser.add_argument("--limit", type=float, default=900, metavar="S",
                        help="seconds after which a run is given up (default: %(default)s)")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write every run there too")


def program(build, name):
    """The path of a benchmark program."""
    path = build / "bench" / name
    if not path.exists():
        raise Unavailable(f"{path} is missing: build it with -DMGF_BUILD_BENCH=ON")
    return str(path)


def model(name):
    """The path of a mesh that several issues share, or None."""
    path = MODELS / f"{name}.off"
    return path if path.exists() else None


def all_models(scratch):
    """The shared meshes by size; without them the one that the project makes itself."""
    found = sorted(MODELS.glob("*.off"), key=lambda path: path.stat().st_size)
    return found or [made_model(scratch)]


def made_model(scratch):
    """The demo's mesh: some 4000 vertices, flat and tubular parts, a handle."""
    path = Path(scratch) / "demo.off"
    if not path.exists():
        subprocess.run([str(PROJECT / "scripts" / "demo_mesh"), str(path)], check=True)
    return path


def run(command, limit):
    """One run: its line of JSON with the load before it, or {'failed': reason}."""
    load = os.getloadavg()[0]
    try:
        result = subprocess.run(command, capture_output=True, text=True, timeout=limit,
                                check=False)
    except subprocess.TimeoutExpired:
        return {"failed": f"more than {limit:g} s", "load": load}
    if result.returncode < 0:
        return {"failed": signal.Signals(-result.returncode).name, "load": load}
    if result.returncode != 0:
        reason = result.stderr.strip().splitlines() or [f"status {result.returncode}"]
        return {"failed": reason[-1], "load": load}
    return {**json.loads(result.stdout), "load": load}


def alternately(commands, runs, limit):
    """Runs each of the named commands `runs` times, turn by turn; lists of results by name.

    A command that fails is not tried again."""
    results = {name: [] for name in commands}
    for _ in range(runs):
        for name, command in commands.items():
            if not any("failed" in result for result in results[name]):
                results[name].append(run(command, limit))
    return results


def failure(results):
    """Why one of the runs failed, or None."""
    return next((result["failed"] for result in results if "failed" in result), None)


def median(results, *path):
    """The median of a member of the results."""
    def member(result):
        for key in path:
            result = result[key]
        return result
    return statistics.median(member(result) for result in results)


def exponent(sizes, values):
    """The slope of the least-squares line through the logarithms, or None."""
    points = [(math.log(size), math.log(value)) for size, value in zip(sizes, values) if value > 0]
    if len({x for x, _ in points}) < 2:
        return None
    mean_x = statistics.fmean(x for x, _ in points)
    mean_y = statistics.fmean(y for _, y in points)
    return (sum((x - mean_x) * (y - mean_y) for x, y in points) /
            sum((x - mean_x) ** 2 for x, _ in points))


def figures(value):
    """A number with three significant figures, thousands set apart."""
    if value == 0:
        return "0"
    decimals = max(0, 2 - math.floor(math.log10(abs(value))))
    return f"{value:,.{decimals}f}".replace(",", " ")


def show_table(head, rows):
    """Prints a table in Markdown, numbers to the right."""
    print("| " + " | ".join(head) + " |")
    print("|" + "|".join(["---"] + ["---:"] * (len(head) - 1)) + "|")
    for row in rows:
        print("| " + " | ".join(str(cell) for cell in row) + " |")
    print(flush=True)


def show_machine():
    """Prints what the figures were measured on."""
    model_name = "unknown processor"
    for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            model_name = line.split(":", 1)[1].strip()
            break
    load = ", ".join(f"{value:.1f}" for value in os.getloadavg())
    print(f"{model_name}, {os.cpu_count()} threads; load before the first run {load}\n")


def loads(results):
    """The span of the load over many runs, as text."""
    values = [result["load"] for result in results]
    return f"load {min(values):.1f} to {max(values):.1f}"


def main_of(driver):
    """Runs a driver; what is missing is said, with status 2."""
    try:
        sys.exit(driver())
    except Unavailable as reason:
        sys.exit(f"{Path(sys.argv[0]).name}: {reason}")
