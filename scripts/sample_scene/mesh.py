# SPDX-License-Identifier: BSD-3-Clause
"""Writes the surfaces of the sample scene as one mesh, an input for `limn truth_extractor`.

  /usr/bin/python3 mesh.py --output datasets/sample/truth/mesh.ply

The polygons of the solids and the ground; solids share no vertices. Needs numpy only.
"""

import argparse
import struct
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import scene  # noqa: E402

GROUND_HALF_SIZE = 60.0


def surfaces(solids):
    """Vertices (world) and faces of the solids and the ground."""
    vertices, faces = [], []
    for solid in solids:
        local, solid_faces = solid.mesh()
        first = len(vertices)
        vertices += [tuple(v) for v in solid.pose.to_world(local)]
        faces += [[first + i for i in face] for face in solid_faces]
    first, h = len(vertices), GROUND_HALF_SIZE
    vertices += [(-h, -h, 0.0), (h, -h, 0.0), (h, h, 0.0), (-h, h, 0.0)]
    faces.append([first, first + 1, first + 2, first + 3])
    return vertices, faces


def write_mesh(path, vertices, faces, comment):
    """Binary PLY with vertex (double x y z) and face (list ushort int vertex_indices) elements."""
    header = ["ply", "format binary_little_endian 1.0", f"comment {comment}", f"element vertex {len(vertices)}",
              "property double x", "property double y", "property double z",
              f"element face {len(faces)}", "property list ushort int vertex_indices", "end_header"]
    with open(path, "wb") as file:
        file.write(("\n".join(header) + "\n").encode())
        for vertex in vertices:
            file.write(struct.pack("<3d", *vertex))
        for face in faces:
            file.write(struct.pack(f"<H{len(face)}i", len(face), *face))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--output", type=Path, required=True)
    arguments = parser.parse_args()
    vertices, faces = surfaces(scene.solids())
    write_mesh(arguments.output, vertices, faces, "Limn sample scene: all surfaces, without paint")
    print(f"{arguments.output}: {len(vertices)} vertices, {len(faces)} faces")


if __name__ == "__main__":
    main()
