# SPDX-License-Identifier: BSD-3-Clause
"""Pipes, sockets, devices, folders, loops, links to nowhere and empty files in the place of every file that is read."""

import os
import shutil
import socket

import hostile

KINDS = ['pipe', 'pipe', 'pipe', 'link to a pipe', 'socket', 'null', 'zero', 'full', 'folder', 'loop', 'dangling', 'empty']
MODEL = ['ws/sparse/cameras.bin', 'ws/sparse/images.bin', 'ws/sparse/points3D.bin', 'ws/sparse/rigs.bin',
         'ws/sparse/frames.bin', 'ws/images/view_3.png']
STORED = ['out/drawing.json', 'out/curves/swept-sketch.bin', 'out/curves/cache/sketch/view_3.png.bin',
          'out/curves/cache/fragments/view_3.png.bin', 'out/curves/project.ini', 'out/drawing.ply']


def put(path, kind):
    if os.path.lexists(path):
        shutil.rmtree(path) if path.is_dir() and not path.is_symlink() else path.unlink()
    path.parent.mkdir(parents=True, exist_ok=True)
    if kind == 'pipe':
        os.mkfifo(path)
    elif kind == 'link to a pipe':
        os.mkfifo(path.parent / (path.name + '.fifo'))
        path.symlink_to(path.name + '.fifo')
    elif kind == 'socket':
        here = os.open(path.parent, os.O_RDONLY)  # names of sockets are at most 107 bytes long
        before = os.getcwd()
        try:
            os.fchdir(here)
            socket.socket(socket.AF_UNIX).bind(path.name)
        finally:
            os.chdir(before)
            os.close(here)
    elif kind in ('null', 'zero', 'full'):
        path.symlink_to('/dev/' + kind)
    elif kind == 'folder':
        path.mkdir()
    elif kind == 'loop':
        path.symlink_to(path.name)
    elif kind == 'dangling':
        path.symlink_to('/nowhere/at/all')
    else:
        path.write_bytes(b'')


def project(command, *options):
    return [command, '--workspace_path', '{dir}/ws', '--output_path', '{dir}/out', '--overwrite', '1', *options]


# (file, command that reads it, whether there is a drawing to start from)
def choices():
    for file in MODEL:
        yield file, hostile.drawer(), False
        yield file, project('drawing_viewer'), True
        yield file, ['drawing_exporter', '--input_path', '{dir}/out/drawing.json', '--workspace_path', '{dir}/ws',
                     '--view', 'view_3.png', '--photo', '1', '--output_path', '{dir}/out/x.svg'], True
    for file in STORED:
        yield file, hostile.drawer(), True
        yield file, project('drawing_refiner'), True
    for command in ('drawing_viewer', 'drawing_regularizer', 'drawing_surfacer', 'drawing_fuser'):
        yield 'out/drawing.json', project(command), True
    yield 'out/drawing.json', ['drawing_aligner', '--workspace_path', '{dir}/ws', '--output_path', '{dir}/out'], True
    for option in ('--mask_path', '--edges_path'):
        yield 'side/view_3.png.png', hostile.drawer(option, '{dir}/side'), False
    for option in ('--image_list_path', '--project_path'):
        yield 'side/list', hostile.drawer(option, '{dir}/side/list'), False
    yield 'side/edits.json', project('drawing_editor', '--edits', '{dir}/side/edits.json'), True
    yield 'side/database.db', ['drawing_aligner', '--workspace_path', '{dir}/ws', '--output_path', '{dir}/out',
                               '--database_path', '{dir}/side/database.db'], True
    yield 'ws/database.db', ['drawing_aligner', '--workspace_path', '{dir}/ws', '--output_path', '{dir}/out'], True
    for file in ('ws/fused.ply', 'ws/fused.ply.vis', 'ws/meshed-poisson.ply', 'ws/stereo/depth_maps/view_3.png.geometric.bin'):
        yield file, project('drawing_fuser'), True
        yield file, project('drawing_viewer'), True
    for ending in ('json', 'ply', 'obj', 'txt'):
        yield 'side/curves.' + ending, ['drawing_exporter', '--input_path', '{dir}/side/curves.' + ending, '--output_path',
                                        '{dir}/out/x.obj'], False
        yield 'side/curves.' + ending, ['drawing_evaluator', '--input_path', '{dir}/out/drawing.json', '--truth_path',
                                        '{dir}/side/curves.' + ending, '--taus', '0.01,0.1', '--output_csv', '{dir}/out/x.csv'], True
    for ending, option in (('ply', '--mesh_path'), ('obj', '--mesh_path'), ('ply', '--cloud_path')):
        yield 'side/truth.' + ending, ['truth_extractor', '--workspace_path', '{dir}/ws', option, '{dir}/side/truth.' + ending,
                                       '--output_path', '{dir}/out/truth.ply'], False
    for name in ('bundle.out', 'x.nvm', 'transforms.json', 'cameras.txt', 'calib.intrinsic'):
        yield 'side/' + name, ['model_importer', '--input_path', '{dir}/side/' + name, '--image_path', '{dir}/ws/images',
                               '--output_path', '{dir}/out/model'], False


def cases(seed, count):
    for index in range(count):
        chooser = hostile.chooser_of('odd_files', seed, -index - 1)
        file, command, drawn = chooser.choice(list(choices()))
        kind = chooser.choice(KINDS)

        def prepare(folder, _, file=file, kind=kind):
            put(folder / file, kind)

        # The folder of the file may be what is named.
        yield hostile.Case(f'{kind} at {file}: {command[0]}', prepare, [command], drawn=drawn,
                           names=[os.path.basename(file), os.path.dirname(file), '/ws: no dense results'])


def check(case, outcome):
    return hostile.check(case, outcome)
