"""COLMAP models, Blender's cameras and PLY curves for blender_clean_truth.py. Needs Python only.

A pixel of COLMAP covers [x, x + 1) and so does Blender's: a photograph fills the frame of its camera and no half
pixel is added.
"""

import struct

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
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except OSError as error:
        raise InputError(f"{path}: {error.strerror}") from None
    for number, line in enumerate(lines, 1):
        if not line.startswith("#") and (keep_empty or line.strip()):
            yield number, line.split()


class _Bytes:
    """The values of a little-endian file, one after the other."""

    def __init__(self, path):
        self._path, self._at = path, 0
        try:
            self._bytes = path.read_bytes()
        except OSError as error:
            raise InputError(f"{path}: {error.strerror}") from None

    def take(self, layout):
        size = struct.calcsize("<" + layout)
        self.skip(size)
        return struct.unpack_from("<" + layout, self._bytes, self._at - size)

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
# Curves


def read_curves(path):
    """(vertices, edges, links) of a PLY file as Limn writes it, equal vertices made one; links: one id per edge."""
    try:
        return _read_curves(path)
    except (KeyError, IndexError, ValueError) as error:
        raise InputError(f"{path}: {type(error).__name__} {error}") from None


def _read_curves(path):
    data = _Bytes(path)
    elements = _ply_header(path, data)
    rows = {name: [dict(zip(properties, data.take(layout))) for _ in range(count)]
            for name, count, properties, layout in elements}
    if not rows.get("vertex") or not rows.get("edge"):
        raise InputError(f"{path}: has no vertices or no edges")
    index, vertices, welded = {}, [], []
    for row in rows["vertex"]:
        position = (row["x"], row["y"], row["z"])
        if position not in index:
            index[position] = len(vertices)
            vertices.append(position)
        welded.append(index[position])
    if min(min(row["vertex1"], row["vertex2"]) for row in rows["edge"]) < 0:
        raise InputError(f"{path}: edge to a vertex below 0")
    edges = [(welded[row["vertex1"]], welded[row["vertex2"]]) for row in rows["edge"]]
    return vertices, edges, [row.get("link", 0) for row in rows["edge"]]


def _ply_header(path, data):
    """[(name, count, property names, struct layout)]."""
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
            elements.append([words[1], int(words[2]), [], "<"])
        if words[:1] == ["property"]:
            if words[1] not in PLY_TYPES:
                raise InputError(f"{path}: property {words[-1]} of type {words[1]}")
            elements[-1][2].append(words[2])
            elements[-1][3] += PLY_TYPES[words[1]]
    return [(name, count, names, layout[1:]) for name, count, names, layout in elements]


def write_curves(path, vertices, edges, links):
    """Binary PLY: vertex (double x y z), edge (int vertex1 vertex2 link). Vertices without an edge are left out."""
    used = sorted({vertex for edge in edges for vertex in edge})
    number = {vertex: i for i, vertex in enumerate(used)}
    header = ("ply\nformat binary_little_endian 1.0\ncomment curves cleaned by hand\n"
              f"element vertex {len(used)}\nproperty double x\nproperty double y\nproperty double z\n"
              f"element edge {len(edges)}\nproperty int vertex1\nproperty int vertex2\nproperty int link\nend_header\n")
    body = b"".join(struct.pack("<3d", *vertices[vertex]) for vertex in used)
    body += b"".join(struct.pack("<3i", number[a], number[b], link) for (a, b), link in zip(edges, links))
    partial = path.with_name(path.name + ".tmp")
    partial.write_bytes(header.encode() + body)
    partial.replace(path)


def as_floats(position):
    """The position as Blender stores it."""
    return struct.unpack("<3f", struct.pack("<3f", *position))


def original_or(position, source, originals):
    """The original coordinates of a vertex that is still where it was, else `position`."""
    if 0 <= source < len(originals) and as_floats(originals[source]) == tuple(position):
        return originals[source]
    return tuple(position)
