# SPDX-License-Identifier: BSD-3-Clause
"""A small COLMAP model of the sample scene, with rigs and frames, whose values are replaced by hostile ones."""

import copy
import re
import struct

NUM_VIEWS = 8
MAX_POINTS = 300

NUMBERS = [0.0, -0.0, 1.0, -1.0, 1e-300, 1e-45, 1e-39, 1e-12, 1e6, 1e9, 1e12, 1e37, 3.5e38, 1e45, 1e150, 1e200, 1e308,
           -1e6, -1e37, -1e200, -1e308, float('inf'), float('-inf'), float('nan'), 5e-324, 2.2e-308, 1 + 2.0**-52,
           2.0**24 + 1, 2.0**31, 2.0**32, 2.0**53, 2.0**63, 2.0**64, -2.0**31, -2.0**63]
INTEGERS = [0, 1, -1, 2, 7, 255, 2**15, 2**16, 2**24, 2**30, 2**31 - 1, 2**31, 2**32 - 1, 2**32, 2**53, 2**61, 2**63 - 1,
            2**63, 2**64 - 1, -2**31, -2**63]
NAMES = ['', ' ', '.', '..', '../view.jpg', '../../beside/note.txt', '/etc/passwd', '/dev/zero', 'a\nb.jpg', 'a\rb.jpg',
         'a\tb.jpg', '\x1b[31mred.jpg', '\x9b31m.jpg', 'a"b,c.jpg', "a'b.jpg", 'x' * 251, 'x' * 252, 'x' * 255,
         'x' * 300 + '.jpg', 'y/' * 2000 + 'a.jpg', 'a b.jpg ', 'ä日本.jpg', '\u202egpj.exe', 'view_00.jpg/x.png',
         'VIEW_00.JPG', '-rf', '--help', 'a\\b.jpg', 'CON', '%s%n.jpg', '$(reboot).jpg', '<b>.jpg', '</script>.jpg',
         './view_00.jpg', 'sub/../view_00.jpg', 'sub//view.jpg', 'view_00.jpg.bin', 'a.jpg\\x0a', '#a.jpg', '{}', '1']
MODEL_NAMES = ['SIMPLE_PINHOLE', 'PINHOLE', 'SIMPLE_RADIAL', 'RADIAL', 'OPENCV', 'OPENCV_FISHEYE', 'FULL_OPENCV', 'FOV',
               'SIMPLE_RADIAL_FISHEYE', 'RADIAL_FISHEYE', 'THIN_PRISM_FISHEYE', 'RAD_TAN_THIN_PRISM_FISHEYE',
               'SIMPLE_DIVISION', 'DIVISION', 'SIMPLE_FISHEYE', 'FISHEYE', 'EUCM', 'EQUIRECTANGULAR']
NUM_PARAMS = [3, 4, 4, 5, 8, 8, 12, 5, 4, 5, 12, 16, 4, 5, 3, 4, 6, 2]
SENSORS = {-1: 'INVALID', 0: 'CAMERA', 1: 'IMU'}
RIG_SHIFT = [0.1, -0.05, 0.02]


def hostile_number(random, value):
    return value * 10.0**random.randint(-40, 40) if random.random() < 0.3 else random.choice(NUMBERS)


def change_value(random, values, i):
    """Replaces an integer or a real of a list by a hostile one, and tells which."""
    values[i] = random.choice(INTEGERS) if isinstance(values[i], int) else hostile_number(random, values[i])
    return f'value {i} = {values[i]}'


def change_word(random, data):
    """Writes a hostile number over some bytes, as a file of any binary format may have it."""
    damaged = bytearray(data)
    for _ in range(random.choice([1, 1, 1, 3])):
        word = random.choice([lambda: struct.pack('<i', wrap(random.choice(INTEGERS), 32)),
                              lambda: struct.pack('<q', wrap(random.choice(INTEGERS), 64)),
                              lambda: struct.pack('<d', random.choice(NUMBERS)),
                              lambda: struct.pack('<f', random.choice([0.0, -1.0, 1e-39, 1e30, -1e37, float('nan'),
                                                                       float('inf')]))])()
        # Counts and headers come first.
        last = random.choice([64, len(damaged)])
        at = random.randint(0, max(0, min(last, len(damaged)) - len(word)))
        damaged[at:at + len(word)] = word
    return bytes(damaged)


def change_digits(random, text):
    """Replaces a number in a text."""
    found = list(re.finditer(r'-?\d+(\.\d*)?([eE][-+]?\d+)?', text))
    if not found:
        return text
    number = random.choice(found)
    value = random.choice(NUMBERS + INTEGERS + ['', 'x', '1,5', '0x10', '1e99999', '9' * 400])
    return text[:number.start()] + str(value) + text[number.end():]


def unpack(stream, pattern):
    return struct.unpack('<' + pattern, stream.read(struct.calcsize('<' + pattern)))


def read_name(stream):
    name = b''
    while (byte := stream.read(1)) != b'\0':
        name += byte
    return name.decode()


def wrap(value, bits):
    value %= 2**bits
    return value - 2**bits if value >= 2**(bits - 1) else value


def join(*values):
    return ' '.join(repr(value) if isinstance(value, float) else str(value) for value in values) + '\n'


class Model:
    """Lists of cameras, images, points, rigs and frames with their fields in the order of COLMAP's files."""

    def __init__(self, folder=None):
        self.cameras, self.images, self.points, self.rigs, self.frames = [], [], [], [], []
        if folder is not None:
            self.read(folder)

    def read(self, folder):
        """Some of the views and points of a binary model."""
        with open(folder / 'cameras.bin', 'rb') as f:
            for _ in range(unpack(f, 'Q')[0]):
                camera, model, width, height = unpack(f, 'iiQQ')
                self.cameras.append([camera, model, width, height, list(unpack(f, f'{NUM_PARAMS[model]}d'))])
        with open(folder / 'images.bin', 'rb') as f:
            count, = unpack(f, 'Q')
            for i in range(count):
                image, = unpack(f, 'i')
                pose = list(unpack(f, '7d'))
                camera, = unpack(f, 'i')
                name = read_name(f)
                size, = unpack(f, 'Q')
                pixels = [list(unpack(f, 'ddq')) for _ in range(size)]
                if i % (count // NUM_VIEWS) == 0 and len(self.images) < NUM_VIEWS:
                    self.images.append([image, pose, camera, name, pixels])
        kept = {image[0] for image in self.images}
        with open(folder / 'points3D.bin', 'rb') as f:
            for _ in range(unpack(f, 'Q')[0]):
                point, x, y, z, r, g, b, error, size = unpack(f, 'QdddBBBdQ')
                track = [list(unpack(f, 'ii')) for _ in range(size)]
                track = [entry for entry in track if entry[0] in kept]
                if len(track) >= 2 and len(self.points) < MAX_POINTS:
                    self.points.append([point, [x, y, z], [r, g, b], error, track])
        known = {point[0] for point in self.points}
        for image in self.images:
            for pixel in image[4]:
                if pixel[2] not in known:
                    pixel[2] = -1

    def add_rigs(self):
        """A rig of two cameras, the second beside a sensor that is none, and a frame per image."""
        first = self.cameras[0]
        second = copy.deepcopy(first)
        second[0] = first[0] + 1
        self.cameras.append(second)
        for image in self.images[::2]:
            image[2] = second[0]
        pose = [1.0, 0.0, 0.0, 0.0] + RIG_SHIFT
        self.rigs = [[1, [[0, first[0], None]]], [2, [[1, 7, None], [0, second[0], pose]]]]
        for image in self.images:
            frame_pose = list(image[1])
            if image[2] == second[0]:
                frame_pose[4:] = [t - shift for t, shift in zip(frame_pose[4:], RIG_SHIFT)]
            rig = 2 if image[2] == second[0] else 1
            self.frames.append([image[0], rig, frame_pose, [[0, image[2], image[0]]]])

    def write(self, folder, is_text):
        if is_text:
            self.write_text(folder)
        else:
            self.write_binary(folder)

    def write_binary(self, folder):
        with open(folder / 'cameras.bin', 'wb') as f:
            f.write(struct.pack('<Q', len(self.cameras)))
            for camera, model, width, height, params in self.cameras:
                f.write(struct.pack(f'<iiQQ{len(params)}d', wrap(camera, 32), wrap(model, 32), width % 2**64,
                                    height % 2**64, *params))
        with open(folder / 'images.bin', 'wb') as f:
            f.write(struct.pack('<Q', len(self.images)))
            for image, pose, camera, name, pixels in self.images:
                f.write(struct.pack('<i7di', wrap(image, 32), *pose, wrap(camera, 32)))
                f.write(name.encode() + b'\0' + struct.pack('<Q', len(pixels)))
                for x, y, point in pixels:
                    f.write(struct.pack('<ddq', x, y, wrap(point, 64)))
        with open(folder / 'points3D.bin', 'wb') as f:
            f.write(struct.pack('<Q', len(self.points)))
            for point, place, color, error, track in self.points:
                f.write(struct.pack('<QdddBBBdQ', point % 2**64, *place, *color, error, len(track)))
                for image, index in track:
                    f.write(struct.pack('<ii', wrap(image, 32), wrap(index, 32)))
        if not self.rigs:
            return
        with open(folder / 'rigs.bin', 'wb') as f:
            f.write(struct.pack('<Q', len(self.rigs)))
            for rig, sensors in self.rigs:
                f.write(struct.pack('<ii', wrap(rig, 32), len(sensors)))
                for i, (kind, sensor, pose) in enumerate(sensors):
                    f.write(struct.pack('<ii', wrap(kind, 32), wrap(sensor, 32)))
                    if i > 0:
                        f.write(struct.pack('<B7d', 1, *pose) if pose else b'\0')
        with open(folder / 'frames.bin', 'wb') as f:
            f.write(struct.pack('<Q', len(self.frames)))
            for frame, rig, pose, data in self.frames:
                f.write(struct.pack('<ii7di', wrap(frame, 32), wrap(rig, 32), *pose, len(data)))
                for kind, sensor, image in data:
                    f.write(struct.pack('<iiq', wrap(kind, 32), wrap(sensor, 32), wrap(image, 64)))

    def write_text(self, folder):
        with open(folder / 'cameras.txt', 'w', encoding='utf-8') as f:
            for camera, model, width, height, params in self.cameras:
                name = MODEL_NAMES[model] if 0 <= model < len(MODEL_NAMES) else model
                f.write(join(camera, name, width, height, *params))
        with open(folder / 'images.txt', 'w', encoding='utf-8') as f:
            for image, pose, camera, name, pixels in self.images:
                f.write(join(image, *pose, camera, name))
                f.write(join(*[value for pixel in pixels for value in pixel]))
        with open(folder / 'points3D.txt', 'w', encoding='utf-8') as f:
            for point, place, color, error, track in self.points:
                f.write(join(point, *place, *color, error, *[value for entry in track for value in entry]))
        if not self.rigs:
            return
        with open(folder / 'rigs.txt', 'w', encoding='utf-8') as f:
            for rig, sensors in self.rigs:
                f.write(f'{rig} {len(sensors)}')
                for i, (kind, sensor, pose) in enumerate(sensors):
                    f.write(f' {SENSORS.get(kind, kind)} {sensor}')
                    if i > 0:
                        f.write(' 1 ' + ' '.join(map(repr, pose)) if pose else ' 0')
                f.write('\n')
        with open(folder / 'frames.txt', 'w', encoding='utf-8') as f:
            for frame, rig, pose, data in self.frames:
                values = [value for kind, *rest in data for value in [SENSORS.get(kind, kind), *rest]]
                f.write(join(frame, rig, *pose, len(data), *values))


class ModelChanges:
    """Each method but __init__ makes one hostile change of a model and tells which."""

    def __init__(self, model, random):
        self.model = model
        self.random = random

    def all(self):
        return [self.camera, self.camera, self.lens, self.pose, self.pose, self.pose, self.scale, self.shift, self.name,
                self.name, self.image_ids, self.pixel, self.point, self.track, self.many_points, self.repeated_image,
                self.few, self.rig, self.rig, self.frame, self.frame]

    def camera(self):
        camera = self.random.choice(self.model.cameras)
        field = self.random.choice([0, 1, 2, 3, 4, 4, 4, 4])
        values = camera[4] if field == 4 else camera
        i = self.random.randrange(len(values)) if field == 4 else field
        return ('camera parameter: ' if field == 4 else 'camera field: ') + change_value(self.random, values, i)

    def lens(self):
        camera = self.random.choice(self.model.cameras)
        camera[1] = self.random.randrange(len(NUM_PARAMS))
        size = self.random.choice([1e-30, 1e-6, 0.01, 1.0, -1.0, 1e3, 1e30])
        values = [640.0, 640.0, 316.0, 244.0] + [self.random.uniform(-size, size) for _ in range(12)]
        camera[4] = values[:NUM_PARAMS[camera[1]]]
        return f'lens {MODEL_NAMES[camera[1]]} with parameters of {size:g}'

    def pose(self):
        images = self.random.choice([self.model.images, self.model.images[:4], [self.random.choice(self.model.images)]])
        i = self.random.randrange(7)
        for image in images:
            image[1][i] = hostile_number(self.random, image[1][i])
        return f'pose value {i} of {len(images)} images = {images[0][1][i]}'

    def scale(self):
        factor = 10.0**self.random.choice([self.random.randint(-30, 30), self.random.randint(-300, 300)])
        for image in self.model.images:
            image[1][4:] = [value * factor for value in image[1][4:]]
        for point in self.model.points:
            point[1] = [value * factor for value in point[1]]
        return f'scene times {factor:g}'

    def shift(self):
        far = 10.0**self.random.randint(0, 20)
        for point in self.model.points:
            point[1][0] += far
        return f'points moved by {far:g}'

    def name(self):
        image = self.random.choice(self.model.images)
        image[3] = self.random.choice(NAMES)
        return f'name {image[3]!r}'

    def image_ids(self):
        return 'image field: ' + change_value(self.random, self.random.choice(self.model.images),
                                              self.random.choice([0, 2]))

    def pixel(self):
        image = self.random.choice(self.model.images)
        if not image[4]:
            return 'no pixels'
        return 'pixel of an image: ' + change_value(self.random, self.random.choice(image[4]), self.random.randrange(3))

    def point(self):
        point = self.random.choice(self.model.points)
        if self.random.random() < 0.6:
            return 'point: ' + change_value(self.random, point[1], self.random.randrange(3))
        return 'point field: ' + change_value(self.random, point, self.random.choice([0, 3]))

    def track(self):
        point = self.random.choice(self.model.points)
        if self.random.random() < 0.3:
            point[4] = point[4] * self.random.choice([0, 2, 10000])
            return f'a track of {len(point[4])}'
        if not point[4]:
            return 'no track'
        return 'track: ' + change_value(self.random, self.random.choice(point[4]), self.random.randrange(2))

    def many_points(self):
        for point in self.model.points:
            if self.random.random() < 0.5:
                point[1] = [hostile_number(self.random, value) for value in point[1]]
        return 'half of the points anywhere'

    def repeated_image(self):
        image = copy.deepcopy(self.random.choice(self.model.images))
        image[0] += self.random.choice([0, 100])
        self.model.images.append(image)
        return f'image repeated as {image[0]}'

    def few(self):
        kept = self.random.randrange(4)
        if self.random.random() < 0.5:
            del self.model.images[max(1, kept):]
            return f'{len(self.model.images)} images'
        del self.model.points[max(1, kept):]
        return f'{len(self.model.points)} points'

    def rig(self):
        if not self.model.rigs:
            self.model.add_rigs()
        rig = self.random.choice(self.model.rigs)
        if not rig[1]:
            return 'a rig without sensors'
        sensor = self.random.choice(rig[1])
        kind = self.random.choice(['rig', 'sensor', 'pose', 'pose', 'pose', 'gone', 'repeated', 'all gone', 'unused'])
        if kind == 'rig':
            return 'rig: ' + change_value(self.random, rig, 0)
        if kind == 'sensor':
            return 'sensor: ' + change_value(self.random, sensor, self.random.randrange(2))
        if kind == 'pose':
            poses = [sensor[2] for _, sensors in self.model.rigs for sensor in sensors if sensor[2]]
            return 'rig pose: ' + (change_value(self.random, poses[0], self.random.randrange(7)) if poses else 'none')
        if kind == 'gone':
            rig[1].remove(sensor)
        elif kind == 'repeated':
            self.model.rigs.append(copy.deepcopy(rig))
        elif kind == 'all gone':
            rig[1].clear()
        return f'rigs: {kind}'

    def frame(self):
        if not self.model.rigs:
            self.model.add_rigs()
        if not self.model.frames:
            return 'no frames'
        frame = self.random.choice(self.model.frames)
        kind = self.random.choice(['frame', 'pose', 'pose', 'poses', 'data', 'gone', 'repeated', 'no frames', 'scaled'])
        if kind == 'frame':
            return 'frame: ' + change_value(self.random, frame, self.random.randrange(2))
        if kind == 'pose':
            return 'frame pose: ' + change_value(self.random, frame[2], self.random.randrange(7))
        if kind == 'data' and frame[3]:
            return 'frame data: ' + change_value(self.random, frame[3][0], self.random.randrange(3))
        if kind == 'poses':
            i = self.random.randrange(7)
            for other in self.model.frames:
                other[2][i] = hostile_number(self.random, other[2][i])
        elif kind == 'scaled':
            factor = 10.0**self.random.randint(-300, 300)
            for other in self.model.frames:
                other[2][4:] = [value * factor for value in other[2][4:]]
        elif kind == 'gone':
            self.model.frames.remove(frame)
        elif kind == 'repeated':
            self.model.frames.append(copy.deepcopy(frame))
        elif kind == 'no frames':
            self.model.frames.clear()
        return f'frames: {kind}'
