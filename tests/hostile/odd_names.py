# SPDX-License-Identifier: BSD-3-Clause
"""Names with characters that terminals, shells and other programs obey or mistake: of images, folders, files and values
of options. No line of limn may show them raw."""

import os

import hostile
from scene import Model

# What stands between two plain parts of a name.
ODD = ['\n', '\r', '\t', '\x07', '\x1b[31m', '\x1b]0;x\x07', '\x7f', '\x80', '\x9b31m', '\u00ad', '\u0600', '\u061c', '\u180e',
       '\u200b', '\u200d', '\u200e', '\u200f', '\u2028', '\u2029', '\u202a', '\u202d', '\u202e', '\u2060', '\u2066', '\u2069',
       '\ufeff', '\ufff9', '\U000e0001', '\U000e0041', '\udc9b31m', '\udcff', '\udce4', '\udcc2', '\udced\udca0\udc80', ' ', '  ',
       '"', "'", '\\', '\\n', '`x`', '$(x)', '%s%n', '%2e', '<b>', '</script>', '&amp;', ';', '|', '*', '?', '[', '{}', '~',
       '#', '=', ',', ':', '\u00a0', '\u3000', 'e\u0301', '\u00e9', '\u65e5\u672c', '\u0627\u0644\u0639',
       '\U0001f600', '\u0130', '\uff0f', '\u2044', '\ufffd', '\ue000']
BEGINS = ['', '', '', '-', '--', '.', ' ', '\u202e', '\ufeff', '#']
ENDS = ['', '', '', ' ', '.', '\n', '\u202c', '\t']
PLAIN = 'odd7'  # in every name: an error shows it


def odd_name(chooser):
    """A file name, at most 200 bytes long."""
    middle = ''.join(chooser.choice(ODD) + chooser.choice(['', 'x', 'y z']) for _ in range(chooser.choice([1, 1, 1, 2, 5])))
    if chooser.random() < 0.05:
        middle += 'n' * 150
    return chooser.choice(BEGINS) + PLAIN + middle + chooser.choice(ENDS)


def rename_image(folder, name, on_disk):
    """The fourth image of the project gets this name; on disk it may be missing."""
    model = Model(folder / 'ws' / 'sparse')
    old, raw = model.images[3][3], os.fsencode(name)
    # Lengths of records do not depend on names: the name is replaced in the file.
    path = folder / 'ws' / 'sparse' / 'images.bin'
    path.write_bytes(path.read_bytes().replace(old.encode() + b'\0', raw + b'\0'))
    image = folder / 'ws' / 'images' / old
    if on_disk:
        target = os.fsencode(folder / 'ws' / 'images') + b'/' + raw
        os.makedirs(os.path.dirname(target), exist_ok=True)
        os.rename(image, target)
    else:
        image.unlink()


def image_case(name, on_disk):
    def prepare(folder, _):
        rename_image(folder, name, on_disk)
    return hostile.Case(f'image {name!r}{"" if on_disk else ", missing"}', prepare, [hostile.drawer()],
                        names=[PLAIN, 'images.bin'],
                        codes=(0, 1) if on_disk else (1,))


def output_case(name):
    return hostile.Case(f'output folder {name!r}', lambda folder, _: None,
                        [['automatic_drawer', '--workspace_path', '{dir}/ws', '--output_path', '{dir}/out/' + name]],
                        names=[PLAIN], keeps=(name + '/curves/cache',))


def workspace_case(name):
    name = name.replace('/', '_')

    def prepare(folder, _):
        os.rename(folder / 'ws', os.fsencode(folder) + b'/' + os.fsencode(name))
    return hostile.Case(f'workspace {name!r}', prepare,
                        [['automatic_drawer', '--workspace_path', '{dir}/' + name, '--output_path', '{dir}/out']],
                        names=[PLAIN])


def export_case(name, ending):
    return hostile.Case(f'exported file {name + ending!r}', lambda folder, _: None,
                        [['drawing_exporter', '--input_path', '{dir}/out/drawing.json', '--output_path',
                          '{dir}/out/' + name + ending]], names=[PLAIN], drawn=True)


def missing_case(name, option):
    return hostile.Case(f'{option} {name!r}', lambda folder, _: None, [hostile.drawer(option, '{dir}/' + name)],
                        names=[PLAIN], codes=(0, 1))


def value_case(name, option):
    return hostile.Case(f'value {name!r} of {option}', lambda folder, _: None, [hostile.drawer(f'{option}={name}')],
                        codes=(1,), names=[PLAIN])


def command_case(name):
    return hostile.Case(f'command {name!r}', lambda folder, _: None, [[name]], codes=(0, 1), names=[PLAIN])


def list_case(name):
    def prepare(folder, _):
        (folder / 'list.txt').write_bytes(b'view_1.png\nview_2.png\n' + os.fsencode(name) + b'\n')
    return hostile.Case(f'list of images with {name!r}', prepare,
                        [hostile.drawer('--image_list_path', '{dir}/list.txt')], names=[PLAIN, 'list.txt'])


def options_file_case(name):
    def prepare(folder, _):
        (folder / 'options.ini').write_bytes(os.fsencode(f'{name}=1\n'))
    return hostile.Case(f'option {name!r} in a file', prepare,
                        [hostile.drawer('--project_path', '{dir}/options.ini')], names=[PLAIN, 'options.ini'])


def cases(seed, count):
    for index in range(count):
        chooser = hostile.chooser_of('odd_names', seed, -index - 1)
        name = odd_name(chooser)
        kind = chooser.choice(['image', 'image', 'missing image', 'output', 'workspace', 'export', 'path', 'value', 'command',
                               'list', 'options'])
        if kind in ('image', 'missing image'):
            yield image_case(name, kind == 'image')
        elif kind == 'output':
            yield output_case(name)
        elif kind == 'workspace':
            yield workspace_case(name)
        elif kind == 'export':
            yield export_case(name, chooser.choice(['.obj', '.ply', '.dxf', '.glb', '.svg', '.json', '.graphml', '.' + name]))
        elif kind == 'path':
            yield missing_case(name, chooser.choice(['--mask_path', '--image_path', '--input_path', '--project_path',
                                                     '--edges_path', '--image_list_path']))
        elif kind == 'value':
            yield value_case(name, chooser.choice(['--quality', '--mode', '--box', '--account', '--shard']))
        elif kind == 'command':
            yield command_case(name)
        else:
            yield list_case(name) if kind == 'list' else options_file_case(name)


def check(case, outcome):
    return hostile.check(case, outcome)
