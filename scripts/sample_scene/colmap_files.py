# SPDX-License-Identifier: BSD-3-Clause
"""Writers of COLMAP's model files and depth maps, and of the PLY files of the truth. Needs numpy only."""

import struct

import numpy as np

MODEL_IDS = {"PINHOLE": 1, "OPENCV": 4, "EQUIRECTANGULAR": 17}


def quaternion(rotation):
    """(w, x, y, z) of a rotation matrix, w >= 0."""
    r = rotation
    trace = np.trace(r)
    # 4 q q^T, entry by entry; its row with the largest diagonal is the best conditioned multiple of q.
    outer = np.empty((4, 4))
    outer[1:, 1:] = r + r.T + (1 - trace) * np.eye(3)
    outer[0, 0] = 1 + trace
    outer[0, 1:] = outer[1:, 0] = r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]
    q = outer[np.argmax(np.diag(outer))]
    q = q / np.linalg.norm(q)
    return -q if q[0] < 0 else q


def write_binary_model(folder, model, size, parameters, images, observations=None, points=()):
    """One camera (id 1); `images` is a list of (name, R, t); ids count from 1.

    `observations` has, per image, a list of (x, y, point id); `points` is a list of
    (id, xyz, rgb, error, [(image id, index of the observation)]).
    """
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / "cameras.bin", "wb") as file:
        file.write(struct.pack("<QIiQQ", 1, 1, MODEL_IDS[model], *size))
        file.write(struct.pack(f"<{len(parameters)}d", *parameters))
    with open(folder / "images.bin", "wb") as file:
        file.write(struct.pack("<Q", len(images)))
        for number, (name, rotation, translation) in enumerate(images, 1):
            seen = observations[number - 1] if observations else []
            file.write(struct.pack("<I7dI", number, *quaternion(rotation), *translation, 1))
            file.write(name.encode() + b"\0" + struct.pack("<Q", len(seen)))
            for observation in seen:
                file.write(struct.pack("<ddQ", *observation))
    with open(folder / "points3D.bin", "wb") as file:
        file.write(struct.pack("<Q", len(points)))
        for point_id, xyz, rgb, error, track in points:
            file.write(struct.pack("<Q3d3BdQ", point_id, *xyz, *rgb, error, len(track)))
            for element in track:
                file.write(struct.pack("<II", *element))


def write_text_model(folder, model, size, parameters, images, ids=None):
    """The same as text, without points; `ids` numbers the images (default: from 1)."""
    folder.mkdir(parents=True, exist_ok=True)
    numbers = " ".join(repr(float(p)) for p in parameters)
    (folder / "cameras.txt").write_text(
        f"# CAMERA_ID MODEL WIDTH HEIGHT PARAMS[]\n1 {model} {size[0]} {size[1]} {numbers}\n")
    lines = ["# IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME; then POINTS2D[] as X Y POINT3D_ID (none)"]
    for number, (name, rotation, translation) in zip(ids or range(1, len(images) + 1), images):
        pose = " ".join(repr(float(v)) for v in (*quaternion(rotation), *translation))
        lines += [f"{number} {pose} 1 {name}", ""]
    (folder / "images.txt").write_text("\n".join(lines) + "\n")
    (folder / "points3D.txt").write_text("# no points\n")


def write_depth_map(path, depth):
    """COLMAP's depth map: header `width&height&1&`, then float32 rows."""
    path.parent.mkdir(parents=True, exist_ok=True)
    height, width = depth.shape
    with open(path, "wb") as file:
        file.write(f"{width}&{height}&1&".encode() + depth.astype("<f4").tobytes())


def write_curves(path, polylines, comments=()):
    """Polylines as a binary PLY with vertex (double x y z) and edge (int vertex1 vertex2) elements.

    Vertices of a polyline are consecutive; a closed one repeats its first vertex.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    vertices = np.concatenate([np.asarray(p, float) for p in polylines]) if polylines else np.zeros((0, 3))
    edges, first = [], 0
    for polyline in polylines:
        index = np.arange(first, first + len(polyline) - 1)
        edges.append(np.stack([index, index + 1], 1))
        first += len(polyline)
    edges = np.concatenate(edges) if edges else np.zeros((0, 2))
    header = ["ply", "format binary_little_endian 1.0", *(f"comment {line}" for line in comments),
              f"element vertex {len(vertices)}", "property double x", "property double y", "property double z",
              f"element edge {len(edges)}", "property int vertex1", "property int vertex2", "end_header"]
    with open(path, "wb") as file:
        file.write(("\n".join(header) + "\n").encode())
        file.write(vertices.astype("<f8").tobytes() + edges.astype("<i4").tobytes())


def read_curves(path):
    """Inverse of write_curves."""
    data = path.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    counts = [int(line.split()[2]) for line in data[:end].decode().splitlines() if line.startswith("element")]
    vertices = np.frombuffer(data, "<f8", 3 * counts[0], end).reshape(-1, 3)
    edges = np.frombuffer(data, "<i4", 2 * counts[1], end + 24 * counts[0]).reshape(-1, 2)
    breaks = np.nonzero(np.diff(edges[:, 0]) != 1)[0] + 1
    return [vertices[np.append(part[:, 0], part[-1, 1])] for part in np.split(edges, breaks)]
