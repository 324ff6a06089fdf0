# SPDX-License-Identifier: BSD-3-Clause
"""Names of images in all encodings, in the model, on the disk and in lists: composed and decomposed, in code pages, garbled
by archives, with back slashes; some of them as they are in both places, some missing, some ambiguous."""

import os
import shutil
import unicodedata

import hostile
import scene

# (text, encodings that have it)
TEXTS = [('façade_é', ['utf-8', 'nfd', 'cp1252', 'cp850', 'latin-1']), ('Größe_ß', ['utf-8', 'nfd', 'cp1252', 'cp437']),
         ('微信截图', ['utf-8', 'gbk', 'gb18030']), ('截圖照片', ['utf-8', 'big5']),
         ('スクリーンショット', ['utf-8', 'nfd', 'shift_jis', 'euc_jp']), ('사진첩', ['utf-8', 'nfd', 'cp949']),
         ('Фасад', ['utf-8', 'cp1251', 'koi8-r', 'cp866']), ('Žluťoučký', ['utf-8', 'nfd', 'cp1250', 'cp852']),
         ('πρόσοψη', ['utf-8', 'nfd', 'cp1253']), ('תמונה', ['utf-8', 'cp1255']), ('ĞİŞ', ['utf-8', 'nfd', 'cp1254']),
         ('😀photo', ['utf-8', 'gb18030'])]
MISTAKES = ['cp437', 'cp850', 'cp1252', 'latin-1']
WAYS = ['same', 'other', 'other', 'other', 'garbled', 'back slashes', 'some missing', 'all missing', 'two files', 'two names',
        'random bytes']
LISTS = ['none', 'none', 'as in the model', 'as on the disk', 'windows', 'images/', 'bom', 'utf-16']


def encode(text, encoding):
    if encoding == 'nfd':
        return unicodedata.normalize('NFD', text).encode()
    return text.encode('utf-8' if encoding == 'utf-8' else encoding)


def garbled(text, chooser):
    """The bytes of the name, taken for another code page and stored as UTF-8."""
    for mistake in chooser.sample(MISTAKES, len(MISTAKES)):
        try:
            return text.encode().decode(mistake).encode()
        except UnicodeDecodeError:
            continue
    return text.encode()


def write_model(folder, names, is_text):
    """The model with these names, which are bytes."""
    model = scene.make_model()
    for view, image in enumerate(model.images):
        image[3] = f'@@{view}@@'
    shutil.rmtree(folder)
    folder.mkdir()
    model.write(folder, is_text)
    path = folder / ('images.txt' if is_text else 'images.bin')
    content = path.read_bytes()
    for view, name in enumerate(names):
        content = content.replace(b'@@%d@@' % view, name)
    path.write_bytes(content)


def list_of(kind, model_names, disk_names, chooser):
    names = disk_names if kind == 'as on the disk' else model_names
    some = chooser.sample(names, max(4, len(names) - 2))
    if kind == 'windows':
        return b''.join(b'C:\\Users\\me\\images\\' + name.replace(b'/', b'\\') + b'\r\n' for name in some)
    if kind == 'images/':
        return b'\n'.join(b'images/' + name for name in some)
    if kind == 'bom':
        return b'\xef\xbb\xbf' + b'\r\n'.join(some) + b'\r\n\r\n'
    if kind == 'utf-16':
        return '\r\n'.join(name.decode('utf-8', 'replace') for name in some).encode('utf-16')
    return b'\n'.join(some) + b'\n'


def names_of(way, chooser):
    """Names in the model and on the disk, of all views; None: no file."""
    text, encodings = chooser.choice(TEXTS)
    folder = chooser.choice(['', '', text + '/', 'sub/'])
    texts = [f'{folder}{text}_{view}.png' for view in range(scene.NUM_VIEWS)]
    in_model = chooser.choice(encodings)
    on_disk = in_model if way == 'same' else chooser.choice([e for e in encodings if e != in_model])
    model_names = [encode(name, in_model) for name in texts]
    disk_names = [encode(name, on_disk) for name in texts]
    if way == 'garbled':
        disk_names = [name.encode() for name in texts]
        model_names = [garbled(name, chooser) for name in texts]
        if chooser.random() < 0.5:
            model_names, disk_names = disk_names, model_names
    elif way == 'back slashes':
        texts = [f'sub/dir/{text}_{view}.png' for view in range(scene.NUM_VIEWS)]
        disk_names = [encode(name, on_disk) for name in texts]
        model_names = [encode(name.replace('/', '\\'), 'utf-8') for name in texts]
    elif way == 'random bytes':
        odd = [bytes(chooser.choice(range(128, 256)) for _ in range(8)) for _ in texts]
        model_names = [name + b'_%d.png' % view for view, name in enumerate(odd)]
        disk_names = list(model_names)
    missing = {'some missing': chooser.sample(range(len(texts)), 3), 'all missing': range(len(texts))}.get(way, [])
    for view in missing:
        disk_names[view] = None
    return model_names, disk_names


def prepare_with(way, list_kind):
    def prepare(folder, chooser):
        chooser = hostile.chooser_of('name_encodings', way, chooser.random())
        model_names, disk_names = names_of(way, chooser)
        if way == 'two names':
            model_names[1] = model_names[0]
        write_model(folder / 'ws' / 'sparse', model_names, chooser.random() < 0.3)
        images = os.fsencode(folder / 'ws' / 'images')
        for view, name in enumerate(disk_names):
            old = os.path.join(images, scene.image_name(view).encode())
            if name is None:
                os.unlink(old)
                continue
            new = os.path.join(images, name)
            os.makedirs(os.path.dirname(new), exist_ok=True)
            os.rename(old, new)
        if way == 'two files':
            # The same picture under all forms of a name.
            for form in ('NFC', 'NFD'):
                text = unicodedata.normalize(form, 'é_' + scene.image_name(0)).encode()
                with open(os.path.join(images, text), 'wb') as file:
                    file.write(scene.png(scene.WIDTH, scene.HEIGHT, scene.render(0)))
        if list_kind != 'none':
            known = [name for name, file in zip(model_names, disk_names) if file is not None] or model_names
            (folder / 'ws' / 'list.txt').write_bytes(list_of(list_kind, known, [n for n in disk_names if n] or known, chooser))
    return prepare


def cases(seed, count):
    for index in range(count):
        chooser = hostile.chooser_of('name_encodings', seed, -index - 1)
        way, list_kind = chooser.choice(WAYS), chooser.choice(LISTS)
        options = ('--image_list_path', '{dir}/ws/list.txt') if list_kind != 'none' else ()
        command = chooser.choice([hostile.drawer('--page', '0', *options), hostile.drawer(*options),
                                  ['edge_extractor', '--workspace_path', '{dir}/ws', '--output_path', '{dir}/out', *options]])
        must_run = way in ('same', 'other', 'back slashes', 'random bytes', 'two files') and list_kind in (
            'none', 'as in the model', 'as on the disk', 'windows', 'images/', 'bom')
        # Of bytes that are no text nothing but a list of the same bytes is sure.
        must_run = must_run and not (way == 'random bytes' and list_kind in ('images/', 'windows'))
        must_fail = way in ('all missing', 'two names') or list_kind == 'utf-16'
        yield hostile.Case(f'{way}, list {list_kind}', prepare_with(way, list_kind), [command],
                           names=['missing', 'occurs twice', 'list.txt', 'same name', 'at least 3', 'images/'],
                           codes=(0,) if must_run else (1,) if must_fail else (0, 1))


def check(case, outcome):
    return hostile.check(case, outcome)
