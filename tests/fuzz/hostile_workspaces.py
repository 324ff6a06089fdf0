#!/usr/bin/env python3
"""Run Limn's commands on hostile workspaces, made from the sample scene by a seeded generator.

Every case changes numbers, names, options or kinds of files of a small project and runs one command. It must end with
exit code 0, 1 or 130, with exactly one line "ERROR: ..." where it is 1 and none where it is 0, without control
characters, within 60 s and 2 GB, and change nothing but the output folder. Prints the cases that fail, with the seed
that makes each again; exit code 1 if there are any.
"""

import argparse
import copy
import hashlib
import json
import os
import pathlib
import random
import shutil
import signal
import stat
import struct
import subprocess
import sys
import tempfile
import threading

NUM_VIEWS = 8
IMAGE_SIZE = 320
MAX_POINTS = 300

NUMBERS = [0.0, -0.0, 1.0, -1.0, 1e-300, 1e-45, 1e-12, 1e6, 1e9, 1e12, 1e37, 1e45, 1e150, 1e200, 1e308, -1e6, -1e37,
           -1e200, float('inf'), float('-inf'), float('nan'), 5e-324, 2.0**31, 2.0**32, 2.0**53, 2.0**63]
INTEGERS = [0, 1, -1, 2, 7, 2**15, 2**16, 2**31 - 1, 2**31, 2**32 - 1, 2**53, 2**63 - 1, -2**31]
NAMES = ['', ' ', '.', '..', '../view.jpg', '/etc/passwd', 'a\nb.jpg', 'a\tb.jpg', '\x1b[31mred.jpg', 'a"b,c.jpg',
         "a'b.jpg", 'x' * 255, 'x' * 300 + '.jpg', 'a b.jpg ', 'ä日本.jpg', 'view_00.jpg/x.png', '-rf', '--help',
         'a\\b.jpg', 'CON', '%s%n.jpg', '$(reboot).jpg', '<b>.jpg', './view_00.jpg', 'sub/../view_00.jpg']
OPTION_VALUES = ['', ' ', '0', '-1', '1', '-0', '1e-300', '1e9', '1e300', 'nan', 'inf', '-inf', '100000', '2147483648',
                 '9223372036854775808', 'true', 'x', '../x', '\x1b[31m', 'a\nb', '0x10', '1,2,3', '0,1,0,1,0,1',
                 '1,0,1,0,1,0', '/dev/null', '/dev/zero', '/dev/full']
# Words of messages that are not ours.
RAW_WORDS = ['exception', 'std::', 'bad_alloc', 'basic_string', 'vector::', 'terminate', 'Assertion', 'CHECK']
# Commands that read the model, and those that also, or only, read a drawing.
MAKERS = ['automatic_drawer', 'automatic_drawer', 'curve_sketcher', 'edge_extractor', 'curve_linker']
USERS = ['curve_drawer', 'drawing_refiner', 'drawing_viewer']
READERS = ['drawing_exporter', 'drawing_evaluator']
TAKEN_OPTIONS = ['--help_all', '--num_threads', '--workspace_path', '--output_path', '--max_image_size', '--input_path',
                 '--truth_path', '--taus', '--overwrite']
MODEL_NAMES = {0: 'SIMPLE_PINHOLE', 1: 'PINHOLE', 2: 'SIMPLE_RADIAL', 3: 'RADIAL', 4: 'OPENCV'}
NUM_PARAMS = {0: 3, 1: 4, 2: 4, 3: 5, 4: 8}


def unpack(stream, pattern):
    return struct.unpack('<' + pattern, stream.read(struct.calcsize('<' + pattern)))


def read_name(stream):
    name = b''
    while (byte := stream.read(1)) != b'\0':
        name += byte
    return name.decode()


class Model:
    """A COLMAP model of a few views."""

    def __init__(self, folder):
        self.cameras, self.images, self.points = [], [], []
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

    def write_text(self, folder):
        with open(folder / 'cameras.txt', 'w', encoding='utf-8') as f:
            for camera, model, width, height, params in self.cameras:
                f.write(join(camera, MODEL_NAMES.get(model, model), width, height, *params))
        with open(folder / 'images.txt', 'w', encoding='utf-8') as f:
            for image, pose, camera, name, pixels in self.images:
                f.write(join(image, *pose, camera, name))
                f.write(join(*[value for pixel in pixels for value in pixel]))
        with open(folder / 'points3D.txt', 'w', encoding='utf-8') as f:
            for point, place, color, error, track in self.points:
                f.write(join(point, *place, *color, error, *[value for entry in track for value in entry]))


def wrap(value, bits):
    value %= 2**bits
    return value - 2**bits if value >= 2**(bits - 1) else value


def join(*values):
    return ' '.join(repr(value) if isinstance(value, float) else str(value) for value in values) + '\n'


class Case:
    """One hostile project and one command on it."""

    def __init__(self, seed, arguments, base, folder):
        self.limn = arguments.limn
        self.sample = arguments.sample
        self.max_seconds = arguments.max_seconds
        self.max_mb = arguments.max_mb
        self.random = random.Random(seed)
        self.folder = folder
        self.changes = []
        self.workspace = folder / 'workspace'
        self.output = folder / 'output'
        (self.workspace / 'sparse').mkdir(parents=True)
        (self.workspace / 'images').mkdir()
        self.output.mkdir()
        self.model = copy.deepcopy(base)
        self.names = [image[3] for image in base.images]
        self.options = []
        self.kind = self.random.choice(['model', 'model', 'files', 'drawing'])
        self.command = self.random.choice(
            {'model': MAKERS + USERS, 'files': MAKERS + USERS + READERS, 'drawing': USERS + READERS}[self.kind])

    def number(self, value):
        if self.random.random() < 0.3:
            return value * 10.0**self.random.randint(-40, 40)
        return self.random.choice(NUMBERS)

    def change_camera(self):
        camera = self.random.choice(self.model.cameras)
        field = self.random.choice([0, 1, 2, 3, 4, 4, 4, 4])
        if field == 4:
            i = self.random.randrange(len(camera[4]))
            camera[4][i] = self.number(camera[4][i])
            self.changes.append(f'camera parameter {i} = {camera[4][i]}')
        else:
            camera[field] = self.random.choice(INTEGERS)
            self.changes.append(f'camera field {field} = {camera[field]}')

    def change_pose(self):
        images = self.random.choice([self.model.images, [self.random.choice(self.model.images)]])
        i = self.random.randrange(7)
        for image in images:
            image[1][i] = self.number(image[1][i])
        self.changes.append(f'pose value {i} of {len(images)} images = {images[0][1][i]}')

    def scale_scene(self):
        factor = 10.0**self.random.randint(-30, 30)
        for image in self.model.images:
            for i in (4, 5, 6):
                image[1][i] *= factor
        for point in self.model.points:
            point[1] = [value * factor for value in point[1]]
        self.changes.append(f'scene times {factor:g}')

    def change_name(self):
        image = self.random.choice(self.model.images)
        image[3] = self.random.choice(NAMES)
        self.changes.append(f'name {image[3]!r}')

    def change_image_ids(self):
        image = self.random.choice(self.model.images)
        field = self.random.choice([0, 2])
        image[field] = self.random.choice(INTEGERS)
        self.changes.append(f'image field {field} = {image[field]}')

    def change_point(self):
        point = self.random.choice(self.model.points)
        kind = self.random.randrange(4)
        if kind == 0:
            point[1][self.random.randrange(3)] = self.number(1.0)
        elif kind == 1:
            point[3] = self.number(1.0)
        elif kind == 2:
            point[4][0][self.random.randrange(2)] = self.random.choice(INTEGERS)
        else:
            point[0] = abs(self.random.choice(INTEGERS))
        self.changes.append(f'point {point[0]} {point[1]} {point[3]} {point[4][0]}')

    def repeat_image(self):
        self.model.images.append(copy.deepcopy(self.random.choice(self.model.images)))
        self.model.images[-1][0] += self.random.choice([0, 100])
        self.changes.append(f'image repeated as {self.model.images[-1][0]}')

    def change_option(self):
        options = [line.split()[0] for line in self.help().splitlines() if line.startswith('  --')]
        option = self.random.choice([o for o in options if o not in TAKEN_OPTIONS])
        value = self.random.choice(OPTION_VALUES)
        self.options.append(f'{option}={value}')
        self.changes.append(f'{option}={value!r}')

    def help(self):
        return subprocess.run([self.limn, self.command, '--help_all'], capture_output=True, text=True,
                              check=True).stdout

    def replace_file(self):
        files = sorted(p for p in self.folder.rglob('*') if p.is_file() and not p.is_symlink())
        file = self.random.choice(files)
        kind = self.random.choice(['empty', 'folder', 'pipe', 'loop', 'zero', 'full', 'cut', 'noise', 'missing',
                                   'unreadable', 'repeated'])
        content = file.read_bytes()
        if kind != 'unreadable':
            file.unlink()
        if kind == 'empty':
            file.touch()
        elif kind == 'folder':
            file.mkdir()
        elif kind == 'pipe':
            os.mkfifo(file)
        elif kind == 'loop':
            file.symlink_to(file)
        elif kind == 'zero':
            file.symlink_to('/dev/zero')
        elif kind == 'full':
            file.symlink_to('/dev/full')
        elif kind == 'cut':
            file.write_bytes(content[:self.random.randrange(len(content) + 1)])
        elif kind == 'noise':
            damaged = bytearray(content)
            for _ in range(self.random.randint(1, 64)):
                if damaged:
                    damaged[self.random.randrange(len(damaged))] = self.random.randrange(256)
            file.write_bytes(damaged)
        elif kind == 'unreadable':
            file.chmod(0)
        elif kind == 'repeated':
            file.write_bytes(content + content)
        self.changes.append(f'{file.relative_to(self.folder)}: {kind}')

    def change_drawing(self):
        path = self.output / 'drawing.json'
        if not path.is_file():
            return
        drawing = json.loads(path.read_text())
        node, key = drawing, None
        while isinstance(node, (dict, list)) and len(node) > 0:
            keys = list(node.keys()) if isinstance(node, dict) else range(len(node))
            parent, key = node, self.random.choice(list(keys))
            node = parent[key]
        value = self.random.choice([1e12, 1e37, 1e300, -1, 2**31, 2**53, None, '', 'x' * 1000, [], {}, True, 0])
        parent[key] = value
        path.write_text(json.dumps(drawing))
        self.changes.append(f'drawing.json: a {key!r} = {str(value)[:20]!r}')

    def make(self):
        of_model = [self.change_camera, self.change_pose, self.change_pose, self.scale_scene, self.change_name,
                    self.change_image_ids, self.change_point, self.repeat_image]
        of_files = [self.change_option, self.replace_file]
        is_text = self.random.random() < 0.3
        for name in self.names:
            shutil.copyfile(self.sample / 'images' / name, self.workspace / 'images' / name)
        if self.command not in MAKERS or self.random.random() < 0.3:
            shutil.copytree(self.folder.parent / 'drawn', self.output, dirs_exist_ok=True)
        possible = {'model': of_model, 'files': of_files, 'drawing': [self.change_drawing]}[self.kind]
        changes = [self.random.choice(possible) for _ in range(self.random.choice([1, 1, 1, 2, 3]))]
        if self.random.random() < 0.2:
            changes.append(self.random.choice(of_model + of_files))
        for change in changes:
            if change in of_model:
                change()
        folder = self.workspace / 'sparse'
        if is_text:
            self.model.write_text(folder)
        else:
            self.model.write_binary(folder)
        for image in self.model.images:
            self.show(image[3])
        for change in changes:
            if change not in of_model:
                change()

    def show(self, name):
        """Gives an image its picture if its name can be that of a file in the project."""
        path = pathlib.Path(os.path.normpath(self.workspace / 'images' / name))
        if not path.is_relative_to(self.workspace / 'images') or name == '':
            return
        try:
            if not path.exists():
                path.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(self.sample / 'images' / self.names[0], path)
        except (OSError, ValueError):
            pass

    def arguments(self):
        drawing = str(self.output / 'drawing.json')
        by_command = {
            'drawing_exporter': ['--input_path', drawing, '--output_path',
                                 str(self.output / ('x' + self.random.choice(['.dxf', '.glb', '.svg', '.obj'])))],
            'drawing_evaluator': ['--input_path', drawing, '--truth_path',
                                  str(self.sample.parent / 'truth' / 'curves.ply'), '--taus', '0.01'],
        }
        project = ['--workspace_path', str(self.workspace), '--output_path', str(self.output), '--max_image_size',
                   str(IMAGE_SIZE), '--num_threads', '2', '--overwrite', '1']
        if self.command not in ('automatic_drawer', 'curve_drawer'):
            project = project[:-2]
        return [self.command] + by_command.get(self.command, project) + self.options

    def run(self):
        """The rules that the run broke."""
        before = snapshot(self.workspace)
        process = subprocess.Popen([self.limn] + self.arguments(), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   stdin=subprocess.DEVNULL, cwd=self.folder, start_new_session=True)
        timer = threading.Timer(self.max_seconds, lambda: os.killpg(process.pid, signal.SIGKILL))
        timer.start()
        texts = {}
        reader = threading.Thread(target=lambda: texts.update(out=process.stdout.read()))
        reader.start()
        errors = process.stderr.read()
        reader.join()
        _, status, usage = os.wait4(process.pid, 0)
        timer.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        return self.broken(process.returncode, texts['out'], errors, usage.ru_maxrss // 1024,
                           before != snapshot(self.workspace))

    def broken(self, code, output, errors, peak_mb, is_changed):
        lines = [line for line in errors.decode(errors='replace').splitlines() if line.startswith('ERROR: ')]
        rules = []
        if code not in (0, 1, 130):
            rules.append(f'ended with {code}')
        if len(lines) != (1 if code == 1 else 0):
            rules.append(f'{len(lines)} error lines with exit code {code}')
        if any(word in line for line in lines for word in RAW_WORDS):
            rules.append('words of a library')
        if any(byte < 32 and byte not in b'\n\r\t' or byte == 127 for byte in output + errors):
            rules.append('control characters')
        if peak_mb > self.max_mb:
            rules.append(f'{peak_mb} MB')
        if is_changed:
            rules.append('the workspace is changed')
        if rules:
            rules.append('last words: ' + repr(errors.decode(errors='replace')[-300:]))
        return rules


def snapshot(folder):
    """Kinds, permissions and contents of all that is below a folder."""
    found = {}
    for path in sorted(folder.rglob('*')):
        info = path.lstat()
        digest = hashlib.sha1(path.read_bytes()).digest() if stat.S_ISREG(info.st_mode) and info.st_mode & 0o400 else b''
        found[str(path)] = (info.st_mode, info.st_size if stat.S_ISREG(info.st_mode) else 0, digest)
    return found


def draw_base(limn, sample, base, folder):
    """A finished drawing of the unchanged project."""
    workspace = folder / 'base'
    (workspace / 'sparse').mkdir(parents=True)
    (workspace / 'images').mkdir()
    base.write_binary(workspace / 'sparse')
    for image in base.images:
        shutil.copyfile(sample / 'images' / image[3], workspace / 'images' / image[3])
    subprocess.run([limn, 'automatic_drawer', '--workspace_path', workspace, '--output_path', folder / 'drawn',
                    '--max_image_size', str(IMAGE_SIZE), '--page', '0'], check=True, stdout=subprocess.DEVNULL)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('limn', type=pathlib.Path, help='the program')
    parser.add_argument('sample', type=pathlib.Path, help='datasets/sample/day')
    parser.add_argument('--seed', type=int, default=1, help='of the first case; the next ones follow')
    parser.add_argument('--cases', type=int, default=60)
    parser.add_argument('--max_seconds', type=float, default=60, help='more with sanitizers, as below')
    parser.add_argument('--max_mb', type=int, default=2048)
    parser.add_argument('--keep', action='store_true', help='keep the folders of cases that fail')
    arguments = parser.parse_args()
    arguments.limn = arguments.limn.resolve()
    arguments.sample = arguments.sample.resolve()
    base = Model(arguments.sample / 'sparse')
    num_failed = 0
    codes = {}
    root = pathlib.Path(tempfile.mkdtemp(prefix='limn_hostile_'))
    try:
        draw_base(arguments.limn, arguments.sample, base, root)
        for seed in range(arguments.seed, arguments.seed + arguments.cases):
            folder = root / f'case{seed}'
            folder.mkdir()
            case = Case(seed, arguments, base, folder)
            case.make()
            rules = case.run()
            if rules:
                num_failed += 1
                print(f'seed {seed}: {case.command}: {"; ".join(case.changes)}\n    ' + '\n    '.join(rules), flush=True)
            if not (rules and arguments.keep):
                remove(folder)
    finally:
        if not (num_failed and arguments.keep):
            remove(root)
        else:
            print(f'kept in {root}')
    print(f'{arguments.cases} cases, {num_failed} failed')
    return 1 if num_failed else 0


def remove(folder):
    subprocess.run(['chmod', '-R', 'u+rwX', folder], check=False, stderr=subprocess.DEVNULL)
    shutil.rmtree(folder, ignore_errors=True)


if __name__ == '__main__':
    sys.exit(main())
