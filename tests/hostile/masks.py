# SPDX-License-Identifier: BSD-3-Clause
"""Masks in every usual form and folder, and in forms that are wrong: of other sizes and depths, damaged, ambiguous, of other
images, as alpha channels, in lists."""

import struct
import zlib

import hostile
import scene

WIDTH, HEIGHT = scene.WIDTH, scene.HEIGHT
FORMS = ['{name}.png', '{stem}.png', '{stem}_mask.png', '{stem}.mask.png', 'mask_{stem}.png', '{name}.mask.png',
         '{stem}-mask.PNG', '{stem}.PGM', 'mask.{name}']
FOLDERS = ['masks', 'masks/sub', 'images', 'segmentation']
PICTURES = ['8 bits', '1 for use', 'rgb', '16 bits', 'gray with alpha', 'alpha alone', 'half', 'double', 'a tenth', 'pgm',
            'nothing', 'everything']
WRONG = ['other aspect', 'truncated', 'text', 'empty', 'folder', 'huge header', 'zero size', 'no names fit', 'two forms',
         'missing folder', 'list without tab', 'list of missing', 'of other images', 'damaged, not in use']
KINDS = ['right'] * 6 + ['alpha'] * 2 + ['one for all', 'list'] + ['wrong'] * 6


def chunk(name, content):
    return struct.pack('>I', len(content)) + name + content + struct.pack('>I', zlib.crc32(name + content))


def png(width, height, row_of, depth=8, color=0):
    """A PNG file; row_of(y) are the bytes of a row."""
    rows = b''.join(b'\0' + row_of(y) for y in range(height))
    return (b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>2I5B', width, height, depth, color, 0, 0, 0)) +
            chunk(b'IDAT', zlib.compress(rows)) + chunk(b'IEND', b''))


def half(width, left, right):
    return left * (width // 2) + right * (width - width // 2)


def picture(kind):
    """A mask of the left half."""
    if kind == 'rgb':
        return png(WIDTH, HEIGHT, lambda y: half(WIDTH, b'\0\0\0', b'\0\0\xff'), color=2)
    if kind == '16 bits':
        return png(WIDTH, HEIGHT, lambda y: half(WIDTH, b'\0\0', b'\0\1'), depth=16)
    if kind == 'gray with alpha':
        return png(WIDTH, HEIGHT, lambda y: half(WIDTH, b'\0\xff', b'\xff\xff'), color=4)
    if kind == 'alpha alone':
        return png(WIDTH, HEIGHT, lambda y: half(WIDTH, b'\0\0\0\0', b'\0\0\0\xff'), color=6)
    if kind == 'pgm':
        return b'P5\n%d %d\n255\n' % (WIDTH, HEIGHT) + half(WIDTH, b'\0', b'\xff') * HEIGHT
    factor = {'half': 0.5, 'double': 2, 'a tenth': 0.1}.get(kind, 1)
    width, height = int(WIDTH * factor), int(HEIGHT * factor)
    values = {'1 for use': (b'\0', b'\1'), 'nothing': (b'\0', b'\0'), 'everything': (b'\xff', b'\xff')}
    left, right = values.get(kind, (b'\0', b'\xff'))
    return png(width, height, lambda y: half(width, left, right))


def name_of(form, view):
    name = scene.image_name(view)
    return form.format(name=name, stem=name.rsplit('.', 1)[0])


def write(path, content):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)


def prepare_right(form, folder_name, kind, some):
    def prepare(folder, chooser):
        for view in range(scene.NUM_VIEWS):
            if not some or view % 2 == 0:
                write(folder / 'ws' / folder_name / name_of(form, view), picture(kind))
    return prepare


def prepare_alpha(values, also_masks):
    def prepare(folder, chooser):
        for view in range(scene.NUM_VIEWS):
            grays = scene.render(view)

            def row(y):
                return b''.join(bytes([gray, gray, gray, values[x * len(values) // WIDTH]])
                                for x, gray in enumerate(grays[y * WIDTH:(y + 1) * WIDTH]))

            write(folder / 'ws' / 'images' / scene.image_name(view), png(WIDTH, HEIGHT, row, color=6))
            if also_masks:
                write(folder / 'ws' / 'masks' / name_of(FORMS[0], view), picture('8 bits'))
    return prepare


def prepare_list(folder, chooser):
    lines = ['# masks']
    for view in range(scene.NUM_VIEWS):
        write(folder / 'ws' / 'elsewhere' / f'{view}.png', picture('8 bits'))
        lines.append(f'{scene.image_name(view)}\t../elsewhere/{view}.png')
    (folder / 'ws' / 'sparse' / 'masks.txt').write_text('\n'.join(lines) + '\n')


def prepare_wrong(kind):
    def prepare(folder, chooser):
        masks = folder / 'ws' / 'masks'
        good = picture('8 bits')
        bad = {'other aspect': png(100, 100, lambda y: b'\xff' * 100), 'truncated': good[:len(good) // 2],
               'text': b'not a picture', 'empty': b'',
               'huge header': good[:16] + struct.pack('>2I', 60000, 60000) + good[24:],
               'zero size': good[:16] + struct.pack('>2I', 0, 0) + good[24:]}.get(kind)
        if kind == 'missing folder':
            return
        if kind.startswith('list'):
            line = 'view_0.png masks/a.png' if kind == 'list without tab' else 'view_0.png\tmasks/a.png'
            write(folder / 'ws' / 'masks', (line + '\n').encode())
            return
        view = chooser.randrange(scene.NUM_VIEWS)
        for v in range(scene.NUM_VIEWS):
            name = {'no names fit': f'{v:04d}.png', 'of other images': f'other_{v}.png.png'}.get(kind, name_of(FORMS[0], v))
            write(masks / name, good)
        if kind == 'two forms':
            (masks / name_of(FORMS[0], view)).unlink()
            write(masks / name_of('{stem}.png', view), good)
            write(masks / name_of('{stem}.pgm', view), picture('pgm'))
        if kind == 'damaged, not in use':
            write(masks / 'other_1.png.png', good[:40])
        if kind == 'folder':
            (masks / name_of(FORMS[0], view)).unlink()
            (masks / name_of(FORMS[0], view)).mkdir()
        if bad is not None:
            write(masks / name_of(FORMS[0], view), bad)
    return prepare


def cases(seed, count):
    for index in range(count):
        chooser = hostile.chooser_of('masks', seed, -index - 1)
        kind = chooser.choice(KINDS)
        tail = () if chooser.random() < 0.3 else ('--page', '0')
        if kind == 'right':
            form, folder_name = chooser.choice(FORMS), chooser.choice(FOLDERS)
            content = chooser.choice(PICTURES)
            some = chooser.random() < 0.2
            # A photograph is no mask of itself.
            fits = not (folder_name == 'images' and form == '{stem}.png')
            name = f'{content} {folder_name}/{form}{", of some" if some else ""}'
            codes = ((0, 1) if content == 'nothing' and not some else (0,)) if fits else (0, 1)
            mask_path = '{dir}/ws/' + folder_name.split('/')[0]
            yield hostile.Case(name, prepare_right(form, folder_name, content, some),
                               [hostile.drawer('--mask_path', mask_path, *tail)], codes=codes, data={'kind': kind})
        elif kind == 'alpha':
            values = chooser.choice([[0, 255], [255, 255, 0], [255], [0], [127, 128], [1, 254], list(range(0, 256, 5))])
            also_masks = chooser.random() < 0.3
            options = ('--mask_path', '{dir}/ws/masks') if also_masks else ()
            yield hostile.Case(f'alpha {values[:4]}{" and masks" if also_masks else ""}', prepare_alpha(values, also_masks),
                               [hostile.drawer(*options, *tail)],
                               data={'kind': kind, 'hides': min(values) < 128 <= max(values)})
        elif kind == 'one for all':
            content = chooser.choice(PICTURES)
            yield hostile.Case(f'{content} for all', prepare_right('all.png', '.', content, False),
                               [hostile.drawer('--mask_path', '{dir}/ws/all.png', *tail)],
                               codes=(0, 1) if content == 'nothing' else (0,), data={'kind': kind})
        elif kind == 'list':
            yield hostile.Case('list', prepare_list, [hostile.drawer(*tail)], codes=(0,), data={'kind': kind})
        else:
            wrong = chooser.choice(WRONG)
            # What is not there, or belongs to no image in use, is told, and so is what is only in the place of a mask.
            codes = (0,) if wrong in ('folder', 'damaged, not in use') else (1,)
            yield hostile.Case(wrong, prepare_wrong(wrong), [hostile.drawer('--mask_path', '{dir}/ws/masks', *tail)],
                               names=['masks'], codes=codes, data={'kind': kind})


def check(case, outcome):
    broken = hostile.check(case, outcome)
    if outcome.code == 0 and case.data['kind'] == 'alpha':
        is_told = 'alpha channel' in outcome.output
        if is_told != case.data['hides']:
            broken.append('says that alpha is a mask' if is_told else 'does not say that alpha is a mask')
    if outcome.code == 0 and case.data['kind'] == 'list' and 'masks.txt' not in outcome.output:
        broken.append('does not name its list of masks')
    return broken
