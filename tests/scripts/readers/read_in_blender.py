# SPDX-License-Identifier: BSD-3-Clause
"""Imports a file into Blender and prints the result as JSON:

  blender --background --factory-startup --python-exit-code 1 --python read_in_blender.py -- file
"""

import json
import sys
from pathlib import Path

import bpy


def import_file(path):
    if path.suffix == ".obj":
        # The file's axes are kept: z is up. The other importer of Blender 3.3 and 3.4 takes one edge per polyline.
        if bpy.app.version < (3, 5, 0):
            bpy.ops.import_scene.obj(filepath=str(path), axis_forward="Y", axis_up="Z")
        else:
            bpy.ops.wm.obj_import(filepath=str(path), forward_axis="Y", up_axis="Z")
    elif path.suffix == ".ply":
        bpy.ops.import_mesh.ply(filepath=str(path))
    else:
        raise SystemExit(f"{path}: no importer known here")


def main():
    path = Path(sys.argv[sys.argv.index("--") + 1])
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    import_file(path)
    objects, low, high = [], [1e30] * 3, [-1e30] * 3
    for thing in bpy.data.objects:
        assert thing.type == "MESH", thing.type
        places = [thing.matrix_world @ vertex.co for vertex in thing.data.vertices]
        ends = [tuple(edge.vertices) for edge in thing.data.edges]
        used = {v for pair in ends for v in pair}
        for v in used:
            low = [min(a, b) for a, b in zip(low, places[v])]
            high = [max(a, b) for a, b in zip(high, places[v])]
        objects.append({"name": thing.name, "vertices": len(places), "used_vertices": len(used), "edges": len(ends),
                        "faces": len(thing.data.polygons),
                        "length": sum((places[a] - places[b]).length for a, b in ends)})
    print("\n" + json.dumps({"objects": objects, "low": low, "high": high}))


main()
