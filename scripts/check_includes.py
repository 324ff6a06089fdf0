#!/usr/bin/env python3
"""Check the layer rule: an include points down or to its own module, never up or sideways.

The layers are those of src/README.md. Every module of src/limn must have a layer here, and
the order of src/limn/CMakeLists.txt must follow the layers.
Third-party libraries stay where the table at the end allows them.
"""

import re
import sys
from pathlib import Path

# Modules of one layer do not see each other.
LAYERS = [
    ["util"],
    ["geometry"],
    ["model"],
    ["support", "visibility"],
    ["edges", "linking", "sketch", "drawing", "refinement", "primitives", "dense", "tiles"],
    ["io"],
    ["export"],
    ["pictures", "evaluation", "viewer"],
    ["pipeline"],
]

# Prefix of an include in angle brackets -> where it may stand: folders, or single files.
THIRD_PARTY = {
    "opencv2/": ["src/limn/pictures/", "colmap_ext/workspace/"],
    "ceres/": ["src/limn/refinement/", "src/limn/primitives/"],
    "flann/": ["src/limn/geometry/spatial_index.cc"],
    "tbb/": ["src/limn/util/parallel.cc"],
    "oneapi/tbb": ["src/limn/util/parallel.cc"],
    "boost/program_options": ["colmap_ext/options/"],
    "boost/mpi/": ["colmap_ext/commands/ranks.cc"],
    "boost/sort/": ["src/limn/edges/edgel_selection.cc"],
    "tiny_gltf.h": ["src/limn/export/drawing_glb.cc"],
    # OpenCASCADE: its headers are in no folder.
    **{prefix: ["src/limn/export/drawing_step.cc", "src/limn/export/step_edges"]
       for prefix in ("Step", "STEP", "Geom", "gp_", "TCol", "Standard_", "Interface_", "APIHeader", "TopoDS", "BRep")},
}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def layer_of(module):
    for layer, modules in enumerate(LAYERS):
        if module in modules:
            return layer
    return None


def third_party_problem(path, target):
    for prefix, places in THIRD_PARTY.items():
        if target.startswith(prefix) and not any(path.startswith(place) for place in places):
            return f"<{target}> belongs to {', '.join(places)}"
    return None


def module_problem(path, target):
    """Of an include of a file of Limn's, seen from a file in src/limn."""
    if target.startswith("colmap_ext/"):
        return "src/ never includes colmap_ext/"
    parts = target.split("/")
    if parts[0] != "limn" or len(parts) < 3:
        return f'"{target}" is not of the form "limn/<module>/<file>"'
    own, other = path.split("/")[2], parts[1]
    if own == other:
        return None
    if layer_of(own) is None or layer_of(other) is None:
        return f"module {own if layer_of(own) is None else other} has no layer in this script"
    if layer_of(other) >= layer_of(own):
        return f"{own} (layer {layer_of(own)}) must not include {other} (layer {layer_of(other)})"
    return None


def problems_of_file(root, file):
    path = file.relative_to(root).as_posix()
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        bracket, target = match.groups()
        if bracket == "<":
            problem = third_party_problem(path, target)
        elif path.startswith("src/"):
            problem = module_problem(path, target)
        else:
            problem = None
        if problem:
            yield f"{path}:{number}: {problem}"


def problems_of_build_order(root):
    """The order of src/limn/CMakeLists.txt must be bottom to top."""
    listed = re.findall(r"^add_subdirectory\((\w+)\)",
                        (root / "src/limn/CMakeLists.txt").read_text(encoding="utf-8"), re.M)
    previous = 0
    for module in listed:
        layer = layer_of(module)
        if layer is None:
            yield f"src/limn/CMakeLists.txt: module {module} has no layer in this script"
            continue
        if layer < previous:
            yield f"src/limn/CMakeLists.txt: {module} stands above its layer"
        previous = layer


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent).resolve()
    files = sorted(file for folder in ("src", "colmap_ext") for file in (root / folder).rglob("*")
                   if file.suffix in (".h", ".cc"))
    problems = list(problems_of_build_order(root))
    for file in files:
        problems.extend(problems_of_file(root, file))
    for problem in problems:
        print(problem)
    print(f"{len(files)} files, {len(problems)} problems")
    return 1 if problems or not files else 0


if __name__ == "__main__":
    sys.exit(main())
