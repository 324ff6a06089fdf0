# SPDX-License-Identifier: BSD-3-Clause
"""COLMAP models, Blender's cameras, curves and clouds for blender_clean_truth.py. Needs Python only.

A pixel of COLMAP covers [x, x + 1) and so does Blender's: a photograph fills the frame of its camera and no half
pixel is added.
"""

import gzip
import math
import struct
import zlib

# Camera models of COLMAP: name, number of parameters, number of focal lengths; None: never a pinhole.
MODELS = {0: ("SIMPLE_PINHOLE", 3, 1), 1: ("PINHOLE", 4, 2), 2: ("SIMPLE_RADIAL", 4, 1), 3: ("RADIAL", 5, 1),
          4: ("OPENCV", 8, 2), 5: ("OPENCV_FISHEYE", 8, None), 6: ("FULL_OPENCV", 12, 2), 7: ("FOV", 5, None),
          8: ("SIMPLE_RADIAL_FISHEYE", 4, None), 9: ("RADIAL_FISHEYE", 5, None),
          10: ("THIN_PRISM_FISHEYE", 12, None), 11: ("RAD_TAN_THIN_PRISM_FISHEYE", 16, None)}
SENSOR_WIDTH = 36.0
PLY_TYPES = {"char": "b", "int8": "b", "uchar": "B", "uint8": "B", "short": "h", "int16": "h", "ushort": "H",
             "uint16": "H", "int": "i", "int32": "i", "uint": "I", "uint32": "I", "float": "f", "float32": "f",
             "double": "d", "float64": "d"}


class InputError(Exception):
    """A file that cannot be used; the text names it and the reason."""


# ----------------------------------------------------------------------------------------------
# COLMAP


def pinhole(path, name, focal_count, size, parameters):
    """(width, height, fx, fy, cx, cy) of a camera without distortion, COLMAP's pixels."""
    if focal_count is None or any(parameters[focal_count + 2:]):
        raise InputError(f"{path}: camera {name} is no pinhole; undistort the model first (colmap image_undistorter)")
    cx, cy = parameters[focal_count:focal_count + 2]
    return (*size, parameters[0], parameters[focal_count - 1], cx, cy)


def read_cameras(folder):
    """Camera id -> pinhole()."""
    path = folder / "cameras.bin"
    records = _binary_cameras(path) if path.exists() else _text_cameras(folder / "cameras.txt")
    return {number: pinhole(folder, name, focal_count, size, parameters)
            for number, name, focal_count, size, parameters in records}


def _binary_cameras(path):
    data = _Bytes(path)
    for _ in range(data.take("Q")[0]):
        number, model, *size = data.take("IiQQ")
        if model not in MODELS:
            raise InputError(f"{path}: unknown camera model {model}")
        name, count, focal_count = MODELS[model]
        yield number, name, focal_count, size, data.take(f"{count}d")


def _text_cameras(path):
    by_name = {name: (count, focal_count) for name, count, focal_count in MODELS.values()}
    for line_number, words in _text_lines(path):
        try:
            number, name, size = int(words[0]), words[1], [int(words[2]), int(words[3])]
            parameters = [float(word) for word in words[4:]]
        except (ValueError, IndexError) as error:
            raise InputError(f"{path}: line {line_number}: {error}") from None
        if name not in by_name or len(parameters) != by_name[name][0]:
            raise InputError(f"{path}: line {line_number}: camera model {name} with {len(parameters)} parameters")
        yield number, name, by_name[name][1], size, parameters


def read_images(folder):
    """[(name, camera id, (qw, qx, qy, qz), (tx, ty, tz))] of cam_from_world, by name."""
    path = folder / "images.bin"
    return sorted(_binary_images(path) if path.exists() else _text_images(folder / "images.txt"))


def _binary_images(path):
    data = _Bytes(path)
    for _ in range(data.take("Q")[0]):
        _, *pose, camera = data.take("I7dI")
        name = data.text()
        data.skip(24 * data.take("Q")[0])
        yield name, camera, tuple(pose[:4]), tuple(pose[4:])


def _text_images(path):
    """Every other line has the observations, and may be empty."""
    poses = _text_lines(path, keep_empty=True)
    for line_number, words in poses:
        if not words:
            continue
        try:
            pose = [float(word) for word in words[1:8]]
            yield " ".join(words[9:]), int(words[8]), tuple(pose[:4]), tuple(pose[4:])
        except (ValueError, IndexError) as error:
            raise InputError(f"{path}: line {line_number}: {error}") from None
        next(poses, None)


def _text_lines(path, keep_empty=False):
    for number, line in enumerate(_read_bytes(path).decode("utf-8", "replace").splitlines(), 1):
        if not line.startswith("#") and (keep_empty or line.strip()):
            yield number, line.split()


def _read_bytes(path):
    """Content of a file, unpacked if it is called .gz."""
    try:
        data = path.read_bytes()
        return gzip.decompress(data) if path.suffix == ".gz" else data
    except (OSError, EOFError, zlib.error) as error:
        raise InputError(f"{path}: {getattr(error, 'strerror', None) or error}") from None


class _Bytes:
    """The values of a little-endian file, one after the other."""

    def __init__(self, path):
        self._path, self._at, self._bytes = path, 0, _read_bytes(path)

    def take(self, layout):
        return next(self.rows(layout, 1))

    def rows(self, layout, count):
        """An iterator over `count` tuples."""
        size = struct.calcsize("<" + layout) * count
        self.skip(size)
        return struct.iter_unpack("<" + layout, memoryview(self._bytes)[self._at - size:self._at])

    def skip(self, size):
        self._at += size
        if self._at > len(self._bytes):
            raise InputError(f"{self._path}: byte {len(self._bytes)}: the file ends too early")

    def text(self):
        end = self._bytes.find(b"\0", self._at)
        if end < 0:
            raise InputError(f"{self._path}: byte {self._at}: name without an end")
        text, self._at = self._bytes[self._at:end].decode("utf-8"), end + 1
        return text


# ----------------------------------------------------------------------------------------------
# Blender's camera


def lens_settings(camera):
    """Blender's settings for a pinhole(): sensor fit HORIZONTAL, SENSOR_WIDTH; pixel aspects are the scene's."""
    width, height, fx, fy, cx, cy = camera
    aspect = fx / fy  # a pixel's height over its width; Blender takes aspects of 1 or more only
    return {"lens": fx * SENSOR_WIDTH / width,
            "shift_x": (width / 2 - cx) / width,
            "shift_y": (cy - height / 2) * aspect / width,
            "pixel_aspect_x": max(1.0, 1 / aspect),
            "pixel_aspect_y": max(1.0, aspect)}


def camera_matrix(quaternion, translation):
    """Rows of world_from_camera, 4 x 4, for a camera that looks along -z with y up, as Blender's do."""
    w, x, y, z = (value / sum(v * v for v in quaternion) ** 0.5 for value in quaternion)
    rotation = ((1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
                (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
                (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)))
    columns = (rotation[0], [-v for v in rotation[1]], [-v for v in rotation[2]])
    center = [-sum(rotation[k][i] * translation[k] for k in range(3)) for i in range(3)]
    return [[columns[0][i], columns[1][i], columns[2][i], center[i]] for i in range(3)] + [[0.0, 0.0, 0.0, 1.0]]


# ----------------------------------------------------------------------------------------------
# Curves and clouds


def read_shapes(path):
    """(vertices, edges, links) of a file of curves or points; links: one id per edge. Binary PLY as Limn writes it, or
    text, a point per line; also packed (.gz)."""
    unpacked = path.with_suffix("") if path.suffix == ".gz" else path
    if unpacked.suffix in (".txt", ".xyz"):
        return _text_points(path), [], []
    try:
        return _read_ply(path)
    except (KeyError, IndexError, ValueError, struct.error) as error:
        raise InputError(f"{path}: {type(error).__name__} {error}") from None


def read_cloud(path):
    """The vertices of read_shapes(), all of them."""
    vertices = read_shapes(path)[0]
    if not vertices:
        raise InputError(f"{path}: has no points")
    for number, vertex in enumerate(vertices):
        if not all(map(math.isfinite, vertex)):
            raise InputError(f"{path}: point {number} is not finite")
    return vertices


def read_curves(path):
    """read_shapes() of a file that has edges; equal vertices are made one."""
    vertices, edges, links = read_shapes(path)
    if not edges:
        raise InputError(f"{path}: has no vertices or no edges")
    index = {}
    welded = [index.setdefault(vertex, len(index)) for vertex in vertices]
    return list(index), [(welded[a], welded[b]) for a, b in edges], links


def _text_points(path):
    points = []
    for number, words in _text_lines(path):
        try:
            x, y, z = map(float, words[:3])
        except ValueError as error:
            raise InputError(f"{path}: line {number}: {error}") from None
        points.append((x, y, z))
    return points


def _read_ply(path):
    data = _Bytes(path)
    elements = _ply_header(path, data)
    while elements and elements[-1][0] not in ("vertex", "edge"):
        elements.pop()
    columns = {}
    for name, count, properties, layout in elements:
        if "list" in layout:
            raise InputError(f"{path}: {name} has lists")
        columns[name] = dict(zip(properties, zip(*data.rows("".join(layout), count))))
    vertex, edge = columns.get("vertex"), columns.get("edge")
    vertices = list(zip(vertex["x"], vertex["y"], vertex["z"])) if vertex else []
    if not edge:
        return vertices, [], []
    edges = list(zip(edge["vertex1"], edge["vertex2"]))
    if not all(0 <= end < len(vertices) for ends in edges for end in ends):
        raise InputError(f"{path}: edge to a vertex that there is not")
    return vertices, edges, list(edge.get("link", [0] * len(edges)))


def _ply_header(path, data):
    """[(name, count, property names, their struct codes or "list")]."""
    if data.take("4s")[0][:3] != b"ply":
        raise InputError(f"{path}: not a PLY file")
    elements, line = [], ""
    while line != "end_header":
        line = ""
        while not line.endswith("\n"):
            line += data.take("c")[0].decode("latin-1")
        words, line = line.split(), line.strip()
        if words[:1] == ["format"] and words[1:2] != ["binary_little_endian"]:
            raise InputError(f"{path}: is not in the format binary_little_endian")
        if words[:1] == ["element"]:
            elements.append((words[1], int(words[2]), [], []))
            if elements[-1][1] < 0:
                raise InputError(f"{path}: element {words[1]} less than 0 times")
        if words[:1] == ["property"]:
            if words[1] != "list" and words[1] not in PLY_TYPES:
                raise InputError(f"{path}: property {words[-1]} of type {words[1]}")
            elements[-1][2].append(words[-1])
            elements[-1][3].append(PLY_TYPES.get(words[1], "list"))
    return elements


def write_curves(path, vertices, edges, links):
    """Binary PLY: vertex (double x y z), edge (int vertex1 vertex2 link). Vertices without an edge are left out."""
    used = sorted({vertex for edge in edges for vertex in edge})
    number = {vertex: i for i, vertex in enumerate(used)}
    body = b"".join(struct.pack("<3i", number[a], number[b], link) for (a, b), link in zip(edges, links))
    _write_ply(path, "curves", [vertices[vertex] for vertex in used],
               f"element edge {len(edges)}\nproperty int vertex1\nproperty int vertex2\nproperty int link\n", body)


def write_cloud(path, points):
    """Binary PLY (double x y z), or text (.txt) of as many digits as are needed to read the same numbers again."""
    if path.suffix == ".ply":
        _write_ply(path, "points", points, "", b"")
    elif path.suffix == ".txt":
        _write(path, "".join("%r %r %r\n" % tuple(point) for point in points).encode())
    else:
        raise InputError(f"{path}: points are written to .ply or .txt")


def _write_ply(path, what, vertices, more_header, more_body):
    header = (f"ply\nformat binary_little_endian 1.0\ncomment {what} cleaned by hand\n"
              f"element vertex {len(vertices)}\nproperty double x\nproperty double y\nproperty double z\n"
              f"{more_header}end_header\n")
    _write(path, header.encode() + b"".join(struct.pack("<3d", *vertex) for vertex in vertices) + more_body)


def _write(path, content):
    partial = path.with_name(path.name + ".tmp")
    try:
        partial.write_bytes(content)
        partial.replace(path)
    except OSError as error:
        raise InputError(f"{path}: {error.strerror}") from None


def as_floats(position):
    """The position as Blender stores it."""
    return struct.unpack("<3f", struct.pack("<3f", *position))


def original_or(position, source, originals):
    """The original coordinates of a vertex that is still where it was, else `position`."""
    if 0 <= source < len(originals) and as_floats(originals[source]) == tuple(position):
        return originals[source]
    return tuple(position)
