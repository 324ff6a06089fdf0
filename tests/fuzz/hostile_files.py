# SPDX-License-Identifier: BSD-3-Clause
"""Files of hostile workspaces: images, dense results, truths, cameras of other programs, and damage of any file."""

import os
import random
import shutil
import struct
import zlib

from hostile_model import change_digits, change_word

TEXT_ENDINGS = ('.txt', '.json', '.obj', '.out', '.nvm', '.ini', '.csv', '.intrinsic', '.extrinsic')
DAMAGES = ['empty', 'folder', 'pipe', 'loop', 'zero', 'full', 'cut', 'cut', 'noise', 'missing', 'repeated', 'foreign',
           'number', 'number', 'number', 'number', 'bomb', 'unreadable']
# (width, height, bits, color type of PNG): gray, RGB, palette without one, gray and RGB with alpha.
PNG_HEADERS = [(1, 1, 8, 0), (1, 1, 16, 6), (2, 2, 8, 2), (0, 0, 8, 2), (0, 480, 8, 0), (640, 480, 8, 0),
               (640, 480, 8, 4), (640, 480, 8, 6), (640, 480, 16, 0), (640, 480, 16, 2), (640, 480, 16, 6), (640, 480, 1, 0),
               (640, 480, 8, 3), (640, 480, 7, 9), (1280, 960, 8, 2), (3000, 2250, 8, 0), (641, 480, 8, 2),
               (64000, 1, 8, 0), (1, 64000, 8, 0), (30000, 30000, 8, 2), (2**31 - 1, 2**31 - 1, 16, 6),
               (2**32 - 1, 2**32 - 1, 8, 0), (100000, 75000, 1, 0)]
# The first lines or bytes of other formats that claim sizes.
LIARS = [b'P5\n640 480\n255\n', b'P6\n2147483647 2147483647\n255\n', b'P6 1 1 65535\n\0\0\0\0\0\0', b'P5 0 0 255\n',
         b'P6 30000 30000 255\n', b'P4 640 480\n', b'P7\nWIDTH 640\nHEIGHT 480\nDEPTH 9999999\nMAXVAL 255\nENDHDR\n',
         b'BM' + struct.pack('<IIIIiiHH', 0, 0, 54, 40, 2**31 - 1, 2**31 - 1, 1, 24) + bytes(24),
         b'BM' + struct.pack('<IIIIiiHH', 0, 0, 54, 40, -640, -480, 1, 8) + bytes(24),
         b'II*\0\x08\0\0\0\x02\0' + struct.pack('<HHIIHHII', 256, 4, 1, 10**6, 257, 4, 1, 10**6),
         b'RIFF\xff\xff\xff\xffWEBPVP8L', b'GIF89a\xff\xff\xff\xff\0\0\0', b'\x76\x2f\x31\x01', b'\xff\xd8\xff\xd9',
         b'#?RADIANCE\n\n-Y 99999 +X 99999\n', b'\0\0\0\x0cjP  \r\n\x87\n', b'<svg/>', b'\n' * 100]


def png(width, height, bits, color, chooser):
    """A picture of boxes, if it is small enough to be made; otherwise rows are missing."""
    channels = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}.get(color, 1)
    row_bytes = (width * bits * channels + 7) // 8
    rows = min(height, 4 * 10**6 // (row_bytes + 1)) if row_bytes < 10**6 else 0
    pixel_bytes = max(1, bits * channels // 8)
    bands = [b''.join(bytes([chooser.randrange(256)]) * (40 * pixel_bytes) for _ in range(row_bytes // 40 + 1))
             for _ in range(12)] if rows > 0 else []
    data = b''.join(b'\0' + bands[row * 12 // rows][:row_bytes] for row in range(rows))

    def chunk(name, content):
        return struct.pack('>I', len(content)) + name + content + struct.pack('>I', zlib.crc32(name + content))

    return (b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>2I5B', width, height, bits, color, 0, 0, 0)) +
            chunk(b'IDAT', zlib.compress(data, 1)) + chunk(b'IEND', b''))


def change_image(chooser, path):
    """Replaces a photograph by another kind of picture, or changes what its header says."""
    kind = chooser.choice(['png', 'png', 'png', 'liar', 'size', 'middle', 'header', 'end'])
    data = bytearray(path.read_bytes())
    told = kind
    if kind == 'png':
        header = chooser.choice(PNG_HEADERS)
        path.write_bytes(png(*header, chooser))
        return f'{path.name}: png {header}'
    if kind == 'liar':
        liar = chooser.choice(LIARS)
        path.write_bytes(liar + bytes(chooser.choice([0, 10, 640 * 480])))
        return f'{path.name}: {liar[:20]}'
    frame = max(data.find(b'\xff\xc0'), data.find(b'\xff\xc2'))
    if kind == 'size' and frame >= 0:
        size = chooser.choice([(0, 0), (1, 1), (65535, 65535), (480, 641), (960, 1280), (30000, 20000)])
        data[frame + 5:frame + 9] = struct.pack('>HH', *size)
        told = f'size {size}'
    elif kind == 'middle':
        middle = len(data) // 2
        data[middle:middle + 500] = chooser.choice([bytes(500), chooser.randbytes(500)])
    elif kind == 'header':
        data[chooser.randrange(4, min(600, len(data)))] = chooser.randrange(256)
    else:
        data = data[:chooser.randrange(len(data))] + b'\xff\xd9'
    path.write_bytes(data)
    return f'{path.name}: jpeg {told}'


def damage(chooser, path):
    """Replaces a file by something else; tells what."""
    kind = chooser.choice(DAMAGES)
    if kind == 'unreadable':
        path.chmod(0)
        return kind
    content = path.read_bytes()
    path.unlink()
    if kind == 'empty':
        path.touch()
    elif kind == 'folder':
        path.mkdir()
    elif kind == 'pipe':
        os.mkfifo(path)
    elif kind == 'loop':
        path.symlink_to(path)
    elif kind in ('zero', 'full'):
        path.symlink_to('/dev/' + kind)
    elif kind == 'cut':
        path.write_bytes(content[:chooser.randrange(len(content) + 1)])
    elif kind == 'noise':
        changed = bytearray(content)
        for _ in range(chooser.randint(1, 64) if changed else 0):
            changed[chooser.randrange(len(changed))] = chooser.randrange(256)
        path.write_bytes(changed)
    elif kind == 'repeated':
        path.write_bytes(content + content)
    elif kind == 'foreign':
        path.write_bytes(chooser.choice([*LIARS, b'ply\n', b'{}', b'[]', b'null', b'[' * 100000, b'{"a":' * 100000,
                                         b'\xef\xbb\xbf' + content, content.replace(b'\n', b'\r\n'), b'\0' * 100,
                                         b'1' * 10**6, b'"' + b'\\u0000' * 1000 + b'"', b'limnfile']))
    elif kind == 'number':
        if path.suffix in TEXT_ENDINGS:
            path.write_text(change_digits(chooser, content.decode(errors='replace')))
        else:
            path.write_bytes(change_word(chooser, content))
    elif kind == 'bomb':
        path.write_bytes(zlib.compress(bytes(2**26), 1, wbits=31))
    return kind


def change_stage_file(chooser, path):
    """Changes the payload of a file of the cache or a sketch, behind a right checksum."""
    data = path.read_bytes()
    at = 16
    size, = struct.unpack_from('<Q', data, at)
    at += 8 + size
    payload_size, = struct.unpack_from('<Q', data, at)
    payload = data[at + 8:at + 8 + payload_size]
    kind = chooser.choice(['word', 'word', 'word', 'cut', 'doubled', 'noise'])
    if kind == 'word':
        payload = change_word(chooser, payload)
    elif kind == 'cut':
        payload = payload[:chooser.randrange(len(payload) + 1)]
    elif kind == 'doubled':
        payload += payload
    else:
        payload = bytes(chooser.randrange(256) if chooser.random() < 0.001 else byte for byte in payload)
    claimed = chooser.choice([len(payload)] * 9 + [2**40])
    data = data[:at] + struct.pack('<Q', claimed) + payload
    path.write_bytes(data + struct.pack('<I', zlib.crc32(data)))
    return f'{path.name}: {kind} of its payload'


def change_json(chooser, node):
    """Replaces, repeats or removes a value somewhere in a tree of lists and objects."""
    parent, key = None, None
    while isinstance(node, (dict, list)) and len(node) > 0:
        keys = list(node.keys()) if isinstance(node, dict) else range(len(node))
        parent, key = node, chooser.choice(list(keys))
        node = parent[key]
        if chooser.random() < 0.1:
            break
    if parent is None:
        return 'nothing'
    value = chooser.choice([1e12, 1e37, 1e300, -1e300, 1e-300, -1, 2**31, 2**53, 2**64, float('nan'), float('inf'),
                            None, '', 'x' * 1000, '\x1b[2J', 'a\nb', '../x', [], {}, [[]], True, 0, 'gone', 'repeated'])
    if value == 'gone':
        del parent[key]
    elif value == 'repeated' and isinstance(parent, list):
        parent.insert(chooser.randrange(len(parent)), node)
    else:
        parent[key] = value
    return f'{key!r} = {str(value)[:20]!r}'


def rotation(quaternion):
    w, x, y, z = quaternion
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]


def center(matrix, translation):
    return [-sum(matrix[row][i] * translation[row] for row in range(3)) for i in range(3)]


def lines(rows):
    return ''.join(' '.join(str(value) for value in row) + '\n' for row in rows)


def write_foreign_cameras(model, folder, kind):
    """The model's cameras in another format of model_importer; the path to import."""
    folder.mkdir()
    fx, fy, cx, cy = model.cameras[0][4]
    views = [(image[3], image[1][:4], rotation(image[1][:4]), image[1][4:]) for image in model.images]
    calibration = [[fx, 0.0, cx], [0.0, fy, cy], [0.0, 0.0, 1.0]]
    flipped = [1, -1, -1]
    if kind == 'projection_matrices':
        for name, _, r, t in views:
            pose = [r[i] + [t[i]] for i in range(3)]
            matrix = [[sum(k[j] * pose[j][i] for j in range(3)) for i in range(4)] for k in calibration]
            (folder / name.replace('.jpg', '.txt')).write_text('CONTOUR\n' + lines(matrix))
    elif kind == 'intrinsic_extrinsic':
        (folder / 'calib.intrinsic').write_text(lines(calibration))
        for name, _, r, t in views:
            (folder / name.replace('.jpg', '.extrinsic')).write_text(lines(r + [center(r, t)]))
    elif kind == 'middlebury':
        rows = [[name, *sum(calibration, []), *sum(r, []), *t] for name, _, r, t in views]
        (folder / 'x_par.txt').write_text(f'{len(rows)}\n' + lines(rows))
    elif kind == 'bundler':
        rows = []
        for _, _, r, t in views:
            rows += [[fx, 0, 0]] + [[s * v for v in row] for s, row in zip(flipped, r)]
            rows += [[s * v for s, v in zip(flipped, t)]]
        rows += [[0.5, 1.0, 2.0], [255, 0, 10], [2, 0, 7, 1.5, -2.5, 1, 8, 3, 4]]
        (folder / 'x.out').write_text(f'# Bundle file v0.3\n{len(views)} 1\n' + lines(rows))
        (folder / 'list.txt').write_text(lines([name] for name, *_ in views))
    elif kind == 'nvm':
        rows = [[name, fx, *q, *center(r, t), 0, 0] for name, q, r, t in views]
        point = '0.5 1 2 255 0 10 2 0 7 1.5 -2.5 1 8 3 4'
        (folder / 'x.nvm').write_text(f'NVM_V3\n\n{len(rows)}\n{lines(rows)}\n1\n{point}\n\n0\n')
    else:
        frames = []
        for name, _, r, t in views:
            c = center(r, t)
            matrix = [[flipped[j] * r[j][i] for j in range(3)] + [c[i]] for i in range(3)] + [[0, 0, 0, 1]]
            frames.append(f'{{"file_path": "{name}", "transform_matrix": {matrix}}}')
        (folder / 'transforms.json').write_text(
            f'{{"fl_x": {fx}, "fl_y": {fy}, "cx": {cx}, "cy": {cy}, "w": 640, "h": 480, "k1": 0.01, "frames": [' +
            ',\n'.join(frames) + ']}\n')
    return {'middlebury': folder / 'x_par.txt', 'bundler': folder / 'x.out', 'nvm': folder / 'x.nvm',
            'nerf_transforms': folder / 'transforms.json'}.get(kind, folder)


def ply_header(elements, body):
    text = 'ply\nformat binary_little_endian 1.0\n'
    for name, count, properties in elements:
        text += f'element {name} {count}\n' + ''.join(f'property {p}\n' for p in properties)
    return text.encode() + b'end_header\n' + body


def write_dense(model, sample, workspace, kind):
    """Dense results of one kind beside the model."""
    places = [point[1] for point in model.points]
    xyz = ['float x', 'float y', 'float z']
    if kind == 'depth_maps':
        folder = workspace / 'stereo' / 'depth_maps'
        folder.mkdir(parents=True)
        for image in model.images:
            name = image[3] + '.geometric.bin'
            shutil.copyfile(sample / 'stereo' / 'depth_maps' / name, folder / name)
    elif kind == 'fused':
        rows = b''.join(struct.pack('<6f3B', *place, 0, 0, 1, 9, 9, 9) for place in places)
        more = ['float nx', 'float ny', 'float nz', 'uchar red', 'uchar green', 'uchar blue']
        (workspace / 'fused.ply').write_bytes(ply_header([('vertex', len(places), xyz + more)], rows))
        (workspace / 'fused.ply.vis').write_bytes(
            struct.pack('<Q', len(places)) + struct.pack('<4I', 3, 0, 1, 2) * len(places))
    elif kind == 'mesh':
        faces = b''.join(struct.pack('<B3i', 3, i, i + 1, i + 2) for i in range(len(places) - 2))
        (workspace / 'meshed-poisson.ply').write_bytes(ply_header(
            [('vertex', len(places), xyz), ('face', len(places) - 2, ['list uchar int vertex_indices'])],
            b''.join(struct.pack('<3f', *place) for place in places) + faces))
    elif kind == 'pmvs':
        folder = workspace / 'pmvs' / 'models'
        folder.mkdir(parents=True)
        (folder / 'option-0000.patch').write_text(f'PATCHES\n{len(places)}\n' + ''.join(
            f'PATCHS\n{x} {y} {z} 1\n0 0 1 0\n0.9 0.1 0.2\n2\n0 1\n0\n\n\n' for x, y, z in places))


def write_auxiliary(model, folder):
    """Files that options name: a list of images, masks, truths in several formats, options."""
    (folder / 'masks').mkdir(parents=True)
    chooser = random.Random(0)
    for image in model.images[:3]:
        (folder / 'masks' / (image[3] + '.png')).write_bytes(png(640, 480, 8, 0, chooser))
    (folder / 'list.txt').write_text(lines([image[3]] for image in model.images))
    places = [point[1] for point in model.points[:100]]
    (folder / 'points.txt').write_text(lines(places))
    (folder / 'edges.txt').write_text(lines([i, i + 1] for i in range(len(places) - 1)))
    (folder / 'curves.obj').write_text(lines(['v', *place] for place in places) + lines(
        ['l', i + 1, i + 2] for i in range(len(places) - 1)))
    (folder / 'junctions.json').write_text('{"junctions": [' + ',\n'.join(
        f'{{"position": {place}, "degree": 3}}' for place in places[:9]) + ']}')
    (folder / 'kinds.json').write_text('{"curves": [' + ',\n'.join(
        f'{{"kind": "{kind}", "points": {places[:5]}}}' for kind in ('edge', 'paint', 'shadow', 'contour')) + ']}')
    (folder / 'options.ini').write_text('[Sketch]\nmax_gap_px = 3\n')
