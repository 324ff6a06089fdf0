# SPDX-License-Identifier: BSD-3-Clause
"""Odd files of pictures: JPEG without their end, with more behind it, turned by EXIF; TIFF of several directories and byte
orders; values in a part of 16 bits; all of them whole or damaged."""

import random
import struct
import zlib

import hostile
import scene

WIDTH, HEIGHT = scene.WIDTH, scene.HEIGHT
# How many views get the kind of picture.
SHARES = [1, 1, 3, scene.NUM_VIEWS]
KINDS = ['tiff pages', 'tiff sub directory', 'tiff big endian', 'tiff loop', 'raw', 'tiff cut', 'deep', 'deep offset', 'deep dark',
         'exif png', 'exif png swapped', 'swapped', 'jpeg', 'jpeg', 'jpeg without end', 'jpeg cut', 'jpeg and more',
         'jpeg damaged', 'jpeg exif', 'png without end', 'png chunks', 'size lies', 'other format']


def png_chunk(name, content):
    return struct.pack('>I', len(content)) + name + content + struct.pack('>I', zlib.crc32(name + content))


def png(width, height, rows, depth=8, color=0, more=b''):
    header = struct.pack('>2I5B', width, height, depth, color, 0, 0, 0)
    return (b'\x89PNG\r\n\x1a\n' + png_chunk(b'IHDR', header) + more +
            png_chunk(b'IDAT', zlib.compress(b''.join(b'\0' + row for row in rows))) + png_chunk(b'IEND', b''))


def rows_of(grays, width=WIDTH):
    return [grays[i:i + width] for i in range(0, len(grays), width)]


def turned(grays):
    """A quarter turn counterclockwise: EXIF orientation 6 turns it back."""
    rows = rows_of(grays)
    return [bytes(row[x] for row in rows) for x in range(WIDTH - 1, -1, -1)]


def exif(orientation, order='<'):
    return ((b'II' if order == '<' else b'MM') + struct.pack(order + 'HIH', 42, 8, 1) +
            struct.pack(order + 'HHIHH', 274, 3, 1, orientation, 0) + bytes(4))


class Tiff:
    """A TIFF file, written from its last directory to its first."""

    def __init__(self, order):
        self.order = order
        self.bytes = bytearray((b'II' if order == '<' else b'MM') + struct.pack(order + 'HI', 42, 0))

    def add(self, width, height, grays, more=(), following=0):
        data = len(self.bytes)
        self.bytes += grays + bytes(len(grays) % 2)
        entries = [(256, 4, width), (257, 4, height), (258, 3, 8), (259, 3, 1), (262, 3, 1), (273, 4, data), (277, 3, 1),
                   (278, 4, height), (279, 4, width * height)]
        entries = sorted([entry for entry in entries if entry[0] not in [tag for tag, _, _ in more]] + list(more))
        offset = len(self.bytes)
        self.bytes += struct.pack(self.order + 'H', len(entries))
        for tag, kind, value in entries:
            number = struct.pack(self.order + ('HH' if kind == 3 else 'I'), *([value, 0] if kind == 3 else [value]))
            self.bytes += struct.pack(self.order + 'HHI', tag, kind, 1) + number
        self.bytes += struct.pack(self.order + 'I', following)
        return offset

    def file(self, first):
        self.bytes[4:8] = struct.pack(self.order + 'I', first)
        return bytes(self.bytes)


def thumbnail(grays):
    return bytes(grays[y * WIDTH + x] for y in range(0, HEIGHT, 4) for x in range(0, WIDTH, 4))


def tiff(kind, grays, chooser):
    order = '>' if kind == 'tiff big endian' else chooser.choice('<>')
    small = (WIDTH // 4, HEIGHT // 4, thumbnail(grays))
    file = Tiff(order)
    if kind == 'tiff sub directory':
        large = file.add(WIDTH, HEIGHT, grays)
        return file.file(file.add(*small, more=[(330, 4, large)]))
    if kind == 'raw':
        raw = file.add(WIDTH, HEIGHT, grays, more=[(262, 3, 32803)])
        return file.file(file.add(*small, more=[(254, 4, 1), (330, 4, raw)]))
    if kind == 'tiff loop':
        first = len(file.bytes) + len(grays) + len(grays) % 2
        return file.file(file.add(WIDTH, HEIGHT, grays, following=first))
    large = file.add(WIDTH, HEIGHT, grays, more=[(254, 4, 0)])
    content = file.file(file.add(*small, more=[(254, 4, 1)], following=large))
    return content[:chooser.randrange(4, len(content))] if kind == 'tiff cut' else content


# Of the zigzag order of frequencies, and a quantization by ones.
def jpeg(grays, with_exif=0):
    """A baseline JPEG file with the mean gray of every block: what matters here is its frame."""
    lengths = [0] * 16
    lengths[3] = 12  # twelve codes of 4 bits for differences of up to 11 bits
    table_dc = bytes([0x00]) + bytes(lengths) + bytes(range(12))
    lengths = [0] * 16
    lengths[0] = 1
    table_ac = bytes([0x10]) + bytes(lengths) + bytes([0])  # only the end of a block
    bits = []
    before = 0
    for y in range(0, HEIGHT, 8):
        for x in range(0, WIDTH, 8):
            total = sum(grays[(y + i) * WIDTH + x + k] for i in range(8) for k in range(8))
            value = (total // 8 - 1024)
            difference, before = value - before, value
            size = abs(difference).bit_length()
            bits.append(format(size, '04b'))
            if size:
                bits.append(format(difference if difference > 0 else difference + (1 << size) - 1, f'0{size}b'))
            bits.append('0')
    stream = ''.join(bits)
    stream += '1' * (-len(stream) % 8)
    codes = bytes(int(stream[i:i + 8], 2) for i in range(0, len(stream), 8)).replace(b'\xff', b'\xff\0')

    def segment(marker, content):
        return bytes([0xff, marker]) + struct.pack('>H', len(content) + 2) + content

    start = b'\xff\xd8' + (segment(0xe1, b'Exif\0\0' + exif(with_exif, '>')) if with_exif else b'')
    return (start + segment(0xdb, bytes([0]) + bytes([1] * 64)) +
            segment(0xc0, struct.pack('>BHHB', 8, HEIGHT, WIDTH, 1) + bytes([1, 0x11, 0])) + segment(0xc4, table_dc) +
            segment(0xc4, table_ac) + segment(0xda, bytes([1, 1, 0x00, 0, 63, 0])) + codes + b'\xff\xd9')


def deep(grays, low, high):
    values = b''.join(struct.pack('>H', low + gray * (high - low) // 255) for gray in grays)
    return png(WIDTH, HEIGHT, rows_of(values, 2 * WIDTH), depth=16)


def noise(chooser, size):
    return bytes(chooser.randrange(256) for _ in range(size))


def picture(kind, grays, chooser):
    """The bytes of a file."""
    if kind.startswith('tiff') or kind == 'raw':
        return tiff(kind, grays, chooser)
    if kind == 'deep':
        return deep(grays, 0, chooser.choice([255, 1023, 4095, 16383, 3277, 65535]))
    if kind == 'deep offset':
        return deep(grays, chooser.choice([512, 7200, 60000]), chooser.choice([8300, 61000, 65535]))
    if kind == 'deep dark':
        return deep(grays, 0, chooser.choice([0, 1, 5, 31]))
    if kind == 'exif png':
        return png(WIDTH, HEIGHT, rows_of(grays), more=png_chunk(b'eXIf', exif(chooser.randrange(0, 12))))
    if kind == 'exif png swapped':
        return png(HEIGHT, WIDTH, turned(grays), more=png_chunk(b'eXIf', exif(6, chooser.choice('<>'))))
    if kind == 'swapped':
        return png(HEIGHT, WIDTH, turned(grays))
    whole = jpeg(grays, chooser.randrange(1, 9) if kind == 'jpeg exif' else 0)
    if kind == 'jpeg without end':
        return chooser.choice([whole[:-1], whole[:-2], whole[:-2] + bytes(100)])
    if kind == 'jpeg cut':
        return whole[:chooser.randrange(2, len(whole) - 40)]
    if kind == 'jpeg and more':
        return whole + chooser.choice([bytes(5000), noise(chooser, 5000), whole, b'\0\0\0\x18ftypmp42' + noise(chooser, 999)])
    if kind == 'jpeg damaged':
        at = chooser.randrange(200, len(whole) - 20)
        return whole[:at] + noise(chooser, chooser.choice([1, 8])) + whole[at + 8:]
    if kind.startswith('jpeg'):
        return whole
    content = png(WIDTH, HEIGHT, rows_of(grays))
    if kind == 'png without end':
        return content[:-12]
    if kind == 'png chunks':
        return png(WIDTH, HEIGHT, rows_of(grays), more=png_chunk(b'teXt', noise(chooser, 70000)) + png_chunk(b'eXIf', noise(
            chooser, chooser.choice([0, 3, 40]))))
    if kind == 'size lies':
        width, height = chooser.choice([(WIDTH, HEIGHT * 100), (WIDTH // 2, HEIGHT // 2), (40000, 30000)])
        return content[:16] + struct.pack('>2I', width, height) + content[24:]
    return chooser.choice([b'\0\0\0\x18ftypheic', b'GIF89a', b'RIFF\0\0\0\0WEBPVP8 ', b'II*\0', b'MM\0*', b'\xff\xd8',
                           b'P5\n160 120\n255\n']) + noise(chooser, 500)


MUST_RUN = ('tiff pages', 'tiff sub directory', 'tiff big endian', 'deep', 'deep offset', 'jpeg', 'jpeg without end',
            'exif png swapped', 'png chunks')
MUST_FAIL = ('raw', 'swapped', 'jpeg cut', 'png without end', 'size lies', 'other format')


def prepare_with(kind, views):
    def prepare(folder, _):
        chooser = random.Random(f'{kind} {views}')
        for view in views:
            content = picture(kind, scene.render(view), chooser)
            (folder / 'ws' / 'images' / scene.image_name(view)).write_bytes(content)
    return prepare


def cases(seed, count):
    for index in range(count):
        chooser = hostile.chooser_of('picture_files', seed, -index - 1)
        kind = chooser.choice(KINDS)
        views = sorted(chooser.sample(range(scene.NUM_VIEWS), chooser.choice(SHARES)))
        options = chooser.choice([(), ('--page', '0'), ('--page', '0', '--max_image_size', '100'), ('--page', '0', '--account', '1')])
        codes = (0,) if kind in MUST_RUN and len(views) == 1 else (1,) if kind in MUST_FAIL else (0, 1)
        yield hostile.Case(f'{kind} of {len(views)} views {" ".join(options)}', prepare_with(kind, views),
                           [hostile.drawer(*options)],
                           names=[scene.image_name(view) for view in views] + ['images', 'at least 3'], codes=codes,
                           data={'kind': kind})


TOLD = {'jpeg without end': 'lacks the end marker', 'exif png swapped': 'EXIF orientation'}


def check(case, outcome):
    broken = hostile.check(case, outcome)
    told = TOLD.get(case.data['kind'])
    if outcome.code == 0 and told and told not in outcome.output + outcome.errors:
        broken.append(f'does not say "{told}"')
    return broken
