# SPDX-License-Identifier: BSD-3-Clause
"""Small files that ask for much work or memory: JSON of many keys or values, PLY headers without end, meshes that cover a
picture many times over, drawings with hubs, many dimensions or one long link.
"""

import gzip
import json
import math
import pathlib
import struct

import hostile
import scene

FORMATS = ['ply', 'obj', 'json', 'dxf', 'glb', 'svg', 'graphml', 'step']
XYZ = 'property float x\nproperty float y\nproperty float z\n'


def export(extension, *options):
    return ['drawing_exporter', '--input_path', '{dir}/out/drawing.json', '--output_path', f'{{dir}}/out/x.{extension}',
            '--kinds', 'all', '--tentative', '1', *options]


def on_project(command, *options):
    return [command, '--workspace_path', '{dir}/ws', '--output_path', '{dir}/out', '--num_threads', '2', *options]


EDIT = on_project('drawing_editor', '--overwrite', '1', '--edits', '{dir}/ws/edits.json')
EDITS_HEAD = '{"format":"limn_edits","format_version":1,"edits":['
FUSE = on_project('drawing_fuser', '--overwrite', '1')


def json_text(chooser):
    """Much JSON of no use, of up to some megabytes."""
    count = chooser.choice([20_000, 100_000, 400_000])
    kind = chooser.choice(['keys', 'same keys', 'nested keys', 'numbers', 'lists', 'objects', 'texts', 'deep', 'long text',
                           'digits', 'escapes', 'closed'])
    return {'keys': lambda: '{' + ','.join(f'"k{i}":1' for i in range(count)) + '}',
            'same keys': lambda: '{' + ','.join(['"k":1'] * count) + '}',
            'nested keys': lambda: '[' + ','.join(['{"a":{"b":{"c":1,"d":2}}}'] * (count // 4)) + ']',
            'numbers': lambda: '[' + ','.join(['0'] * (4 * count)) + ']', 'lists': lambda: '[' + ','.join(['[]'] * count) + ']',
            'objects': lambda: '[' + ','.join(['{}'] * count) + ']', 'texts': lambda: '[' + ','.join(['""'] * count) + ']',
            'deep': lambda: '[' * count + ']' * count, 'long text': lambda: '"' + 'x' * (8 * count) + '"',
            'digits': lambda: '1' * count, 'escapes': lambda: '"' + '\\u0000' * count + '"',
            'closed': lambda: '[{"a":[1,2]}' * count}[kind]()


def many_keys(folder, chooser):
    """A drawing with much JSON beside its own"""
    path = pathlib.Path(folder, 'out', 'drawing.json')
    text = path.read_text().rstrip()[:-1]
    path.write_text(f'{text},"more":{json_text(chooser)}}}')


def only_json(folder, chooser):
    """A drawing that is much JSON"""
    pathlib.Path(folder, 'out', 'drawing.json').write_text(json_text(chooser))


def packed_json(folder, chooser):
    """A drawing that is packed"""
    data = gzip.compress(('{"format":"limn-drawing","format_version":1,"views":[],"options":{},"nodes":[' + ' ' * chooser.choice(
        [10**7, 2 * 10**8]) + '],"links":[]}').encode(), 9)
    pathlib.Path(folder, 'out', 'drawing.json').write_bytes(data)


def changed(change):
    def prepare(folder, chooser):
        path = pathlib.Path(folder, 'out', 'drawing.json')
        drawing = json.loads(path.read_text())
        change(drawing, chooser)
        path.write_text(json.dumps(drawing))
    prepare.__doc__ = change.__doc__
    return prepare


def line(points):
    return {'type': 'line', 'start': points[0], 'end': points[-1], 'rms_px': 0.1, 'max_px': 0.1}


def make_link(number, node0, node1, points, views):
    return {'id': number, 'node0': node0, 'node1': node1, 'closed': False, 'length': 1, 'residual_px': 0.1, 'kind': 'edge',
            'kind_confidence': 0.9, 'primitive': line(points), 'supporting_views': views, 'members': [], 'points': points,
            'sigma': [0.001] * len(points)}


def make_node(position, kind, incident):
    return {'position': position, 'kind': kind, 'degree': len(incident), 'incident': incident, 'continuations': []}


@changed
def many_links(drawing, chooser):
    """A drawing of many links"""
    links, nodes = [], []
    for number in range(chooser.choice([5_000, 20_000])):
        start = [chooser.uniform(-1, 1) for _ in range(3)]
        points = [[start[0] + 0.01 * k, start[1], start[2]] for k in range(3)]
        links.append(make_link(number, 2 * number, 2 * number + 1, points, drawing['views'][:4]))
        nodes += [make_node(points[0], 'end', [[number, 0]]), make_node(points[-1], 'end', [[number, 1]])]
    drawing.update(links=links, nodes=nodes)


@changed
def hub(drawing, chooser):
    """A drawing in which all links meet"""
    count = chooser.choice([3_000, 10_000, 30_000])
    links, nodes = [], [make_node([0, 0, 0.5], 'junction', [[k, 0] for k in range(count)])]
    for number in range(count):
        angle = number * 2 * math.pi / count
        points = [[0, 0, 0.5], [math.cos(angle), math.sin(angle), 0.5 + 0.1 * chooser.random()]]
        links.append(make_link(number, 0, number + 1, points, drawing['views'][:4]))
        nodes.append(make_node(points[1], 'end', [[number, 1]]))
    if chooser.random() < 0.5:
        nodes[0]['continuations'] = [[[k, 0], [k + 1, 0]] for k in range(0, count - 1, 2)]
    drawing.update(links=links, nodes=nodes)


@changed
def long_link(drawing, chooser):
    """A link of very many points"""
    link = drawing['links'][0]
    first, last, count = link['points'][0], link['points'][-1], chooser.choice([30_000, 200_000])
    bend = chooser.choice([0, 0.01, 1])
    link['points'] = [first] + [[first[i] + (last[i] - first[i]) * k / count + bend * math.sin(k + i) for i in range(3)]
                                for k in range(1, count)] + [last]
    link['sigma'] = [0.001] * (count + 1)
    link.pop('primitive', None)
    if chooser.random() < 0.3:
        link['points'][1:-1] = [first] * (count - 1)


@changed
def long_spline(drawing, chooser):
    """A spline of very many control points"""
    link = chooser.choice(drawing['links'])
    count = chooser.choice([1_000, 50_000])
    points = [[p + 1e-3 * chooser.random() for p in link['points'][k * len(link['points']) // count]] for k in range(count)]
    link['primitive'] = {'type': 'spline', 'degree': 3, 'control_points': points, 'rms_px': 0.1, 'max_px': 0.1,
                         'knots': [0.] * 4 + [k + 1. for k in range(count - 4)] + [count - 3.] * 4}


@changed
def many_dimensions(drawing, chooser):
    """Very many dimensions"""
    count = chooser.choice([5_000, 50_000])
    drawing['dimensions'] = [{'from': [0, 0, 0], 'to': [1, 1, 1e-5 * k], 'shift': [0, 0, 0.1]} for k in range(count)]


@changed
def many_views(drawing, chooser):
    """Very many names of views"""
    count = chooser.choice([10_000, 200_000])
    drawing['views'] = [f'v{k}' for k in range(count)]
    for link in drawing['links']:
        link['supporting_views'] = [f'v{count - 1}']


@changed
def many_triangles(drawing, chooser):
    """Faces of very many triangles"""
    count, faces = chooser.choice([(1_000, 1), (200_000, 1), (1_000_000, 1), (10, 3_000), (1, 10_000)])
    size = chooser.choice([1, 1, 0.01, 100])
    if chooser.random() < 0.5:
        vertices = [[-size, -size, 0.4], [size, -size, 0.5], [0, size, 0.6]]
        triangles = [[0, 1, 2]] * count
    else:
        vertices = [[size * chooser.uniform(-1, 1) for _ in range(3)] for _ in range(100)]
        triangles = [chooser.sample(range(100), 3) for _ in range(min(count, 50_000))]
    border = [{'bridge': [vertices[k], vertices[(k + 1) % 3]]} for k in range(3)]
    drawing['faces'] = [{'id': 0, 'surface': 'plane', 'area': 1, 'confidence': 1, 'normal': [0, 0, 1], 'offset': 0, 'views': [],
                         'loops': [border], 'vertices': vertices, 'triangles': triangles}] * faces


@changed
def long_border(drawing, chooser):
    """A face with a border of very many edges"""
    count = chooser.choice([1_000, 4_000, 20_000])
    corners = [[(1 if k % 2 else chooser.choice([0.2, 0.99])) * f(2 * math.pi * k / count) for f in (math.cos, math.sin)] + [0]
               for k in range(count)]
    drawing['faces'] = [{'id': 0, 'surface': 'plane', 'area': 1, 'confidence': 1, 'normal': [0, 0, 1], 'offset': 0, 'views': [],
                         'loops': [[{'bridge': [corners[k], corners[(k + 1) % count]]} for k in range(count)]],
                         'vertices': corners[:3], 'triangles': [[0, 1, 2]]}]


ON_DRAWING = [many_keys, many_keys, only_json, packed_json, many_links, hub, long_link, long_spline, many_dimensions, many_views,
              many_triangles, many_triangles, long_border]


def many_edits(folder, chooser):
    """Very many edits, or much JSON in their place"""
    kind, count = chooser.random(), chooser.choice([1_000, 50_000, 200_000])
    if kind < 0.4:
        text = EDITS_HEAD + ','.join(['{"edit":"remove_dimension","from":[0,0,0],"to":[1,1,1]}'] * count) + ']}'
    elif kind < 0.7:
        drawing = json.loads(pathlib.Path(folder, 'out', 'drawing.json').read_text())
        refs = [{'id': link['id'], 'closed': link['closed'], 'points': [link['points'][0], link['points'][-1]]}
                for link in drawing['links']]
        one = json.dumps({'edit': chooser.choice(['delete', 'restore']), 'links': refs[:chooser.choice([1, 30])]})
        text = EDITS_HEAD + ','.join([one] * (count // 100)) + ']}'
    else:
        text = '{"more":' + json_text(chooser) + ',' + EDITS_HEAD[1:] + ']}'
    pathlib.Path(folder, 'ws', 'edits.json').write_text(text)


def ply(folder, name, header, body=b'', form='binary_little_endian'):
    pathlib.Path(folder, 'ws', name).write_bytes(f'ply\nformat {form} 1.0\n{header}end_header\n'.encode() + body)


def ply_header(folder, chooser):
    """A PLY file with a header of very many or very long lines"""
    count = chooser.choice([1_000, 200_000])
    points = scene.scene_points()
    vertices = f'element vertex {len(points)}\n{XYZ}'
    header = chooser.choice([
        ''.join(f'element e{k} 0\nproperty float x\n' for k in range(count)) + vertices,
        vertices + ''.join(f'property uchar p{k}\n' for k in range(count)), 'comment x\n' * (10 * count) + vertices,
        'comment ' + 'x' * (100 * count) + '\n' + vertices, f'element {"x" * count} 5\nproperty float x\n' + vertices,
        'element x 9223372036854775807\n' + vertices, vertices + f'element f {2**62}\nproperty list uint float x\n',
        'element vertex 1\nproperty list uint float x\nproperty float y\nproperty float z\n', 'obj_info\n' * count])
    ply(folder, 'fused.ply', header, b''.join(struct.pack('<3f', *point) for point in points))
    pathlib.Path(folder, 'ws', 'fused.ply.vis').write_bytes(
        struct.pack('<Q', len(points)) + struct.pack('<4I', 3, 0, 1, 2) * len(points))


def layered_mesh(folder, chooser):
    """A mesh that covers the picture many times over"""
    count = chooser.choice([1_000, 50_000, 300_000])
    size = chooser.choice([1, 10, 1000])
    kind = chooser.choice(['same', 'stack', 'fan', 'thin', 'random'])
    if kind == 'stack':
        vertices = [(size * math.cos(k), size * math.sin(k), 1e-6 * k) for k in range(count)]
    elif kind == 'thin':
        vertices = [(-size if k % 3 == 0 else size, 1e-4 * (k % 1000), 0.3) for k in range(count)]
    else:
        vertices = [[size * chooser.uniform(-1, 1) for _ in range(3)] for _ in range(1000)]
    total = len(vertices)
    faces = {'same': lambda k: (0, 1, 2), 'fan': lambda k: (0, k % (total - 2) + 1, k % (total - 2) + 2)}.get(
        kind, lambda k: (k % (total - 2), k % (total - 2) + 1, k % (total - 2) + 2))
    ply(folder, 'meshed-poisson.ply', f'element vertex {total}\n{XYZ}element face {count}\nproperty list uchar int '
        'vertex_indices\n', b''.join(struct.pack('<3f', *vertex) for vertex in vertices) +
        b''.join(struct.pack('<B3i', 3, *faces(k)) for k in range(count)))


def same_points(folder, chooser):
    """A cloud of very many points in few places"""
    count = chooser.choice([10_000, 300_000])
    places = [scene.scene_points()[0]] if chooser.random() < 0.5 else scene.scene_points()[:5]
    ply(folder, 'fused.ply', f'element vertex {count}\n{XYZ}',
        b''.join(struct.pack('<3f', *places[k % len(places)]) for k in range(count)))
    pathlib.Path(folder, 'ws', 'fused.ply.vis').write_bytes(
        struct.pack('<Q', count) + struct.pack('<4I', 3, 0, 1, 2) * count)


# (maker, commands, names)
ON_FILES = [
    (many_edits, [EDIT], ['edits.json']),
    (ply_header, [FUSE + ['--dense_type', 'fused'], on_project('drawing_viewer', '--overwrite', '1', '--cloud', 'dense'),
                  export('svg', '--view', 'top', '--dense_path', '{dir}/ws/fused.ply')], ['fused.ply']),
    (layered_mesh, [FUSE + ['--dense_type', 'mesh'], export('svg', '--view', 'top', '--dense_path', '{dir}/ws/meshed-poisson.ply'),
                    ['truth_extractor', '--workspace_path', '{dir}/ws', '--mesh_path', '{dir}/ws/meshed-poisson.ply',
                     '--output_path', '{dir}/out/truth.ply', '--num_threads', '2']], ['meshed-poisson.ply', 'triangles', 'mesh', 'truth', 'curves']),
    (same_points, [FUSE + ['--dense_type', 'fused'], export('svg', '--view', 'top', '--dense_path', '{dir}/ws/fused.ply')],
     ['fused.ply', 'points'])]


def cases(seed, count):
    for index in range(count):
        chooser = hostile.chooser_of('work_bombs', seed, -index - 1)
        if chooser.random() < 0.6:
            maker = chooser.choice(ON_DRAWING)
            extension = chooser.choice(FORMATS)
            view = ['--view', chooser.choice(['top', 'front', 'axonometric'])] if extension == 'svg' else []
            command = export(extension, *view) if chooser.random() < 0.75 else on_project(
                'drawing_viewer', '--overwrite', '1')
            names = ['drawing.json', 'triangles', 'drawing']
        else:
            maker, commands, names = chooser.choice(ON_FILES)
            command = chooser.choice(commands)
        yield hostile.Case(f'{maker.__doc__.splitlines()[0].rstrip(".")}: {command[0]}', maker, [command], names=names, drawn=True,
                           seconds=20, max_mb=1500)


def check(case, outcome):
    return hostile.check(case, outcome)
