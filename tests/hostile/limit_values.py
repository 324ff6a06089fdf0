# SPDX-License-Identifier: BSD-3-Clause
"""Values at their limits and against their neighbors, by hand: numbers of a drawing.json or an edits.json that are huge,
tiny or of another type, shapes that are not where their links are, points of a model that are no numbers.
"""

import copy
import json
import math
import pathlib
import struct

import hostile

SMALL = [0, -0.0, 1e-15, 1e-300, 5e-324]
LARGE = [1e14, 1e15, -1e15, 1.1e15, 1e16, 1e38, 3.5e38, 1e150, 1e154, 1e200, 1e300, 1.7e308, -1e300]
TYPES = [None, True, False, '', 'x', [], {}, [[]], '1', [1], {'x': 1}, 2**31, 2**53, 2**64, -1, 1.5, 10**30]
COMMANDS = ['drawing_aligner', 'drawing_regularizer', 'drawing_surfacer', 'drawing_refiner', 'drawing_viewer']
FORMATS = ['ply', 'obj', 'json', 'dxf', 'glb', 'svg', 'graphml', 'step']
# Words of numbers that are none, in the texts of exported files.
NO_NUMBERS = ('nan', 'inf')


def command_on_drawing(chooser):
    kind = chooser.random()
    if kind < 0.6:
        extension = chooser.choice(FORMATS)
        return ['drawing_exporter', '--input_path', '{dir}/out/drawing.json', '--output_path', f'{{dir}}/out/x.{extension}',
                '--kinds', 'all', '--tentative', '1']
    if kind < 0.7:
        return ['drawing_evaluator', '--input_path', '{dir}/out/drawing.json', '--truth_path', '{dir}/out/drawing.json',
                '--taus', '0.01,0.1']
    command = chooser.choice(COMMANDS)
    arguments = [command, '--workspace_path', '{dir}/ws', '--output_path', '{dir}/out', '--num_threads', '2']
    return arguments if command == 'drawing_aligner' else arguments + ['--overwrite', '1']


def places_of(value, way=()):
    """The ways to all numbers, texts and lists of a value of JSON."""
    if way:
        yield way
    if isinstance(value, dict):
        for name, item in value.items():
            yield from places_of(item, (*way, name))
    elif isinstance(value, list):
        for number, item in enumerate(value[:40]):
            yield from places_of(item, (*way, number))


def put(drawing, way, value):
    for step in way[:-1]:
        drawing = drawing[step]
    drawing[way[-1]] = value


def at(drawing, way):
    for step in way:
        drawing = drawing[step]
    return drawing


def change_number(drawing, chooser):
    """A number replaced by a huge or tiny one."""
    ways = [way for way in places_of(drawing) if isinstance(at(drawing, way), (int, float)) and way[0] != 'options']
    for _ in range(chooser.choice([1, 1, 1, 5])):
        put(drawing, chooser.choice(ways), chooser.choice(SMALL + LARGE))


def change_type(drawing, chooser):
    """A value replaced by one of another type."""
    ways = list(places_of(drawing))
    # As many of each depth: most values are coordinates.
    depth = chooser.choice(sorted({len(way) for way in ways}))
    put(drawing, chooser.choice([way for way in ways if len(way) == depth]), copy.deepcopy(chooser.choice(TYPES)))


def drop_member(drawing, chooser):
    """A member or an item that is missing."""
    ways = list(places_of(drawing))
    depth = chooser.choice(sorted({len(way) for way in ways}))
    way = chooser.choice([way for way in ways if len(way) == depth])
    holder = at(drawing, way[:-1])
    del holder[way[-1]]


def scale_all(drawing, chooser):
    """The whole drawing, scaled or far away."""
    scale, shift = chooser.choice([(1e12, 0), (1e14, 0), (1e15, 0), (1e38, 0), (1e300, 0), (1e-12, 0), (1e-300, 0), (0, 0),
                                   (1, 5e6), (1, 1e12), (1, 9e14), (1, 1e15), (-1, 0)])

    def moved(point):
        return [scale * x + shift for x in point]
    for node in drawing['nodes']:
        node['position'] = moved(node['position'])
    for link in drawing['links']:
        link['points'] = [moved(point) for point in link['points']]
        shape = link.get('primitive', {})
        for name in ('start', 'end', 'center'):
            if name in shape:
                shape[name] = moved(shape[name])
        if 'radius' in shape:
            shape['radius'] *= abs(scale)
        if 'control_points' in shape:
            shape['control_points'] = [moved(point) for point in shape['control_points']]


def move_shape(drawing, chooser):
    """A primitive that is not where its link is."""
    links = [link for link in drawing['links'] if 'primitive' in link]
    far = chooser.choice([1e3, 1e6, 1e9, 1e14, -1e6])
    for link in links if chooser.random() < 0.3 else [chooser.choice(links)]:
        shape = link['primitive']
        size = max(max(column) - min(column) for column in zip(*link['points']))
        if chooser.random() < 0.5:
            link['primitive'] = shape = arc(link['points'][0], size, chooser)
        if shape['type'] == 'spline':
            number = chooser.randrange(len(shape['control_points']))
            shape['control_points'][number] = [far, far, far]
        elif shape['type'] == 'line':
            shape[chooser.choice(['start', 'end'])] = [far, 0, far]
        else:
            name = chooser.choice(['center', 'radius'])
            shape[name] = [far, 0, 0] if name == 'center' else abs(far)


def arc(point, size, chooser):
    return {'type': 'arc', 'center': [point[0] - size, point[1], point[2]], 'x_axis': [1, 0, 0], 'y_axis': [0, 1, 0],
            'radius': size, 'sweep_rad': chooser.choice([0.3, 3, 2 * math.pi]), 'rms_px': 0.1, 'max_px': 0.3}


def change_shape(drawing, chooser):
    """Knots, axes, sweeps and radii that are none."""
    link = chooser.choice(drawing['links'])
    size = max(max(column) - min(column) for column in zip(*link['points']))
    shape = arc(link['points'][0], size, chooser)
    name, value = chooser.choice([
        ('sweep_rad', 1e9), ('sweep_rad', -1), ('sweep_rad', 0), ('sweep_rad', 1e-300), ('radius', -1), ('radius', 0),
        ('radius', 1e-300), ('x_axis', [0, 0, 0]), ('x_axis', [0, 1, 0]), ('y_axis', [1, 1e-5, 0]), ('x_axis', [1e200, 0, 0])])
    shape[name] = value
    if chooser.random() < 0.3:
        points = [link['points'][k % len(link['points'])] for k in range(chooser.choice([3, 4, 5, 1000]))]
        inner = len(points) - 4
        shape = {'type': 'spline', 'degree': 3, 'control_points': points, 'rms_px': 0, 'max_px': 0,
                 'knots': chooser.choice([[0.] * 4 + [k + 1. for k in range(inner)] + [inner + 1.] * 4, [0.] * (inner + 8),
                                          [1.] * 4 + [0.] * 4, [0, 0, 0, 0, 1e15, 1e15, 1e15, 1e15], [0.] * 4 + [5e-324] * 4,
                                          [-1e15] * 4 + [1e15] * 4, []])}
    link['primitive'] = shape


def add_dimensions(drawing, chooser):
    """Dimensions far away, without length, or many."""
    def place():
        return [chooser.choice(SMALL + LARGE[:4] + [1.0] * 4) for _ in range(3)]
    count = chooser.choice([1, 1, 10, 3000])
    drawing['dimensions'] = [{'from': place(), 'to': place(), 'shift': place()} for _ in range(count)]
    if chooser.random() < 0.4:
        drawing['dimensions'][0]['from'] = [chooser.choice(LARGE), 0, 0]


def align(drawing, chooser):
    """An alignment that mirrors, shears or is out of range."""
    rotation = chooser.choice([[[1, 0, 0], [0, 1, 0], [0, 0, 1]], [[1, 0, 0], [0, 1, 0], [0, 0, -1]], [[0] * 3] * 3,
                               [[1, 1e-3, 0], [0, 1, 0], [0, 0, 1]], [[1e15, 0, 0], [0, 1, 0], [0, 0, 1]]])
    scale_from = chooser.choice(['none', 'lengths', 'positions', 'x'])
    drawing['world_from_model'] = {
        'scale': chooser.choice([1.0] * 5 + SMALL + LARGE), 'rotation': rotation,
        'translation': [chooser.choice([0, 0, *LARGE]) for _ in range(3)], 'unit': chooser.choice(['m', 'none']),
        'up_from': 'gravity', 'axes_from': 'lines', 'scale_from': scale_from}


def add_faces(drawing, chooser):
    """Faces that are huge, flat, or of other links than there are."""
    def number():
        return chooser.choice([0, 1, 1, 0.5, *SMALL, *LARGE[:4]])
    vertices = [[number() for _ in range(3)] for _ in range(chooser.choice([3, 4, 50]))]
    count = len(drawing['links'])
    edge = chooser.choice([{'bridge': vertices[:2]}, {'bridge': []}, {'link': 0, 'from': 0, 'to': 1},
                           {'link': count, 'from': 0, 'to': 1}, {'link': -2, 'from': 0, 'to': 1},
                           {'link': 0, 'from': 1e9, 'to': 0}, {'link': 0, 'from': -5, 'to': 5}])
    drawing['faces'] = [{
        'id': 0, 'surface': chooser.choice(['plane', 'plane', 'ruled', 'patch']), 'area': 1, 'confidence': chooser.choice(
            [1, 1, 2, -1]), 'normal': chooser.choice([[0, 0, 1], [0, 0, 0], [0, 0, 1e15]]), 'offset': number(), 'views': [],
        'loops': chooser.choice([[[edge] * 3], [[edge]], [[]], []]), 'vertices': vertices, 'triangles': [
            [chooser.choice([0, 1, 2, 2, len(vertices) - 1, len(vertices), -1, 2**31 - 1]) if chooser.random() < 0.1 else k % 3
             for k in range(3)] for _ in range(chooser.choice([1, 5, 1000]))]}] * chooser.choice([1, 1, 100])


DRAWING_CHANGES = [change_number, change_number, change_type, change_type, drop_member, scale_all, move_shape, move_shape,
                   change_shape, add_dimensions, align, add_faces]


def edit_drawing(change):
    def prepare(folder, chooser):
        path = pathlib.Path(folder, 'out', 'drawing.json')
        drawing = json.loads(path.read_text())
        change(drawing, chooser)
        path.write_text(json.dumps(drawing))
    return prepare


def change_edits(folder, chooser):
    """Edits by hand with values of other types or out of range."""
    drawing = json.loads(pathlib.Path(folder, 'out', 'drawing.json').read_text())

    def ref():
        link = chooser.choice(drawing['links'])
        return {'id': link['id'], 'closed': link['closed'], 'points': [link['points'][0], link['points'][-1]]}

    def end():
        return {'link': ref(), 'end': chooser.randint(0, 1)}

    def place():
        one = ref()
        return {'link': one, 'at': one['points'][0]}
    edits = {'format': 'limn_edits', 'format_version': 1, 'edits': [
        {'edit': 'delete', 'links': [ref()]}, {'edit': 'set_kind', 'links': [ref()], 'kind': 'paint'},
        {'edit': 'split', **place()}, {'edit': 'join', 'ends': [end(), end()]}, {'edit': 'merge', 'links': [ref(), ref()]},
        {'edit': 'dimension', 'from': place(), 'to': place(), 'shift': [0, 0, 1]},
        {'edit': 'remove_dimension', 'from': [0, 0, 0], 'to': [1, 1, 1]}]}
    chooser.choice([change_number, change_type, drop_member])(edits, chooser)
    pathlib.Path(folder, 'ws', 'edits.json').write_text(json.dumps(edits))


def change_points(folder, chooser):
    """Points of a model that are no numbers, or far away."""
    path = pathlib.Path(folder, 'ws', 'sparse', 'points3D.bin')
    data = bytearray(path.read_bytes())
    share = chooser.choice([0.01, 0.3, 1])
    values = chooser.choice([[math.nan], [math.inf, -math.inf], [1e300, -1e300], [1e38], [0.0], [math.nan, 1e300, 0.0, 1e15]])
    begin = 8
    for _ in range(struct.unpack_from('<Q', data)[0]):
        if chooser.random() < share:
            for k in range(3):
                if chooser.random() < 0.5 or k == 0:
                    struct.pack_into('<d', data, begin + 8 + 8 * k, chooser.choice(values))
        begin += 51 + 8 * struct.unpack_from('<Q', data, begin + 43)[0]
    path.write_bytes(data)


EDIT = ['drawing_editor', '--workspace_path', '{dir}/ws', '--output_path', '{dir}/out', '--num_threads', '2', '--overwrite',
        '1', '--edits', '{dir}/ws/edits.json']


def cases(seed, count):
    for index in range(count):
        chooser = hostile.chooser_of('limit_values', seed, -index - 1)
        kind = chooser.random()
        if kind < 0.8:
            change = chooser.choice(DRAWING_CHANGES)
            command = command_on_drawing(chooser)
            yield hostile.Case(f'{change.__doc__.split(".")[0]}: {command[0]}', edit_drawing(change), [command], drawn=True,
                               names=['drawing.json', 'drawing', 'curves'], data={'export': command[0] == 'drawing_exporter'})
        elif kind < 0.92:
            yield hostile.Case(change_edits.__doc__.split('.')[0], change_edits, [EDIT], names=['edits.json'], drawn=True)
        else:
            yield hostile.Case(change_points.__doc__.split('.')[0], change_points, [hostile.drawer('--page', '0')],
                               names=['points', 'sparse', 'images', 'view_'])


def odd_words(path):
    """Numbers that are none, in a text file."""
    if path.suffix in ('.glb', '.ply'):
        return []
    words = path.read_text(errors='replace').lower().replace('"', ' ').replace(',', ' ').replace('(', ' ').split()
    return sorted({word for word in words if word.lstrip('-+').removesuffix('.0').removesuffix('.') in NO_NUMBERS})


def check(case, outcome):
    broken = hostile.check(case, outcome)
    if case.data.get('export') and outcome.code == 0:
        for path in outcome.folder.glob('out/x.*'):
            broken += [f'{path.name} has {word}' for word in odd_words(path)]
    return broken
