# SPDX-License-Identifier: BSD-3-Clause
"""Inside Blender: drawing.glb of a folder has the links, points and lengths of drawing.json.

  blender --background --factory-startup --python-exit-code 1 --python glb_in_blender.py -- folder
"""

import json
import sys
from pathlib import Path

import bpy
import numpy
from mathutils import Vector

# Blender 3.4 of Debian 12 asks for a name that its numpy no longer has.
if not hasattr(numpy, "bool"):
    numpy.bool = bool

FOLDER = Path(sys.argv[sys.argv.index("--") + 1])
# Floats around (1000, -2000, 50), where Blender adds the translation in single precision.
PLACE = 2e-4


def places(thing):
    return [thing.matrix_world @ vertex.co for vertex in thing.data.vertices]


def check_near(found, expected, tolerance, what):
    assert abs(found - expected) <= tolerance, f"{what}: {found} instead of {expected}"


def main():
    expected = json.loads((FOLDER / "drawing.json").read_text())
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=str(FOLDER / "drawing.glb"))
    bpy.context.view_layer.update()
    things = bpy.data.objects
    links = [things[f"link_{k}"] for k in range(expected["links"])]
    assert len(things) == len(links) + 3, [thing.name for thing in things]
    lower, upper = Vector([float("inf")] * 3), Vector([float("-inf")] * 3)
    for k, link in enumerate(links):
        assert link["link"] == k and link.parent == things["drawing"]
        assert len(link.data.vertices) == expected["vertices"][k], link.name
        assert len(link.data.edges) == expected["edges"][k], link.name
        assert len(link.data.polygons) == 0
        # Lengths of the local vertices have all digits of the file.
        vertices = [vertex.co for vertex in link.data.vertices]
        length = sum((vertices[a] - vertices[b]).length for a, b in (edge.vertices for edge in link.data.edges))
        check_near(length, expected["length"][k], 1e-5 * expected["length"][k], link.name)
        check_near(link["length"], expected["length"][k], 1e-5 * expected["length"][k], link.name)
        for place in places(link):
            lower = Vector(map(min, lower, place))
            upper = Vector(map(max, upper, place))
    for axis in range(3):
        check_near(lower[axis], expected["min"][axis], PLACE, "box")
        check_near(upper[axis], expected["max"][axis], PLACE, "box")
    assert links[3]["primitive"] == "circle" and links[3]["closed"]
    assert len(things["junctions"].data.vertices) == expected["junctions"]
    assert len(things["cloud"].data.vertices) == expected["cloud"]
    total = sum(expected["length"])
    print(f"Blender {bpy.app.version_string}: {len(links)} links, {sum(expected['edges'])} edges, length {total:.6f}")


main()
