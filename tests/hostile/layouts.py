# SPDX-License-Identifier: BSD-3-Clause
"""Projects in the layouts of other programs: nerfstudio, instant-ngp, gaussian-splatting, mip-NeRF 360, OpenSfM, openMVG, Metashape,
RealityCapture and more. A model that is found is drawn; cameras in another format are imported exactly, and a project
with nothing else names the command that imports them, or how to export them; files that are damaged are refused by a
line that names them."""

import json
import math
import pathlib
import random
import shutil

import hostile
import scene

WORKSPACE = '{dir}/ws'


# What the cameras are, in COLMAP's pixels.

def views():
    return [(scene.image_name(view), *scene.cam_from_world(view)) for view in range(scene.NUM_VIEWS)]


def transposed(matrix):
    return [list(column) for column in zip(*matrix)]


def product(a, b):
    return [[scene.dot(row, column) for column in transposed(b)] for row in a]


def center(rotation, translation):
    return [-scene.dot(column, translation) for column in transposed(rotation)]


def turn(axis, angle):
    """Matrix of a right-handed rotation about a coordinate axis."""
    i, j = (axis + 1) % 3, (axis + 2) % 3
    matrix = [[float(r == c) for c in range(3)] for r in range(3)]
    matrix[i][i] = matrix[j][j] = math.cos(angle)
    matrix[i][j], matrix[j][i] = -math.sin(angle), math.sin(angle)
    return matrix


def angle_axis(rotation):
    w, *vector = scene.quaternion(rotation)
    length = math.sqrt(scene.dot(vector, vector))
    angle = 2 * math.atan2(length, w)
    return [angle * v / length for v in vector] if length > 0 else [0.0, 0.0, 0.0]


def opengl_from(rotation):
    """World from camera, y up and z backwards."""
    return [[row[0], -row[1], -row[2]] for row in transposed(rotation)]


class Lens:
    """A random one of a program; the parameters that a file of it has, and COLMAP's."""

    def __init__(self, chooser, plain):
        self.plain = plain
        self.k = [0.0] * 3 if plain else [chooser.uniform(-0.2, 0.2), chooser.uniform(-0.05, 0.05), chooser.uniform(-0.02, 0.02)]
        self.p = [0.0] * 2 if plain else [chooser.uniform(-0.002, 0.002) for _ in range(2)]
        self.focal = scene.FOCAL if plain else scene.FOCAL * chooser.uniform(0.8, 1.2)
        self.center = [scene.WIDTH / 2, scene.HEIGHT / 2] if plain else [
            scene.WIDTH / 2 + chooser.uniform(-5, 5), scene.HEIGHT / 2 + chooser.uniform(-5, 5)]

    def project(self, point):
        """Through the pinhole and the lens, COLMAP's pixels."""
        x, y = point[0] / point[2], point[1] / point[2]
        u = x * x + y * y
        radial = 1 + u * (self.k[0] + u * (self.k[1] + u * self.k[2]))
        p1, p2 = self.p
        return [self.focal * (x * radial + 2 * p1 * x * y + p2 * (u + 2 * x * x)) + self.center[0],
                self.focal * (y * radial + 2 * p2 * x * y + p1 * (u + 2 * y * y)) + self.center[1]]


# Writers, a function per format: they return the path of what to import.

def write_nerf(folder, lens, chooser):
    scale = chooser.choice([1, 1, 2, 4])  # of pictures that were shrunk
    numbers = {'fl_x': scale * lens.focal, 'fl_y': scale * lens.focal, 'cx': scale * lens.center[0], 'cy': scale * lens.center[1],
               'w': scale * scene.WIDTH, 'h': scale * scene.HEIGHT}
    if not lens.plain:
        numbers.update(k1=lens.k[0], k2=lens.k[1], k3=lens.k[2], p1=lens.p[0], p2=lens.p[1])
    per_frame = chooser.random() < 0.3
    prefix = chooser.choice(['images/', './images/', '', 'images\\', '../other/images/', 'C:\\data\\images\\', 'images_4/'])
    frames = []
    for name, rotation, translation in views():
        c = center(rotation, translation)
        matrix = [row + [c[i]] for i, row in enumerate(opengl_from(rotation))] + [[0, 0, 0, 1]]
        frames.append({'file_path': prefix + name, 'transform_matrix': matrix, **(numbers if per_frame else {})})
    file = {'frames': frames, **({} if per_frame else numbers)}
    if chooser.random() < 0.5:
        file.update(camera_model='OPENCV', ply_file_path='sparse_pc.ply', applied_transform=[[1, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0]])
    path = folder / chooser.choice(['transforms.json', 'transforms.json', 'transforms_train.json', 'cameras.json'])
    path.write_text(json.dumps(file, indent=chooser.choice([None, 1])))
    return path


def write_opensfm(folder, lens, chooser):
    side = max(scene.WIDTH, scene.HEIGHT)
    camera = {'projection_type': 'brown', 'width': scene.WIDTH, 'height': scene.HEIGHT, 'focal_x': lens.focal / side,
              'focal_y': lens.focal / side, 'c_x': (lens.center[0] - scene.WIDTH / 2) / side,
              'c_y': (lens.center[1] - scene.HEIGHT / 2) / side, 'k1': lens.k[0], 'k2': lens.k[1], 'k3': lens.k[2], 'p1': lens.p[0],
              'p2': lens.p[1]}
    if lens.plain and chooser.random() < 0.5:
        camera = {'projection_type': 'perspective', 'width': scene.WIDTH, 'height': scene.HEIGHT, 'focal': lens.focal / side, 'k1': 0.0,
                  'k2': 0.0}
    shots = {name: {'rotation': angle_axis(rotation), 'translation': translation, 'camera': 'c', 'orientation': 1, 'capture_time': 0.0,
                    'gps_dop': 999999.0} for name, rotation, translation in views()}
    points = {str(i): {'coordinates': list(point), 'color': [1.0, 2.0, 3.0]} for i, point in enumerate(scene.scene_points())}
    largest = {'cameras': {'c': camera}, 'shots': shots, 'points': points, 'reference_lla': {'latitude': 0.0}}
    small = {'cameras': {'c': camera}, 'shots': dict(list(shots.items())[:2]), 'points': {}}
    folder = folder / 'opensfm' if chooser.random() < 0.3 else folder  # of OpenDroneMap
    folder.mkdir(exist_ok=True)
    path = folder / 'reconstruction.json'
    path.write_text(json.dumps(chooser.choice([[largest], [small, largest], [largest, small]])))
    if chooser.random() < 0.5:
        rows = ['OPENSFM_TRACKS_VERSION_v2'] if chooser.random() < 0.7 else []
        for i, point in enumerate(scene.scene_points()):
            for name, rotation, translation in views():
                x, y = lens.project([scene.dot(row, point) + t for row, t in zip(rotation, translation)])
                rows.append(f'{name}\t{i}\t{i}\t{(x - scene.WIDTH / 2) / side!r}\t{(y - scene.HEIGHT / 2) / side!r}\t0.004\t1\t2\t3\t-1\t-1')
        (folder / 'tracks.csv').write_text('\n'.join(rows) + '\n')
    return path


def write_openmvg(folder, lens, chooser):
    kind = 'pinhole_brown_t2' if not lens.plain else chooser.choice(['pinhole', 'pinhole_radial_k1', 'pinhole_radial_k3'])
    data = {'width': scene.WIDTH, 'height': scene.HEIGHT, 'focal_length': lens.focal,
            'principal_point': [lens.center[0] - 0.5, lens.center[1] - 0.5]}
    data.update({'pinhole': {}, 'pinhole_radial_k1': {'disto_k1': [0.0]}, 'pinhole_radial_k3': {'disto_k3': lens.k},
                 'pinhole_brown_t2': {'disto_t2': lens.k + lens.p}}[kind])
    first = 1 << 31
    file = {'sfm_data_version': '0.3', 'root_path': chooser.choice(['images', '/home/other/images', 'D:/images']), 'views': [],
            'extrinsics': [], 'structure': [], 'control_points': [],
            'intrinsics': [{'key': 0, 'value': {'polymorphic_id': first + 1, 'polymorphic_name': kind,
                                                'ptr_wrapper': {'id': first + 99, 'data': data}}}]}
    for i, (name, rotation, translation) in enumerate(views()):
        view = {'local_path': '', 'filename': name, 'width': scene.WIDTH, 'height': scene.HEIGHT, 'id_view': i, 'id_intrinsic': 0,
                'id_pose': i}
        file['views'].append({'key': i, 'value': {'polymorphic_id': 1 << 30, 'ptr_wrapper': {'id': first + i, 'data': view}}})
        file['extrinsics'].append({'key': i, 'value': {'rotation': rotation, 'center': center(rotation, translation)}})
    for i, point in enumerate(scene.scene_points()):
        seen = []
        for v, (_, rotation, translation) in enumerate(views()):
            x, y = lens.project([scene.dot(row, point) + t for row, t in zip(rotation, translation)])
            seen.append({'key': v, 'value': {'id_feat': i, 'x': [x - 0.5, y - 0.5]}})
        file['structure'].append({'key': i, 'value': {'X': list(point), 'observations': seen}})
    path = folder / chooser.choice(['sfm_data.json', 'sfm_data_perspective.json'])
    path.write_text(json.dumps(file, indent=chooser.choice([None, 4])))
    return path


def write_metashape(folder, lens, chooser):
    with_world = chooser.random() < 0.5
    scale = chooser.uniform(0.1, 10) if with_world else 1.0
    world = product(turn(2, chooser.uniform(-3, 3)), turn(0, chooser.uniform(-3, 3))) if with_world else turn(0, 0.0)
    shift = [chooser.uniform(-100, 100) for _ in range(3)] if with_world else [0.0] * 3
    cameras = []
    for name, rotation, translation in views():
        in_chunk = product(transposed(world), transposed(rotation))
        c = [scene.dot(row, scene.subtract(center(rotation, translation), shift)) / scale for row in transposed(world)]
        matrix = [row + [c[i]] for i, row in enumerate(in_chunk)] + [[0.0, 0.0, 0.0, 1.0]]
        label = name if chooser.random() < 0.5 else pathlib.Path(name).stem
        cameras.append(f'<camera id="{len(cameras)}" sensor_id="0" component_id="0" label="{label}">'
                       f'<transform>{" ".join(repr(v) for row in matrix for v in row)}</transform></camera>\n')
    size = f'<resolution width="{scene.WIDTH}" height="{scene.HEIGHT}"/>'
    values = {'f': lens.focal, 'cx': lens.center[0] - scene.WIDTH / 2, 'cy': lens.center[1] - scene.HEIGHT / 2, 'k1': lens.k[0],
              'k2': lens.k[1], 'k3': lens.k[2], 'p1': lens.p[1], 'p2': lens.p[0]}
    calibration = ''.join(f'<{name}>{value!r}</{name}>' for name, value in values.items() if value != 0 or name == 'f')
    transform = (f'<transform><rotation locked="false">{" ".join(repr(v) for row in world for v in row)}</rotation>'
                 f'<translation>{" ".join(map(repr, shift))}</translation><scale>{scale!r}</scale></transform>') if with_world else ''
    if chooser.random() < 0.5:
        transform = f'<components next_id="1" active_id="0"><component id="0" label="c">{transform}</component></components>'
    text = (f'<?xml version="1.0" encoding="UTF-8"?>\n<document version="2.0.0">\n<chunk label="Chunk 1" enabled="true">\n'
            f'<sensors next_id="1"><sensor id="0" label="a" type="frame">{size}<calibration type="frame" class="adjusted">{size}'
            f'{calibration}</calibration></sensor></sensors>\n{transform}<cameras>\n{"".join(cameras)}'
            f'<camera id="99" sensor_id="0" label="not aligned"/></cameras>\n</chunk>\n</document>\n')
    path = folder / chooser.choice(['cameras.xml', 'export 1.xml'])
    path.write_text(text)
    return path


def write_realitycapture(folder, lens, chooser):
    side = max(scene.WIDTH, scene.HEIGHT)
    columns = ['name', 'x', 'y', 'alt', 'heading', 'pitch', 'roll', 'f', 'px', 'py', 'k1', 'k2', 'k3', 'k4', 't1', 't2']
    rows = []
    for name, rotation, translation in views():
        m = opengl_from(rotation)
        angles = [math.atan2(m[0][1], m[1][1]), math.asin(m[2][1]), math.atan2(-m[2][0], m[2][2])]
        numbers = (center(rotation, translation) + [math.degrees(a) for a in angles] +
                   [36 * lens.focal / side, (lens.center[0] - scene.WIDTH / 2) / side, (lens.center[1] - scene.HEIGHT / 2) / side] +
                   lens.k + [0.0] + lens.p)
        rows.append(dict(zip(columns, [name] + [repr(n) for n in numbers])))
    if chooser.random() < 0.3:
        chooser.shuffle(columns)
    head = ('#cameras 8\n' if chooser.random() < 0.5 else '') + '#' + ','.join(columns) + '\n'
    path = folder / 'registration.csv'
    text = head + ''.join(','.join(row[column] for column in columns) + '\n' for row in rows)
    path.write_bytes(text.replace('\n', chooser.choice(['\n', '\r\n'])).encode())
    return path


WRITERS = {'nerf_transforms': write_nerf, 'opensfm': write_opensfm, 'openmvg': write_openmvg, 'metashape': write_metashape,
           'realitycapture': write_realitycapture}


# Layouts with a model in them: what is moved where, in the base project (images/, sparse/).
LAYOUTS = {
    'gaussian-splatting before convert': {'sparse': 'distorted/sparse/0', 'images': 'input'},
    'gaussian-splatting': {'sparse': 'sparse/0', 'images': 'images'},
    'nerfstudio': {'sparse': 'colmap/sparse/0', 'images': 'images'},
    'nerfstudio, shrunk': {'sparse': 'colmap/sparse/0', 'images': 'images_2'},
    'instant-ngp, text': {'sparse': 'colmap_text', 'images': 'images'},
    'instant-ngp': {'sparse': 'colmap_sparse/0', 'images': 'images'},
    'mip-NeRF 360': {'sparse': 'sparse/0', 'images': 'images_4'},
    'mapper into sparse/0': {'sparse': 'sparse/0/0', 'images': 'images'},
    'dense': {'sparse': 'dense/0/sparse', 'images': 'dense/0/images'},
}
# Those of which only an option can know: what the error names.
ELSEWHERE = {
    'photos': ({'sparse': 'sparse/0', 'images': 'photos'}, '--image_path'),
    'model elsewhere': ({'sparse': 'reconstruction/final', 'images': 'images'}, '--input_path'),
    'both elsewhere': ({'sparse': 'out/colmap/model', 'images': 'data/rgb'}, '--input_path'),
}
# Files that are not read, and a word of how to export them.
UNREAD = {'cameras.sfm': 'aliceVision_exportColmap', 'sfm.abc': 'aliceVision_exportColmap', 'scene.mvs': 'InterfaceCOLMAP',
          'poses_bounds.npy': 'LLFF', 'sfm_data.bin': 'ConvertSfM_DataFormat', 'project.psx': 'Agisoft XML',
          'scene.rcproj': 'Internal/External', 'database.db': 'colmap mapper'}


def rearrange(workspace, moves):
    """Moves by way of a folder aside, since a target may be below a source."""
    aside = workspace.parent / 'aside'
    aside.mkdir()
    for source in moves:
        shutil.move(workspace / source, aside / source)
    for source, target in moves.items():
        (workspace / target).parent.mkdir(parents=True, exist_ok=True)
        shutil.move(aside / source, workspace / target)
    aside.rmdir()


def add_clutter(workspace, chooser):
    """What such folders hold besides, none of it of use."""
    for name, content in chooser.sample([
            ('config.yaml', 'a: 1\n'), ('camera_models.json', '{}'), ('sparse_pc.ply', 'ply\n'), ('base_cam.json', '{"a": [1]}'),
            ('exif/view_0.png.exif', '{}'), ('matches/matches.f.bin', '\0'), ('point_cloud/iteration_7000/point_cloud.ply', 'ply\n'),
            ('.cache/x', ''), ('cfg_args', 'Namespace()'), ('run.log', 'ERROR\n'), ('masks/readme.txt', 'none\n'),
            ('results.csv', 'a,b\n1,2\n'), ('scene.xml', '<scene/>\n')], chooser.randint(0, 5)):
        (workspace / name).parent.mkdir(parents=True, exist_ok=True)
        (workspace / name).write_text(content)


def layout_case(chooser):
    name = chooser.choice(list(LAYOUTS))

    def prepare(folder, chooser):
        rearrange(folder / 'ws', LAYOUTS[name])
        add_clutter(folder / 'ws', chooser)

    return hostile.Case(f'layout of {name}', prepare, [hostile.drawer('--page', '0')], codes=(0,))


def elsewhere_case(chooser):
    name = chooser.choice(list(ELSEWHERE))
    moves, option = ELSEWHERE[name]

    def prepare(folder, chooser):
        rearrange(folder / 'ws', moves)
        add_clutter(folder / 'ws', chooser)

    return hostile.Case(f'{name}: an option', prepare, [hostile.drawer()], codes=(1,), names=[option])


def cameras_only_case(chooser):
    """The error has the command, which works as it is, and what it makes is drawn."""
    kind = chooser.choice(list(WRITERS))

    def prepare(folder, chooser):
        shutil.rmtree(folder / 'ws' / 'sparse')
        WRITERS[kind](folder / 'ws', Lens(chooser, plain=True), chooser)
        add_clutter(folder / 'ws', chooser)

    def run(program, folder):
        drawer = [part.replace('{dir}', str(folder)) for part in hostile.drawer('--page', '0')]
        code, _, errors, *_ = program.call(drawer, folder, 20)
        command = errors.split('`limn model_importer ')[-1].split('`')[0] if '`limn model_importer ' in errors else None
        if code != 1 or command is None:
            return code, '', errors + 'no command in this error\n'
        imported = hostile.run_command(['sh', '-c', f'"$0" model_importer {command}', str(program.limn)], folder, 20)
        if imported[0] != 0:
            return imported[:3]
        return program.call(drawer, folder, 20)[:3]

    return hostile.Case(f'only cameras of {kind}', prepare, [], codes=(0,), run=run, writes=('out', 'ws/sparse'))


def import_case(chooser):
    """Any lens; the model is compared with the cameras."""
    kind = chooser.choice(list(WRITERS))
    plain = chooser.random() < 0.3
    data = {'kind': kind}

    def prepare(folder, chooser):
        data['lens'] = Lens(chooser, plain)
        data['path'] = WRITERS[kind](folder / 'ws', data['lens'], chooser)

    def run(program, folder):
        return program.call(['model_importer', '--input_path', str(data['path']), '--image_path', str(folder / 'ws' / 'images'),
                             '--output_path', str(folder / 'out' / 'model'), '--output_type', 'txt'], folder, 20)[:3]

    return hostile.Case(f'import of {kind}{"" if plain else ", with a lens"}', prepare, [], codes=(0,), run=run, data=data)


def damage(path, chooser):
    """One change of a text; what it is."""
    content = bytearray(path.read_bytes())
    kind = chooser.choice(['cut', 'number', 'quote', 'bytes', 'empty', 'doubled', 'word'])
    if kind == 'cut':
        del content[chooser.randrange(len(content)):]
    elif kind == 'empty':
        content.clear()
    elif kind == 'doubled':
        content = content * 2
    elif kind == 'bytes':
        for _ in range(chooser.choice([1, 3, 30])):
            content[chooser.randrange(len(content))] = chooser.randrange(256)
    else:
        text = content.decode()
        old, new = {'number': (chooser.choice('0123456789'), chooser.choice(['1e300', 'nan', 'null', '-', '"a"', '1e-300', '99999999999'])),
                    'quote': ('"', chooser.choice(["'", '', '""'])), 'word': (chooser.choice(['{', '[', '<', ',', ':', 'e']), '')}[kind]
        places = [i for i in range(len(text)) if text.startswith(old, i)]
        if places:
            at = chooser.choice(places)
            text = text[:at] + new + text[at + len(old):]
        content = text.encode()
    path.write_bytes(content)


def damaged_case(chooser):
    kind = chooser.choice(list(WRITERS))
    data = {}

    def prepare(folder, chooser):
        data['path'] = WRITERS[kind](folder / 'ws', Lens(chooser, plain=chooser.random() < 0.5), chooser)
        tracks = data['path'].parent / 'tracks.csv'
        damage(tracks if tracks.exists() and chooser.random() < 0.3 else data['path'], chooser)

    def run(program, folder):
        return program.call(['model_importer', '--input_path', str(data['path']), '--image_path', str(folder / 'ws' / 'images'),
                             '--output_path', str(folder / 'out' / 'model'), '--input_type', kind], folder, 20)[:3]

    return hostile.Case(f'damaged cameras of {kind}', prepare, [], run=run, names=['/ws/'], keeps=())


def unread_case(chooser):
    name = chooser.choice(list(UNREAD))
    of_importer = name != 'database.db' and chooser.random() < 0.5

    def prepare(folder, chooser):
        shutil.rmtree(folder / 'ws' / 'sparse')
        (folder / 'ws' / name).write_bytes(b'MVSI' if name.endswith('.mvs') else chooser.randbytes(chooser.choice([0, 100])))
        add_clutter(folder / 'ws', chooser)

    importer = ['model_importer', '--input_path', '{dir}/ws/' + name, '--image_path', '{dir}/ws/images', '--output_path', '{dir}/out/model']
    return hostile.Case(f'{name} {"to import" if of_importer else "alone"}', prepare, [importer if of_importer else hostile.drawer()],
                        codes=(1,), names=[UNREAD[name]])


def missing_case(chooser):
    """Photographs that were deleted after the reconstruction."""
    count = chooser.choice([1, 2, 4, 8])
    skip = chooser.random() < 0.6

    def prepare(folder, chooser):
        for view in chooser.sample(range(scene.NUM_VIEWS), count):
            (folder / 'ws' / 'images' / scene.image_name(view)).unlink()

    good = skip and count < scene.NUM_VIEWS
    return hostile.Case(f'{count} photographs missing{", skipped" if skip else ""}', prepare,
                        [hostile.drawer('--page', '0', *(['--skip_missing_images', '1'] if skip else []))], codes=(0,) if good else (1,),
                        names=['--skip_missing_images 1' if count < scene.NUM_VIEWS else '--image_path'])


def few_case(chooser):
    """Three or four images are drawn."""
    count = chooser.choice([3, 3, 4])

    def prepare(folder, chooser):
        first = chooser.randrange(scene.NUM_VIEWS - count + 1)
        names = [scene.image_name(view) for view in range(first, first + count)]
        (folder / 'ws' / 'list.txt').write_text('\n'.join(names) + '\n')

    return hostile.Case(f'{count} images', prepare, [hostile.drawer('--page', '0', '--image_list_path', '{dir}/ws/list.txt')], codes=(0,),
                        data={'links': True})


GENERATORS = [layout_case, elsewhere_case, cameras_only_case, import_case, import_case, damaged_case, damaged_case, unread_case,
              missing_case, few_case]


def cases(seed, count):
    for index in range(count):
        chooser = random.Random(f'layouts {seed} {-index - 1}')
        yield chooser.choice(GENERATORS)(chooser)


def rows_of(path):
    return [line.split() for line in path.read_text().splitlines() if line and not line.startswith('#')]


def check_model(folder, lens):
    """Compares images.txt and cameras.txt with the views."""
    (_, model, width, height, *parameters), = rows_of(folder / 'cameras.txt')
    numbers = [float(p) for p in parameters]
    focals, rest = (numbers[:1] * 2, numbers[1:]) if model in ('SIMPLE_PINHOLE', 'RADIAL', 'SIMPLE_RADIAL') else (numbers[:2], numbers[2:])
    scale = int(width) / scene.WIDTH
    wanted = [scale * lens.focal] * 2 + [scale * c for c in lens.center] + lens.k[:2] + lens.p + lens.k[2:]
    found = focals + rest + [0.0] * (9 - len(focals + rest))
    broken = []
    if any(abs(a - b) > 1e-6 * max(1, abs(b)) for a, b in zip(found, wanted)):
        broken.append(f'camera {model} {found}, not {wanted}')
    poses = {row[9]: [float(v) for v in row[1:8]] for row in rows_of(folder / 'images.txt') if len(row) == 10 and row[9].endswith('.png')}
    for name, rotation, translation in views():
        quaternion = scene.quaternion(rotation)
        if name not in poses:
            broken.append(f'{name} is missing')
        elif 1 - abs(sum(a * b for a, b in zip(quaternion, poses[name]))) > 1e-12 or any(
                abs(a - b) > 1e-6 for a, b in zip(translation, poses[name][4:])):
            broken.append(f'pose of {name}: {poses[name]}, not {quaternion + translation}')
    return broken[:3]


def check(case, outcome):
    broken = hostile.check(case, outcome)
    if outcome.code == 0 and 'lens' in case.data:
        broken += check_model(outcome.folder / 'out' / 'model', case.data['lens'])
    if outcome.code == 0 and case.data.get('links') and not json.loads((outcome.folder / 'out' / 'drawing.json').read_text())['links']:
        broken.append('nothing is drawn')
    return broken
