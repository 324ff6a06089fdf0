# SPDX-License-Identifier: BSD-3-Clause
"""A small scene of boxes on a floor, rendered for hostile cases: eight PNG images of 160 x 120 pixels and their model."""

import math
import pathlib
import random
import struct
import sys
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / 'fuzz'))

from hostile_model import Model  # noqa: E402

WIDTH, HEIGHT, FOCAL = 160, 120, 150.0
NUM_VIEWS = 8
SAMPLES = 2  # a side, of a pixel
BACKGROUND = 96
PINHOLE = 1

# (smallest corner, largest corner, gray of the sides x, y and of the top)
BOXES = [((-1.2, -0.8, 0.0), (-0.2, 0.1, 0.9), (40, 85, 215)), ((0.2, -0.9, 0.0), (1.1, -0.2, 0.5), (230, 160, 60)),
         ((0.0, 0.3, 0.0), (0.8, 1.0, 1.1), (25, 200, 130))]
# (corners, gray): paint on the floor and on the boxes
FLOOR = [[(-2.0, -1.8, 0.0), (2.0, -1.8, 0.0), (2.0, 1.8, 0.0), (-2.0, 1.8, 0.0)]]
PAINT = [([(-1.5, 0.5, 0.001), (-0.4, 0.5, 0.001), (-0.4, 1.3, 0.001), (-1.5, 1.3, 0.001)], 20),
         ([(-1.0, -0.6, 0.901), (-0.4, -0.6, 0.901), (-0.4, -0.1, 0.901), (-1.0, -0.1, 0.901)], 30)]


def box_faces(box):
    (x0, y0, z0), (x1, y1, z1), (gray_x, gray_y, gray_top) = box
    return [([(x0, y0, z0), (x0, y1, z0), (x0, y1, z1), (x0, y0, z1)], gray_x),
            ([(x1, y0, z0), (x1, y1, z0), (x1, y1, z1), (x1, y0, z1)], gray_x + 15),
            ([(x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1)], gray_y),
            ([(x0, y1, z0), (x1, y1, z0), (x1, y1, z1), (x0, y1, z1)], gray_y + 15),
            ([(x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1)], gray_top)]


def faces():
    return [(FLOOR[0], 170)] + PAINT + [face for box in BOXES for face in box_faces(box)]


def subtract(a, b):
    return [a[i] - b[i] for i in range(3)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def unit(a):
    length = math.sqrt(dot(a, a))
    return [x / length for x in a]


def cam_from_world(view):
    """Rotation (rows) and translation of a camera on an arc around the scene."""
    angle = math.radians(-52 + 13 * view)
    center = [4.2 * math.sin(angle), -4.2 * math.cos(angle), 2.6 + 0.25 * (view % 3)]
    forward = unit(subtract([0.0, 0.0, 0.35], center))
    right = unit(cross(forward, [0.0, 0.0, 1.0]))
    rotation = [right, cross(forward, right), forward]
    return rotation, [-dot(row, center) for row in rotation]


def quaternion(rotation):
    """w, x, y, z of a rotation matrix."""
    r = rotation
    w = math.sqrt(max(1e-12, 1 + r[0][0] + r[1][1] + r[2][2])) / 2
    if w > 0.1:
        return [w, (r[2][1] - r[1][2]) / (4 * w), (r[0][2] - r[2][0]) / (4 * w), (r[1][0] - r[0][1]) / (4 * w)]
    x = math.sqrt(max(1e-12, 1 + r[0][0] - r[1][1] - r[2][2])) / 2
    return [(r[2][1] - r[1][2]) / (4 * x), x, (r[0][1] + r[1][0]) / (4 * x), (r[0][2] + r[2][0]) / (4 * x)]


def project(pose, point):
    """Pixel and depth."""
    rotation, translation = pose
    x, y, z = (dot(row, point) + t for row, t in zip(rotation, translation))
    return FOCAL * x / z + WIDTH / 2, FOCAL * y / z + HEIGHT / 2, z


def draw_face(corners, gray, pose, grays, nearness):
    """Into arrays of SAMPLES**2 samples a pixel; `nearness` is 1 / depth, which is linear in the image."""
    width, height = WIDTH * SAMPLES, HEIGHT * SAMPLES
    points = [(SAMPLES * x, SAMPLES * y, 1 / z) for x, y, z in (project(pose, corner) for corner in corners)]
    (x0, y0, n0), (x1, y1, n1), (x2, y2, n2) = points[:3]
    area = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)
    if abs(area) < 1e-9:
        return
    slope_x = ((n1 - n0) * (y2 - y0) - (n2 - n0) * (y1 - y0)) / area
    slope_y = ((n2 - n0) * (x1 - x0) - (n1 - n0) * (x2 - x0)) / area
    first = max(0, math.ceil(min(y for _, y, _ in points) - 0.5))
    last = min(height - 1, math.floor(max(y for _, y, _ in points) - 0.5))
    for row in range(first, last + 1):
        y = row + 0.5
        at = []
        for (xa, ya, _), (xb, yb, _) in zip(points, points[1:] + points[:1]):
            if (ya <= y) != (yb <= y):
                at.append(xa + (y - ya) / (yb - ya) * (xb - xa))
        if len(at) < 2:
            continue
        begin, end = max(0, math.ceil(min(at) - 0.5)), min(width - 1, math.floor(max(at) - 0.5))
        near = n0 + slope_x * (begin + 0.5 - x0) + slope_y * (y - y0)
        for index in range(row * width + begin, row * width + end + 1):
            if near > nearness[index]:
                nearness[index], grays[index] = near, gray
            near += slope_x


def render(view, seed=1):
    """The gray values of a view, row by row."""
    pose = cam_from_world(view)
    width = WIDTH * SAMPLES
    grays, nearness = [BACKGROUND] * (width * HEIGHT * SAMPLES), [0.0] * (width * HEIGHT * SAMPLES)
    for corners, gray in faces():
        draw_face(corners, gray, pose, grays, nearness)
    noise = random.Random(seed + view)
    image = bytearray()
    for y in range(HEIGHT):
        rows = [grays[(SAMPLES * y + i) * width:(SAMPLES * y + i + 1) * width] for i in range(SAMPLES)]
        for x in range(WIDTH):
            total = sum(sum(row[SAMPLES * x:SAMPLES * (x + 1)]) for row in rows)
            image.append(min(255, max(0, total // SAMPLES**2 + noise.randint(-1, 1))))
    return bytes(image)


def png(width, height, pixels, channels=1):
    """An 8 bit PNG file of gray (1 channel) or RGB (3) values, row by row."""
    def chunk(name, content):
        return struct.pack('>I', len(content)) + name + content + struct.pack('>I', zlib.crc32(name + content))

    size = width * channels
    rows = b''.join(b'\0' + pixels[y * size:(y + 1) * size] for y in range(height))
    header = struct.pack('>2I5B', width, height, 8, {1: 0, 3: 2, 4: 6}[channels], 0, 0, 0)
    return (b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', header) + chunk(b'IDAT', zlib.compress(rows, 6)) + chunk(b'IEND', b''))


def image_name(view):
    return f'view_{view}.png'


def scene_points():
    """Corners of faces, and points on their sides."""
    found = []
    for corners, _ in faces():
        for a, b in zip(corners, corners[1:] + corners[:1]):
            found += [tuple(a[i] + share * (b[i] - a[i]) for i in range(3)) for share in (0, 0.3, 0.7)]
    return sorted(set(found))


def make_model():
    """A Model (see hostile_model.py) of all views and points; every point is in all images that it falls into."""
    model = Model()
    model.cameras = [[1, PINHOLE, WIDTH, HEIGHT, [FOCAL, FOCAL, WIDTH / 2, HEIGHT / 2]]]
    poses = [cam_from_world(view) for view in range(NUM_VIEWS)]
    model.images = [[view + 1, quaternion(rotation) + translation, 1, image_name(view), []]
                    for view, (rotation, translation) in enumerate(poses)]
    for number, point in enumerate(scene_points(), 1):
        pixels = [(image, project(pose, point)) for image, pose in zip(model.images, poses)]
        seen = [(image, x, y) for image, (x, y, _) in pixels if 0 <= x < WIDTH and 0 <= y < HEIGHT]
        if len(seen) < 2:
            continue
        track = []
        for image, x, y in seen:
            track.append([image[0], len(image[4])])
            image[4].append([x, y, number])
        model.points.append([number, list(point), [128, 128, 128], 0.5, track])
    return model


def write_workspace(folder, is_text=False):
    """A COLMAP project: images/ and sparse/."""
    for name in ('images', 'sparse'):
        (folder / name).mkdir(parents=True)
    for view in range(NUM_VIEWS):
        (folder / 'images' / image_name(view)).write_bytes(png(WIDTH, HEIGHT, render(view)))
    make_model().write(folder / 'sparse', is_text)
