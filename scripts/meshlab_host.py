# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the staged MeshLab from scripts: meshlabserver, and the window by its driver.

Both want a display with OpenGL; each run gets one of its own, so it doesn't matter whether the
machine has any, and nothing is seen on the user's.
"""

import contextlib
import json
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import threading

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = pathlib.Path(os.environ.get("MGF_BUILD_DIR", ROOT / "build"))
STAGE = BUILD / "stage"
MESH_TO_PLY = BUILD / "bin" / "mesh_to_ply"
FILTER_SCRIPT = BUILD / "bin" / "filter_script"
EXPORT_FILTER = "Export Curve Skeleton Files"
CHECK_FILTER = "Check Mesh for Curve Skeleton"


class HostError(Exception):
    """A program of ours or of MeshLab's failed; the text says what it said."""


def require_build():
    """Throws HostError when there is no staged MeshLab."""
    for program in (STAGE / "bin" / "meshlabserver", MESH_TO_PLY, FILTER_SCRIPT):
        if not program.exists():
            raise HostError(f"{program} is missing; run scripts/build first")


class Interrupted(Exception):
    """`stop_all` ended what was running."""


class _Children:
    """The processes that run now, so that an interrupt can end them from another thread."""

    def __init__(self):
        self._lock = threading.Lock()
        self._processes = set()
        self._stopped = False

    @contextlib.contextmanager
    def running(self, command, **options):
        """A process that doesn't outlive the context. Throws Interrupted when it was stopped."""
        with self._lock:
            if self._stopped:
                raise Interrupted()
            process = subprocess.Popen(
                [os.fspath(word) for word in command],
                stdin=subprocess.DEVNULL,
                start_new_session=True,
                **options,
            )
            self._processes.add(process)
        try:
            yield process
        finally:
            _kill(process)
            process.wait()
            with self._lock:
                self._processes.discard(process)
            if self._stopped:  # whatever else went wrong, went wrong for this
                raise Interrupted()

    def stop(self):
        with self._lock:
            self._stopped = True
            for process in self._processes:
                _kill(process)


def _kill(process):
    """Ends a process with all its children; does nothing when it has ended."""
    if process.poll() is None:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)


_children = _Children()
stop_all = _children.stop


def run(command, **options):
    """The output of a command, standard error included, and its exit status."""
    with _children.running(
        command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **options
    ) as process:
        output, _ = process.communicate()
    return output.decode(errors="replace"), process.returncode


@contextlib.contextmanager
def display(size="1280x960"):
    """A display that nobody sees, for as long as the context lasts; gives its name."""
    if shutil.which("Xvfb") is None:
        raise HostError("there is no Xvfb; run scripts/setup first")
    reader, writer = os.pipe()
    with _children.running(
        ["Xvfb", "-displayfd", str(writer), "-screen", "0", f"{size}x24", "-nolisten", "tcp"],
        pass_fds=[writer],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    ) as server:
        os.close(writer)
        with os.fdopen(reader) as pipe:
            number = pipe.readline().strip()
        if not number:
            raise HostError("Xvfb does not start")
        try:
            yield f":{number}"
        finally:
            server.terminate()  # so that it takes its lock file away
            server.wait()


def environment(display_name, settings):
    """The variables MeshLab runs with: our display, software OpenGL, and settings of its own, so
    that the user's are neither used nor changed."""
    return {
        **os.environ,
        "DISPLAY": display_name,
        "QT_QPA_PLATFORM": "xcb",
        "LIBGL_ALWAYS_SOFTWARE": "1",
        "LC_ALL": "C.UTF-8",  # paths are decoded by it
        "XDG_CONFIG_HOME": os.fspath(settings),
        "XDG_RUNTIME_DIR": os.fspath(settings),
    }


def filter_script(*words):
    """The .mlx text that runs filters: the name of each, and behind it `key=value` for the parameters
    that aren't to have their defaults. Throws HostError for what the filters don't take."""
    output, status = run([FILTER_SCRIPT, *words])
    if status != 0:
        raise HostError(output.strip())
    return output


def meshlabserver(*arguments, folder):
    """Runs meshlabserver in a folder; gives its output and exit status."""
    with display("64x64") as name, tempfile.TemporaryDirectory() as settings:
        return run(
            [STAGE / "bin" / "meshlabserver", *arguments],
            cwd=folder,
            env=environment(name, settings),
        )


def _paint_background_grey(settings):
    """Both what is white and what is dark stand out against it. MeshLab keeps its settings as XML
    inside an INI file."""
    lines = ["[General]"]
    for end in ("Bot", "Top"):
        xml = f'<Param name="MeshLab::Appearance::background{end}Color" type="RichColor" '
        xml += 'r="205" g="205" b="205" a="255" description="" tooltip=""/>'
        lines.append(f"background{end}=" + json.dumps(xml))
    folder = pathlib.Path(settings) / "VCG"
    folder.mkdir()
    (folder / "MeshLab_64bit_fp.conf").write_text("\n".join(lines) + "\n")


def meshlab_window(files, commands, size="1280x960"):
    """Opens files in MeshLab's window, does what the commands say (scripts/meshlab_driver lists
    them; each is a tuple of words) and gives what was seen, one dictionary a line."""
    with display(size) as name, tempfile.TemporaryDirectory() as settings:
        _paint_background_grey(settings)
        script = pathlib.Path(settings) / "commands"
        transcript = pathlib.Path(settings) / "transcript"
        script.write_text("".join("\t".join(map(str, words)) + "\n" for words in commands))
        output, status = run(
            [STAGE / "bin" / "meshlab", *files],
            env={
                **environment(name, settings),
                "QT_PLUGIN_PATH": os.fspath(BUILD / "qt_plugins"),
                "QT_QPA_GENERIC_PLUGINS": "meshlab_driver",
                "MESHLAB_DRIVER_SCRIPT": os.fspath(script),
                "MESHLAB_DRIVER_TRANSCRIPT": os.fspath(transcript),
            },
        )
        if status != 0 or not transcript.exists():
            raise HostError(f"meshlab ended with status {status}:\n{output}")
        return [json.loads(line) for line in transcript.read_text().splitlines()]
