#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Run all of Limn's commands on hostile workspaces, made from the sample scene by a seeded generator.

Every case changes numbers, names, images, options, kinds of files, stored results or other inputs of a small project
and runs one command, sometimes interrupted or without a standard output. It must end with exit code 0, 1 or 130, with
exactly one line "ERROR: ..." where it is 1 and none otherwise, without control characters or words of a library, within
60 s of processor time and 2 GB, and change nothing but the output folder. Prints the cases that fail, with the seed that
makes each again; exit code 1 if there are any.
"""

import argparse
import functools
import hashlib
import json
import os
import pathlib
import pickle
import random
import re
import shutil
import signal
import stat
import struct
import subprocess
import sys
import tempfile
import threading
import zlib

import hostile_files
from hostile_model import Model, ModelChanges

# A case hangs after so many times --max_seconds: a busy machine gives a program a part of its time.
PATIENCE = 3
# Of the processor time that a case may take: until then the program has begun.
START_SHARE = 1 / 200
IMAGE_SIZE = 320

OPTION_VALUES = ['', ' ', '0', '-1', '1', '-0', '2', '1e-300', '1e-9', '0.5', '1e9', '1e300', 'nan', 'inf', '-inf', '1000',
                 '100000', '2147483647', '2147483648', '9223372036854775808', '1e99999', 'true', 'x', '\x1b[31m', 'a\nb',
                 '\udcff', '0x10', '1,2,3', '1,1,1', '0,1,0,1,0,1', '1,0,1,0,1,0', '-1e300,1e300,-1e300,1e300,-1e300,1e300',
                 'nan,1,0,1,0,1', '1/2', '2/1', '0/0', '-1/2', 'x' * 5000]
HOSTILE_PATHS = ['', '/', '/dev/zero', '/dev/null', '/dev/full', '/proc/self/mem', '/proc/self/environ', '/missing/x.ply',
                 'a\nb', '\udcff.ply', 'x' * 5000, '\x1b[31m.json', '.']
# Words of messages that are not ours.
RAW_WORDS = ['exception', 'std::', 'bad_alloc', 'basic_string', 'vector::', 'terminate', 'Assertion', 'CHECK', 'Eigen',
             'Corrupt JPEG', 'Premature end', 'libpng', 'TIFFRead', 'TIFFFetch', 'TIFFOpen', 'OpenCV(', 'cv::', '.cc:', '.cpp:',
             'json.']
DRAWERS = ['automatic_drawer', 'automatic_drawer', 'automatic_drawer', 'curve_sketcher', 'edge_extractor',
           'curve_linker', 'curve_drawer', 'drawing_refiner', 'drawing_surfacer']
VIEWERS = ['drawing_viewer', 'drawing_fuser', 'truth_extractor', 'drawing_exporter', 'drawing_evaluator']
COMMANDS = {'model': DRAWERS + VIEWERS, 'images': DRAWERS + VIEWERS, 'files': DRAWERS + VIEWERS + ['model_importer'],
            'options': DRAWERS + VIEWERS + ['model_importer'], 'outputs': DRAWERS + VIEWERS + ['model_importer'],
            'drawing': ['drawing_refiner', 'drawing_surfacer'] + VIEWERS, 'stored': DRAWERS, 'cameras': ['model_importer'],
            'dense': VIEWERS}
REPLACING = ['automatic_drawer', 'curve_drawer', 'drawing_refiner', 'drawing_surfacer', 'drawing_fuser', 'drawing_viewer',
             'truth_extractor', 'drawing_exporter', 'drawing_evaluator']
RESULTS = ['drawing.json', 'drawing.ply', 'drawing.obj', 'drawing.html', 'drawing-fused.json', 'drawing-fused.ply',
           'curves', 'curves/.lock', 'curves/cache', 'curves/cache/fragments', 'curves/cache/sketch/view_00.jpg.bin',
           'curves/tracks.txt', 'curves/overlays', 'curves/overlays/view_00.jpg.png', 'curves/project.ini',
           'curves/account.csv', 'curves/swept-sketch.bin', 'curves/swept-sketch.ply', 'refined', 'refined/cameras.txt',
           'refined/cameras.bin', 'with-curves', 'with-curves/fused.ply', 'sparse-with-curves/cameras.bin', 'x.svg',
           'x.glb', 'x.csv', 'truth.ply', 'model', 'drawing.json.limn-tmp']
CAMERA_FORMATS = ['projection_matrices', 'intrinsic_extrinsic', 'bundler', 'nvm', 'middlebury', 'nerf_transforms']


@functools.cache
def option_defaults(limn, command):
    """Of all options whose values a case may change: not the workspace, beside which results would be written."""
    text = subprocess.run([limn, command, '--help_all'], capture_output=True, text=True, check=True).stdout
    found = dict(re.findall(r'^  (--\S+)(?: arg)?(?: \(=(.*?)\))?', text, re.MULTILINE))
    return {name: value for name, value in found.items() if name not in ('--help_all', '--workspace_path')}


class Case:
    """One hostile project and one command on it."""

    def __init__(self, seed, arguments, base, folder):
        self.limn = arguments.limn
        self.sample = arguments.sample
        self.max_seconds = arguments.max_seconds
        self.max_mb = arguments.max_mb
        self.random = random.Random(seed)
        self.folder = folder
        self.workspace = folder / 'workspace'
        self.output = folder / 'output'
        self.auxiliary = folder / 'auxiliary'
        self.model = pickle.loads(pickle.dumps(base))  # faster than deepcopy
        self.names = [image[3] for image in base.images]
        self.kind = self.random.choice(['model'] * 5 + ['files', 'files', 'options', 'options', 'drawing', 'stored',
                                                        'stored', 'images', 'images', 'cameras', 'dense', 'outputs'])
        self.command = self.random.choice(COMMANDS[self.kind])
        self.dense = self.random.choice(['depth_maps', 'fused', 'mesh', 'pmvs'])
        self.tiles = self.kind == 'stored' and self.command == 'automatic_drawer' and self.random.random() < 0.3
        self.options = {}
        self.changes = []
        self.code = None
        self.costs = ''

    def chance(self, probability):
        return self.random.random() < probability

    # The project, and what is changed in it.

    def make(self):
        for folder in (self.workspace / 'sparse', self.workspace / 'images', self.output, self.folder / 'beside'):
            folder.mkdir(parents=True)
        (self.folder / 'beside' / 'note.txt').write_text('not ours\n')
        for name in self.names:
            shutil.copyfile(self.sample / 'images' / name, self.workspace / 'images' / name)
        if self.kind in ('files', 'outputs') or self.command in VIEWERS or self.chance(0.1):
            hostile_files.write_dense(self.model, self.sample, self.workspace, self.dense)
        if self.command not in DRAWERS[:6] or self.kind == 'stored' or self.chance(0.4):
            drawn = self.folder.parent / ('tiled' if self.tiles else 'drawn')
            shutil.copytree(drawn, self.output, dirs_exist_ok=True)
        hostile_files.write_auxiliary(self.model, self.auxiliary)
        self.set_options()
        kinds = [self.kind] * self.random.choice([1, 1, 1, 2, 3])
        if self.chance(0.15):
            kinds.append(self.random.choice(['files', 'options', 'images', 'outputs']))
        if 'model' in kinds:
            changes = self.random.choices(ModelChanges(self.model, self.random).all(), k=len(kinds))
            self.changes += [change() for change in changes]
        self.model.write(self.workspace / 'sparse', self.chance(0.3))
        for image in self.model.images:
            self.show(image[3])
        for kind in kinds:
            if kind != 'model':
                self.changes.append(self.change(kind))

    def change(self, kind):
        try:
            return getattr(self, 'change_' + kind)()
        except (IndexError, OSError, ValueError, struct.error, zlib.error):
            if not self.changes:
                raise
            return f'{kind}: an earlier change left nothing to change'

    def show(self, name):
        """Gives an image its picture if its name can be that of a file in the project."""
        images = self.workspace / 'images'
        path = pathlib.Path(os.path.normpath(images / name))
        if path.is_relative_to(images) and name != '' and len(name) < 1000:
            try:
                if not path.exists():
                    path.parent.mkdir(parents=True, exist_ok=True)
                    shutil.copyfile(self.sample / 'images' / self.names[0], path)
            except (OSError, ValueError):
                pass

    def input_files(self):
        """What the command may read: not the files beside, and auxiliary ones if an option names them."""
        named = ' '.join(self.options.values())
        return sorted(p for p in self.folder.rglob('*') if p.is_file() and not p.is_symlink() and
                      'beside' not in p.parts and (self.auxiliary not in p.parents or str(p) in named or
                                                   (p.parent.name == 'masks' and str(p.parent) in named)))

    def change_files(self):
        by_folder = {}
        for file in self.input_files():
            by_folder.setdefault(file.parent, []).append(file)
        file = self.random.choice(self.random.choice(list(by_folder.values())))
        return f'{file.relative_to(self.folder)}: {hostile_files.damage(self.random, file)}'

    def change_images(self):
        images = [p for p in self.input_files() if p.suffix in ('.jpg', '.png') and self.output not in p.parents]
        return hostile_files.change_image(self.random, self.random.choice(images))

    def change_drawing(self):
        path = self.output / 'drawing.json'
        drawing = json.loads(path.read_text())
        told = hostile_files.change_json(self.random, drawing)
        path.write_text(json.dumps(drawing))
        return 'drawing.json: ' + told

    def change_stored(self):
        files = [p for p in self.input_files() if self.output in p.parents and p.suffix == '.bin'
                 and p.read_bytes()[:8] == b'limnfile']
        # Results of the last stages hide those of the first ones.
        file = self.random.choice(files)
        if 'fragments' in file.parts or self.chance(0.5):
            shutil.rmtree(self.output / 'curves' / 'cache' / 'sketch', ignore_errors=True)
            files = [p for p in files if p.is_file()]
            file = file if file.is_file() else self.random.choice(files)
        return hostile_files.change_stage_file(self.random, file)

    def change_cameras(self):
        file = self.random.choice([p for p in self.input_files() if 'cameras' in p.parts])
        if self.chance(0.3):
            return f'{file.name}: {hostile_files.damage(self.random, file)}'
        file.write_text(hostile_files.change_digits(self.random, file.read_text()))
        return f'{file.name}: a number'

    def change_dense(self):
        file = self.random.choice([p for p in self.input_files() if self.workspace in p.parents and
                                   (p.suffix in ('.ply', '.vis', '.patch') or 'depth_maps' in p.parts)])
        if self.chance(0.3):
            return f'{file.name}: {hostile_files.damage(self.random, file)}'
        content = file.read_bytes()
        if file.suffix == '.patch' or self.chance(0.2):  # the header of a binary file is text
            head, tail = content[:300].decode('latin-1'), content[300:]
            file.write_bytes(hostile_files.change_digits(self.random, head).encode('latin-1') + tail)
            return f'{file.name}: a number of its first lines'
        file.write_bytes(hostile_files.change_word(self.random, content))
        return f'{file.name}: a number'

    def change_outputs(self):
        """Something in the place of a result."""
        path = self.output / self.random.choice(RESULTS)
        for parent in reversed(path.parents):
            if parent.exists() and not parent.is_dir():
                return 'a result is there already'
        if path.is_dir() and not path.is_symlink():
            shutil.rmtree(path)
        path.unlink(missing_ok=True)
        path.parent.mkdir(parents=True, exist_ok=True)
        note = self.folder / 'beside' / 'note.txt'
        kind = self.random.choice(['link', 'dangling link', 'null', 'full', 'pipe', 'folder', 'full folder', 'file',
                                   'loop', 'read-only'])
        if kind == 'link':
            path.symlink_to(note)
        elif kind == 'dangling link':
            path.symlink_to(self.folder / 'beside' / 'new.txt')
        elif kind in ('null', 'full'):
            path.symlink_to('/dev/' + kind)
        elif kind == 'pipe':
            os.mkfifo(path)
        elif kind == 'loop':
            path.symlink_to(path)
        elif 'folder' in kind:
            path.mkdir()
            if kind == 'full folder':
                (path / 'note.txt').write_text('not ours\n')
        else:
            path.write_text('not ours\n')
            path.chmod(0o444 if kind == 'read-only' else 0o600)
        return f'output/{path.relative_to(self.output)}: {kind}'

    def defaults(self):
        return option_defaults(self.limn, self.command)

    def change_options(self):
        name, default = self.random.choice(list(self.defaults().items()))
        if name.startswith('--output_') and name != '--output_type':
            value = self.output_path()
        elif name.endswith('_path'):
            value = self.random.choice(HOSTILE_PATHS + [str(p) for p in self.input_files()[:30]] + [str(self.folder)])
        elif re.fullmatch(r'-?[\d.e-]+', default) and self.chance(0.5):
            value = f'{float(default) * 10.0**self.random.choice([-9, -3, -1, 1, 2, 3, 4, 6, 9]):g}'
        else:
            value = self.random.choice(OPTION_VALUES)
        self.options[name] = value
        return f'{name}={value[:100]!r}'

    def output_path(self):
        inputs = [p for p in self.input_files() if self.workspace in p.parents]
        is_file = self.command in ('drawing_exporter', 'drawing_evaluator', 'truth_extractor')
        names = ['drawing.json', 'curves/swept-sketch.bin', 'new/x.ply', 'ä b.json', 'a\nb.ply', '\udcff.ply',
                 'x' * 300, '\x1b[31m.ply', 'curves', '.']
        paths = [str(self.output / name) for name in names] + ['/dev/null/x', '/dev/full', '/proc/x.ply']
        if is_file and '--overwrite' in self.defaults() and self.chance(0.4):
            self.options['--overwrite'] = '0'
            return str(self.random.choice(inputs))
        return self.random.choice(paths)

    # The command.

    def set_options(self):
        getattr(self, 'set_options_of_' + self.command, self.set_options_of_project)()
        if self.command in REPLACING and self.chance(0.8):
            self.options['--overwrite'] = '1'
        if self.kind in ('files', 'images'):
            for option, value in (('--mask_path', 'masks'), ('--image_list_path', 'list.txt'),
                                  ('--project_path', 'options.ini')):
                if option in self.defaults() and self.chance(0.3):
                    self.options[option] = str(self.auxiliary / value)

    def set_options_of_project(self):
        self.options.update({'--workspace_path': str(self.workspace), '--output_path': str(self.output),
                             '--max_image_size': str(IMAGE_SIZE), '--num_threads': '2'})
        names = self.defaults()
        for option, value, probability in (
                ('--refine_cameras', '1', 0.2), ('--output_cameras', 'given', 0.2), ('--account', '1', 0.15), ('--page', '0', 0.5),
                ('--mode', 'enhanced', 0.1), ('--mode', 'original', 0.1), ('--Drawing.method', 'paper', 0.05),
                ('--cloud', 'dense', 0.3), ('--cloud', 'sparse', 0.3), ('--dense_type', self.dense, 0.3),
                ('--Tiles.max_views', '5', 1.0 if self.tiles else 0.05)):
            changes_the_cache = self.kind == 'stored' and option != '--Tiles.max_views'
            if option in names and not changes_the_cache and self.chance(probability):
                self.options[option] = value
        if '--update' in names and self.kind in ('stored', 'images') and self.chance(0.5):
            self.options['--update'] = '1'

    def set_options_of_truth_extractor(self):
        self.set_options_of_project()
        self.options['--output_path'] = str(self.output / 'truth.ply')
        if self.dense == 'fused':
            self.options['--cloud_path'] = str(self.workspace / 'fused.ply')
        else:
            self.options['--mesh_path'] = str(self.workspace / 'meshed-poisson.ply' if self.dense == 'mesh' else
                                              self.sample.parent / 'truth' / 'mesh.ply')

    def set_options_of_drawing_exporter(self):
        ending = self.random.choice(['dxf', 'glb', 'svg', 'svg', 'obj', 'ply', 'json', 'graphml', 'step'])
        self.options.update({'--input_path': str(self.output / 'drawing.json'),
                             '--output_path': str(self.output / ('x.' + ending))})
        if ending == 'svg' and (self.kind in ('model', 'images', 'dense') or self.chance(0.5)):
            self.options.update({'--view': self.names[0], '--workspace_path': str(self.workspace),
                                 '--photo': self.random.choice('01')})
        elif ending == 'svg' and self.dense == 'mesh':
            self.options['--dense_path'] = str(self.workspace / 'meshed-poisson.ply')
        elif ending == 'glb' and self.dense == 'fused':
            self.options['--cloud_path'] = str(self.workspace / 'fused.ply')

    def set_options_of_drawing_evaluator(self):
        truth = self.random.choice([self.sample.parent / 'truth' / 'curves.ply', self.auxiliary / 'points.txt',
                                    self.auxiliary / 'curves.obj', self.output / 'drawing.json'])
        self.options.update({'--input_path': str(self.output / 'drawing.json'), '--truth_path': str(truth),
                             '--taus': '0.01,0.1', '--num_threads': '2'})
        for option, value in (('--junctions_path', 'junctions.json'), ('--true_kinds_path', 'kinds.json'),
                              ('--dont_care_path', 'curves.obj')):
            if self.chance(0.3):
                self.options[option] = str(self.auxiliary / value)
        if truth.suffix == '.txt' and self.chance(0.5):
            self.options['--truth_edges_path'] = str(self.auxiliary / 'edges.txt')
        if self.kind in ('model', 'images') or self.chance(0.3):
            self.options.update({'--workspace_path': str(self.workspace), '--unit': 'footprint', '--taus': '1,4'})
        if self.chance(0.3):
            self.options.update({'--output_csv': str(self.output / 'x.csv'),
                                 '--output_json': str(self.output / 'x.json')})

    def set_options_of_model_importer(self):
        kind = self.random.choice(CAMERA_FORMATS)
        path = hostile_files.write_foreign_cameras(self.model, self.folder / 'cameras', kind)
        self.options.update({'--input_path': str(path), '--image_path': str(self.workspace / 'images'),
                             '--output_path': str(self.output / 'model'),
                             '--output_type': self.random.choice(['bin', 'txt'])})
        if kind == 'bundler':
            self.options['--list_path'] = str(self.folder / 'cameras' / 'list.txt')
        if self.chance(0.3):
            self.options['--input_type'] = kind

    def run(self):
        """The rules that the run broke."""
        before = snapshot(self.folder, self.output)
        stream = self.random.choice(['read'] * 18 + ['closed', 'full'])
        interrupt_after = self.random.uniform(0.02, 1) if self.chance(0.06) else 0
        if stream != 'read':
            self.changes.append(f'standard output {stream}')
        if interrupt_after:
            self.changes.append(f'interrupted after {interrupt_after:.2f} s')
        command = [self.limn, self.command] + [f'{name}={value}' for name, value in self.options.items()]
        closed = {'preexec_fn': lambda: os.close(1)} if stream == 'closed' else {}
        with open('/dev/full', 'wb') as full, tempfile.TemporaryFile() as output, tempfile.TemporaryFile() as errors:
            process = subprocess.Popen(command, stdout=full if stream == 'full' else output, stderr=errors,
                                       stdin=subprocess.DEVNULL, cwd=self.folder, start_new_session=True, **closed)
            timers = [threading.Timer(PATIENCE * self.max_seconds, process.send_signal, [signal.SIGKILL])]
            if interrupt_after:
                timers.append(threading.Timer(interrupt_after, process.send_signal, [signal.SIGINT]))
            for timer in timers:
                timer.start()
            _, status, usage = os.wait4(process.pid, 0)
            for timer in timers:
                timer.cancel()
            process.returncode = os.waitstatus_to_exitcode(status)
            texts = []
            for file in (output, errors):
                file.seek(0)
                texts.append(file.read())
        after = snapshot(self.folder, self.output)
        changed = [path for path in sorted({**before, **after}) if before.get(path) != after.get(path)]
        is_new = usage.ru_utime + usage.ru_stime < START_SHARE * self.max_seconds
        if interrupt_after and is_new and process.returncode == -signal.SIGINT:  # it does not listen yet
            process.returncode = 130
        self.code = process.returncode
        return self.broken(self.code, *texts, usage, changed)

    def broken(self, code, output, errors, usage, changed):
        errors = errors.decode(errors='replace')
        lines = errors.splitlines()
        num_errors = sum(line.startswith('ERROR: ') for line in lines)
        processor_s = usage.ru_utime + usage.ru_stime
        self.costs = f'{processor_s:.1f} s, {usage.ru_maxrss // 1024} MB'
        rules = []
        if code not in (0, 1, 130):
            rules.append(f'ended with {code}')
        if num_errors != (1 if code == 1 else 0):
            rules.append(f'{num_errors} error lines with exit code {code}')
        if len(lines) > num_errors + (1 if code == 130 else 0):  # an interrupted run tells what is kept
            rules.append(f'{len(lines)} lines on standard error')
        if any(word in line for line in lines for word in RAW_WORDS):
            rules.append('words of a library')
        if any(byte < 32 and byte not in b'\n\r\t' or byte == 127 for byte in output + errors.encode()):
            rules.append('control characters')
        if usage.ru_maxrss > self.max_mb * 1024:
            rules.append('too much memory')
        if processor_s > self.max_seconds:
            rules.append('too much processor time')
        if changed:
            rules.append(f'changed: {", ".join(changed[:5])}')
        if rules:
            rules.append('last words: ' + repr(errors[-300:]))
        return rules


def snapshot(folder, left_out):
    """Kinds, permissions and contents of all that is below a folder but not in another one."""
    found = {}
    for path in sorted(folder.rglob('*')):
        if path == left_out or left_out in path.parents:
            continue
        info = path.lstat()
        is_file = stat.S_ISREG(info.st_mode)
        digest = hashlib.sha1(path.read_bytes()).digest() if is_file and info.st_mode & 0o400 else b''
        found[str(path.relative_to(folder))] = (info.st_mode, info.st_size if is_file else 0, digest)
    return found


def draw_base(limn, sample, base, folder):
    """Finished drawings of the unchanged project, in one piece and in tiles."""
    workspace = folder / 'base'
    (workspace / 'sparse').mkdir(parents=True)
    (workspace / 'images').mkdir()
    base.write_binary(workspace / 'sparse')
    for image in base.images:
        shutil.copyfile(sample / 'images' / image[3], workspace / 'images' / image[3])
    for name, max_views in (('drawn', 150), ('tiled', 5)):
        subprocess.run([limn, 'automatic_drawer', '--workspace_path', workspace, '--output_path', folder / name,
                        '--max_image_size', str(IMAGE_SIZE), '--page', '0', '--Tiles.max_views', str(max_views)],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('limn', type=pathlib.Path, help='the program')
    parser.add_argument('sample', type=pathlib.Path, help='datasets/sample/day')
    parser.add_argument('--seed', type=int, default=1, help='of the first case; the next ones follow')
    parser.add_argument('--cases', type=int, default=60)
    parser.add_argument('--max_seconds', type=float, default=60, help='of processor time; more with sanitizers')
    parser.add_argument('--max_mb', type=int, default=2048)
    parser.add_argument('--keep', action='store_true',
                        help='keep the folders of cases that fail, and print their commands')
    parser.add_argument('--all', action='store_true', help='print the cases that pass, too')
    arguments = parser.parse_args()
    arguments.limn = arguments.limn.resolve()
    arguments.sample = arguments.sample.resolve()
    base = Model(arguments.sample / 'sparse')
    num_failed, codes = 0, {}
    root = pathlib.Path(tempfile.mkdtemp(prefix='limn_hostile_'))
    try:
        draw_base(arguments.limn, arguments.sample, base, root)
        for seed in range(arguments.seed, arguments.seed + arguments.cases):
            folder = root / f'case{seed}'
            folder.mkdir()
            case = Case(seed, arguments, base, folder)
            case.make()
            rules = case.run()
            codes[case.code] = codes.get(case.code, 0) + 1
            num_failed += 1 if rules else 0
            if rules or arguments.all:
                told = f'seed {seed}: {case.command}: {"; ".join(case.changes)}: exit code {case.code}, {case.costs}'
                print('\n    '.join([told] + rules), flush=True)
            if not (rules and arguments.keep):
                remove(folder)
            elif arguments.keep:
                print('   ', [case.command] + [f'{name}={value}' for name, value in case.options.items()], flush=True)
    finally:
        if not (num_failed and arguments.keep):
            remove(root)
        else:
            print(f'kept in {root}')
    told = ', '.join(f'{number} with exit code {code}' for code, number in sorted(codes.items()))
    print(f'{arguments.cases} cases ({told}), {num_failed} failed')
    return 1 if num_failed else 0


def remove(folder):
    subprocess.run(['chmod', '-R', 'u+rwX', folder], check=False, stderr=subprocess.DEVNULL)
    shutil.rmtree(folder, ignore_errors=True)


if __name__ == '__main__':
    sys.exit(main())
