# SPDX-License-Identifier: BSD-3-Clause
"""Links at every depth of the output tree, in the place of folders and of files, for every command that writes there."""

import os
import shutil

import hostile
from odd_names import rename_image

# Places below the output folder.
CACHES = [f'curves/cache/{kind}' for kind in ('fragments', 'sketch', 'scene', 'edges', 'drawing')]
FOLDERS = ['curves', 'curves/cache', 'curves/overlays', 'curves/account', 'refined', *CACHES]
DEEP = ['sub', 'sub/deep', 'sub/deep/er']  # of an image in such a folder
IMAGE = 'sub/deep/er/view_3.png'
FILES = ['drawing.json', 'drawing.ply', 'drawing.obj', 'drawing.html', 'curves/tracks.txt', 'curves/project.ini',
         'curves/swept-sketch.bin', 'curves/swept-sketch.ply', 'curves/cameras.csv', 'curves/account.csv', 'curves/.lock',
         'curves/overlays/view_3.png.png', 'curves/account/view_3.png.png', 'curves/cache/sketch/view_3.png.bin',
         'curves/cache/fragments/view_3.png.bin', 'refined/cameras.bin', 'refined/images.txt', 'refined/limn.txt',
         'drawing.json.limn-tmp', 'curves/overlays/0123.limn-tmp', 'refined/0123.limn-tmp']
FUSED = ['with-curves', 'sparse-with-curves', 'with-curves/fused.ply', 'with-curves/fused-with-curves.ply',
         'with-curves/fused-with-curves.ply.vis', 'with-curves/sparse', 'sparse-with-curves/cameras.bin',
         'sparse-with-curves/rigs.bin', 'drawing-fused.json', 'drawing-fused.ply', 'drawing-fused.obj']
ALIGNED = ['aligned', 'aligned/sparse', 'aligned.limn-tmp', 'aligned.limn-tmp.limn-tmp']
EDGES = ['curves/edges', 'curves/fragments', 'curves/edges/view_3.png.edg', 'curves/fragments/view_3.png.cem']
TARGETS = ['full folder', 'full folder', 'empty folder', 'file', 'dangling', 'loop', 'relative', 'chain', 'hard link']
MINE = ['view_3.png.png', 'view_3.png.bin', 'view_3.png.edg', 'cameras.bin', 'fused.ply', 'fragments/view_3.png.bin',
        'deep/er/view_3.png.png', 'er/view_3.png.png', 'curves/overlays/view_3.png.png', 'drawing.json', 'x.limn-tmp']
OTHERS = ['curve_drawer', 'drawing_refiner', 'drawing_regularizer', 'drawing_surfacer', 'drawing_viewer', 'camera_refiner']


def put_link(path, target, outside):
    """Makes the link; `target` is one of TARGETS."""
    if os.path.lexists(path):
        shutil.rmtree(path) if path.is_dir() and not path.is_symlink() else path.unlink()
    path.parent.mkdir(parents=True, exist_ok=True)
    if target == 'full folder':
        path.symlink_to(outside / 'album')
    elif target == 'empty folder':
        path.symlink_to(outside / 'empty')
    elif target == 'file':
        path.symlink_to(outside / 'note.txt')
    elif target == 'dangling':
        path.symlink_to(outside / 'new')
    elif target == 'loop':
        path.symlink_to(path.name)
    elif target == 'relative':
        path.symlink_to(os.path.relpath(outside / 'album', path.parent))
    elif target == 'chain':
        (outside / 'chain').symlink_to('album')
        path.symlink_to(outside / 'chain')
    else:
        os.link(outside / 'note.txt', path)


def write_cloud(path):
    """A fused.ply of a few points."""
    points = [(x / 10, y / 10, 0) for x in range(-20, 20) for y in range(-18, 18)]
    header = (f'ply\nformat ascii 1.0\nelement vertex {len(points)}\n' +
              ''.join(f'property float {name}\n' for name in ('x', 'y', 'z', 'nx', 'ny', 'nz')) +
              ''.join(f'property uchar {name}\n' for name in ('red', 'green', 'blue')) + 'end_header\n')
    path.write_text(header + ''.join(f'{x} {y} {z} 0 0 1 128 128 128\n' for x, y, z in points))


def prepare_with(root, place, target, image_is_deep, is_fused):
    def prepare(folder, _):
        outside = folder / 'outside'
        (outside / 'empty').mkdir()
        for name in MINE:
            (outside / 'album' / name).parent.mkdir(parents=True, exist_ok=True)
            (outside / 'album' / name).write_text('mine\n')
        if is_fused:
            write_cloud(folder / 'ws' / 'fused.ply')
        if image_is_deep:
            rename_image(folder, IMAGE, True)
        put_link(folder / root / place, target, outside)
    return prepare


def in_output(chooser):
    """A case of the drawer, or of another command, with --output_path."""
    options = chooser.choice([(), (), ('--page', '0'), ('--account', '1'), ('--refine_cameras', '1')])
    drawn, is_deep, overwrite = chooser.random() < 0.5, False, chooser.random() < 0.6
    kind = chooser.choice(['drawer', 'drawer', 'deep', 'edges', 'fuser', 'aligner', 'other'])
    command = hostile.drawer(*options, overwrite=overwrite)
    place = chooser.choice(FOLDERS + FILES)
    if kind == 'deep':
        is_deep = True
        place = chooser.choice(['curves/overlays', *CACHES[:2]]) + '/' + chooser.choice(DEEP)
    elif kind == 'edges':
        place, name = chooser.choice([(EDGES[0], 'edg'), (EDGES[1], 'cem'), (EDGES[2], 'edg'), (EDGES[3], 'cem')])
        command = ['edge_extractor' if name == 'edg' else 'curve_linker', *command[1:7], '--format', name]
    elif kind == 'fuser':
        place, drawn = chooser.choice(FUSED), True
        command = ['drawing_fuser', *command[1:9]]
    elif kind == 'aligner':
        place, drawn = chooser.choice(ALIGNED), True
        command = ['drawing_aligner', *command[1:9], '--apply_to', 'project']
    elif kind == 'other':
        drawn = True
        command = [chooser.choice(OTHERS), *command[1:9]]
    # Where the aligner and others only read a file, a link is as good as the file.
    target = chooser.choice([target for target in TARGETS if '.' in place or target != 'hard link'])
    told = f'{target} at {place}: {" ".join([command[0], *command[9:]])}{", overwrite" if overwrite else ""}'
    return hostile.Case(told, prepare_with('out', place, target, is_deep, kind in ('fuser', 'aligner')), [command],
                        names=[place.split('/')[-1], 'out/curves', 'out/drawing'], drawn=drawn, keeps=(*hostile.KEPT, 'curves/.lock'))


def in_workspace(chooser):
    """The same without an output folder: the project, or its dense part, has the link."""
    is_dense = chooser.random() < 0.5
    target = chooser.choice(TARGETS[:-1])

    def prepare(folder, random):
        ws = folder / 'ws'
        if is_dense:
            (ws / 'dense' / '0').mkdir(parents=True)
            for name in ('sparse', 'images'):
                (ws / name).rename(ws / 'dense' / '0' / name)
        if place in ('dense', 'dense/0'):
            # All of it lies elsewhere.
            (ws / place).rename(folder / 'outside' / 'moved')
            (ws / place).symlink_to(folder / 'outside' / 'moved')
            return
        prepare_with('ws/dense/0' if is_dense else 'ws', place, target, False, False)(folder, random)

    place = chooser.choice(FOLDERS + ['drawing.json', 'drawing.html'] + (['dense', 'dense/0'] if is_dense else []))
    return hostile.Case(f'{target} at {place} of a {"dense " if is_dense else ""}workspace', prepare,
                        [['automatic_drawer', '--workspace_path', '{dir}/ws', '--num_threads', '2', '--overwrite', '1']],
                        names=[place, 'output_path'], writes=('ws',),
                        keeps=('curves/cache', 'dense/0/curves/cache'))


def cases(seed, count):
    for index in range(count):
        chooser = hostile.chooser_of('output_links', seed, -index - 1)
        yield in_workspace(chooser) if chooser.random() < 0.25 else in_output(chooser)


def check(case, outcome):
    return hostile.check(case, outcome)
