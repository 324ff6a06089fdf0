#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Check the layer rule: a module includes lower layers and itself only, and what includes what is no loop.

The layers of src/limn are those of src/README.md, the layers of colmap_ext those of
colmap_ext/docs/developing.md. Every module must have a layer here, and the order of the CMakeLists.txt
beside the modules must follow the layers. A header and the source beside it are one room: no room may include itself by
way of others, in one folder or across several. Some folders have a door, the one header that others include.
Third-party libraries are used only where the tables below allow it, and so is POSIX, which no header may include.
"""

import re
import sys
from pathlib import Path

# Modules of one layer must not include each other.
LIMN_LAYERS = [
    ["util"],
    ["files"],
    ["geometry"],
    ["model"],
    ["support", "visibility"],
    ["topology"],
    ["edges", "linking", "sketch", "drawing", "refinement", "belief", "rods", "primitives", "kinds", "dense",
     "tiles", "alignment"],
    ["regularity", "surfaces", "editing", "plans", "paper", "cameras"],
    ["formats"],
    ["cache", "pictures", "evaluation", "viewer"],
    ["pipeline"],
]
COLMAP_EXT_LAYERS = [
    ["options", "model"],
    ["workspace"],
    ["dense_files", "import"],
    ["host"],
    ["verbs", "plugins"],
    ["commands", "adapter"],
    ["python"],
]
# Folder of modules -> its layers. src/limn never includes colmap_ext.
LAYERS = {"src/limn": LIMN_LAYERS, "colmap_ext": COLMAP_EXT_LAYERS}

# Folder -> the one header of it that is included from outside.
DOORS = {
    "limn/formats/step": "step_drawing_writer.h",
    "limn/formats/svg": "svg_drawing_writer.h",
    "limn/formats/dxf": "dxf_drawing_writer.h",
}

# Headers of POSIX, Linux and signals. What other systems need instead is a matter of these folders (see Porting in
# colmap_ext/docs/developing.md), and of their sources only: anybody may include their headers.
POSIX = ("aio.h", "arpa/", "csignal", "dirent.h", "dlfcn.h", "err.h", "execinfo.h", "fcntl.h", "fnmatch.h", "ftw.h",
         "getopt.h", "glob.h", "grp.h", "iconv.h", "langinfo.h", "libgen.h", "mqueue.h", "net/", "regex.h", "linux/", "netdb.h", "netinet/", "poll.h", "pthread.h", "pwd.h", "sched.h", "semaphore.h", "signal.h",
         "spawn.h", "strings.h", "sys/", "syslog.h", "termios.h", "ucontext.h", "unistd.h", "utime.h", "wordexp.h")
POSIX_FOLDERS = ["src/limn/files/", "colmap_ext/host/"]

# Prefix of an include in angle brackets -> where it may stand: folders, or single files.
THIRD_PARTY = {
    **{prefix: POSIX_FOLDERS for prefix in POSIX},
    "opencv2/": ["src/limn/pictures/", "colmap_ext/workspace/"],
    "unicode/": ["colmap_ext/workspace/name_encoding.cc"],
    "jpeglib.h": ["colmap_ext/workspace/jpeg_check.cc"],
    "sqlite3.h": ["colmap_ext/workspace/pose_priors.cc"],
    "jerror.h": ["colmap_ext/workspace/jpeg_check.cc"],
    "ceres/": ["src/limn/refinement/", "src/limn/primitives/", "src/limn/kinds/round_body_fit.cc", "src/limn/regularity/"],
    "flann/": ["src/limn/geometry/kd_tree_of_flann.h"],
    "nanoflann.hpp": ["src/limn/geometry/kd_tree_of_nanoflann.h"],
    "tbb/": ["src/limn/util/parallel.cc"],
    "oneapi/tbb": ["src/limn/util/parallel.cc"],
    "boost/geometry/": ["src/limn/geometry/box_index2d.cc", "src/limn/geometry/triangle_index.cc"],
    "boost/program_options": ["colmap_ext/options/"],
    "boost/mpi/": ["colmap_ext/plugins/mpi.cc"],
    "boost/dll/": ["colmap_ext/host/plugin.cc", "colmap_ext/plugins/"],
    **{prefix: ["colmap_ext/adapter/"] for prefix in ("colmap/", "base/", "util/")},
    "glog/": ["colmap_ext/adapter/", "src/limn/util/quiet_solver.cc"],
    "boost/sort/": ["src/limn/edges/edgel_selection.cc"],
    "pybind11/": ["colmap_ext/python/"],
    "tiny_gltf.h": ["src/limn/formats/glb_drawing_writer.cc"],
    # OpenCASCADE: its headers are in no folder.
    **{prefix: ["src/limn/formats/step/"]
       for prefix in ("Step", "STEP", "Geom", "GC_", "gp_", "TCol", "Standard_", "Interface_", "APIHeader", "Top",
                      "BRep", "Shape", "Transfer_", "Precision")},
}

# Made by the build, of no module.
GENERATED = {"limn/version.h", "limn/commit.h", "limn/libraries.h"}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def layer_of(folder, module):
    for layer, modules in enumerate(LAYERS[folder]):
        if module in modules:
            return layer
    return None


def third_party_problem(path, target):
    for prefix, places in THIRD_PARTY.items():
        if target.startswith(prefix) and not any(path.startswith(place) for place in places):
            return f"<{target}> belongs to {', '.join(places)}"
    if target.startswith(POSIX) and path.endswith(".h"):
        return f"<{target}> belongs to sources: others include this header"
    return None


def module_problem(path, target):
    """Of an include of a file of Limn's."""
    folder = "src/limn" if path.startswith("src/") else "colmap_ext"
    if not target.startswith(("limn/", "colmap_ext/")):
        return f'"{target}" is of neither limn/ nor colmap_ext/'
    if not target.startswith(folder.split("/")[-1] + "/"):
        return "src/ never includes colmap_ext/" if folder == "src/limn" else None
    if target in GENERATED:
        return None
    parts = target.split("/")
    if len(parts) < 3:
        return f'"{target}" is not of the form "{parts[0]}/<module>/<file>"'
    own_parts = path.removeprefix(folder + "/").split("/")
    if len(own_parts) == 1:  # main.cc
        return None
    own, other = own_parts[0], parts[1]
    if own == other:
        return None
    own_layer, other_layer = layer_of(folder, own), layer_of(folder, other)
    if own_layer is None or other_layer is None:
        return f"module {own if own_layer is None else other} has no layer in this script"
    if other_layer >= own_layer:
        return f"{own} (layer {own_layer}) must not include {other} (layer {other_layer})"
    return None


def door_problem(path, target):
    folder, _, name = target.rpartition("/")
    if folder not in DOORS or name == DOORS[folder] or path.startswith(f"src/{folder}/"):
        return None
    return f"{folder}/ is entered by {DOORS[folder]}, not by {name}"


def problems_of_file(root, file):
    path = file.relative_to(root).as_posix()
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        bracket, target = match.groups()
        check = third_party_problem if bracket == "<" else module_problem
        problem = check(path, target) or door_problem(path, target)
        if problem:
            yield f"{path}:{number}: {problem}"


def problems_of_build_order(root, folder):
    """The order of the folder's CMakeLists.txt must be bottom to top."""
    path = f"{folder}/CMakeLists.txt"
    listed = re.findall(r"^add_subdirectory\((\w+)\)", (root / path).read_text(encoding="utf-8"), re.M)
    previous = 0
    for module in listed:
        layer = layer_of(folder, module)
        if layer is None:
            yield f"{path}: module {module} has no layer in this script"
            continue
        if layer < previous:
            yield f"{path}: {module} stands above its layer"
        previous = layer


def room_of(include):
    """What a file is called in includes, without its suffix: a header and its source are one room."""
    return include.rpartition(".")[0]


def rooms_of(root, files):
    """Room -> the other rooms that it includes."""
    rooms = {}
    for file in files:
        room = room_of(file.relative_to(root).as_posix().removeprefix("src/"))
        includes = rooms.setdefault(room, set())
        for line in file.read_text(encoding="utf-8").splitlines():
            match = INCLUDE.match(line)
            if match and match[1] == '"':
                includes.add(room_of(match[2]))
    return {room: sorted(other for other in includes
                         if other in rooms and other != room)
            for room, includes in rooms.items()}


def path_between(rooms, start, end):
    """The shortest way from one room to another; none if there is none."""
    before = {start: None}
    queue = [start]
    for room in queue:
        if room == end:
            path = []
            while room is not None:
                path.append(room)
                room = before[room]
            return path[::-1]
        for other in rooms[room]:
            if other not in before:
                before[other] = room
                queue.append(other)
    return None


def loops(rooms):
    """A loop for every room that has one and is in no loop before it, shortest way round."""
    # Only rooms that include something, and are included, can be in a loop.
    left = dict(rooms)
    while True:
        included = {other for includes in left.values() for other in includes}
        kept = {room: [other for other in includes if other in left] for room, includes in left.items()
                if room in included}
        kept = {room: includes for room, includes in kept.items() if includes}
        if kept == left:
            break
        left = kept
    seen = set()
    for room in sorted(left):
        ways = [path for other in left[room] if (path := path_between(left, other, room))]
        if not ways or room in seen:
            continue
        way = [room, *min(ways, key=len)]
        seen.update(way)
        yield "a loop of includes: " + " -> ".join(way)


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent).resolve()
    files = sorted(file for folder in ("src", "colmap_ext") for file in (root / folder).rglob("*")
                   if file.suffix in (".h", ".cc"))
    problems = [problem for folder in LAYERS for problem in problems_of_build_order(root, folder)]
    for file in files:
        problems.extend(problems_of_file(root, file))
    problems.extend(loops(rooms_of(root, files)))
    for problem in problems:
        print(problem)
    print(f"{len(files)} files, {len(problems)} problems")
    return 1 if problems or not files else 0


if __name__ == "__main__":
    sys.exit(main())
