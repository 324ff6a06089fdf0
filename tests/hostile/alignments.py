# SPDX-License-Identifier: BSD-3-Clause
"""What aligns a drawing, consistent and contradicting: positions of cameras in a database, and known lengths.

Consistent input gives the scale that it was made with, to within what the run says; contradicting input is an error that
names both sides, and never a small standard error."""

import json
import math
import os
import re
import sqlite3
import struct

import hostile
import scene

NUM_VIEWS = scene.NUM_VIEWS
METERS_PER_DEGREE = 111_200.0


def centers():
    """Of the cameras, in the model."""
    found = []
    for view in range(NUM_VIEWS):
        rotation, translation = scene.cam_from_world(view)
        found.append([-sum(rotation[row][axis] * translation[row] for row in range(3)) for axis in range(3)])
    return found


def in_world(points, scale, heading, shift, noise, chooser):
    """Turned around z, scaled, moved, and off by the noise."""
    cos, sin = math.cos(heading), math.sin(heading)
    turned = [[cos * x - sin * y, sin * x + cos * y, z] for x, y, z in points]
    return [[scale * point[axis] + shift[axis] + chooser.gauss(0, noise) for axis in range(3)] for point in turned]


def geographic(points, latitude, longitude):
    """Latitude, longitude and altitude of points in meters around a place, on a sphere: off by a percent at most."""
    east = METERS_PER_DEGREE * math.cos(math.radians(latitude))
    return [[latitude + y / METERS_PER_DEGREE, longitude + x / east, 400 + z] for x, y, z in points]


def write_priors(path, positions, system=1, sigma=None, gravity=None):
    database = sqlite3.connect(path)
    database.execute('CREATE TABLE images(image_id INTEGER PRIMARY KEY, name TEXT, camera_id INTEGER)')
    database.execute('CREATE TABLE pose_priors(image_id INTEGER PRIMARY KEY, position BLOB, coordinate_system INTEGER, '
                     'position_covariance BLOB, gravity BLOB)')
    pack = lambda numbers: struct.pack(f'<{len(numbers)}d', *numbers)
    covariance = None if sigma is None else pack([sigma * sigma * (k % 4 == 0) for k in range(9)])
    for view, position in enumerate(positions):
        database.execute('INSERT INTO images VALUES(?, ?, 1)', (view + 1, scene.image_name(view)))
        database.execute('INSERT INTO pose_priors VALUES(?, ?, ?, ?, ?)',
                         (view + 1, None if position is None else pack(position), system, covariance,
                          None if gravity is None else pack(gravity[view])))
    database.commit()
    database.close()


def gravity_of(down):
    """Of each camera, of this direction in the world."""
    return [[sum(row[axis] * down[axis] for axis in range(3)) for row in scene.cam_from_world(view)[0]]
            for view in range(NUM_VIEWS)]


def reversed_axis(points, axis):
    return [[-value if k == axis else value for k, value in enumerate(point)] for point in points]


def stretched(points, axis, factor):
    return [[factor * value if k == axis else value for k, value in enumerate(point)] for point in points]


def in_another_order(points, chooser):
    """In which most change their place."""
    while True:
        order = chooser.sample(range(len(points)), len(points))
        if sum(order[i] == i for i in range(len(points))) <= 1:
            return [points[i] for i in order]


def some_wrong(points, count, distance, chooser):
    points = [list(point) for point in points]
    wrong = sorted(chooser.sample(range(len(points)), count))
    for i in wrong:
        direction = [chooser.gauss(0, 1) for _ in range(3)]
        length = math.sqrt(sum(value * value for value in direction))
        points[i] = [value + distance * step / length for value, step in zip(points[i], direction)]
    return points, wrong


class World:
    """The world of a case, in which the drawing is aligned."""

    def __init__(self, chooser):
        self.scale = math.exp(chooser.uniform(-1, 3))
        self.noise = self.scale * chooser.choice([0, 0.002, 0.02, 0.1])
        self.heading = chooser.uniform(0, 2 * math.pi)
        self.shift = [chooser.choice([0, 10, 1e5]) * chooser.uniform(-1, 1) for _ in range(3)]
        self.points = in_world(centers(), self.scale, self.heading, self.shift, self.noise, chooser)
        self.local = in_world(centers(), self.scale, self.heading, [0, 0, 0], self.noise, chooser)
        self.latitude, self.longitude = chooser.uniform(-65, 65), chooser.uniform(-85, 85)


def consistent(world, chooser):
    """(name, arguments of write_priors, images that are told to be far)"""
    subset = set(chooser.sample(range(NUM_VIEWS), chooser.randint(4, NUM_VIEWS)))
    far, wrong = some_wrong(world.points, 1, 60 * world.scale, chooser)
    few = [point if view in subset else None for view, point in enumerate(world.points)]
    return chooser.choice([
        ('right positions', {'positions': world.points}, []),
        (f'{len(subset)} right positions', {'positions': few}, []),
        ('right positions with gravity', {'positions': world.points, 'gravity': gravity_of([0, 0, -9.81])}, []),
        ('right positions with their accuracy',
         {'positions': world.points, 'sigma': max(world.noise, 1e-3 * world.scale)}, []),
        ('right geographic positions',
         {'positions': geographic(world.local, world.latitude, world.longitude), 'system': 0}, []),
        ('one wrong position', {'positions': far}, wrong)])


def contradicting(world, chooser):
    """(name, arguments of write_priors). Noise is small beside the contradiction."""
    points = in_world(centers(), world.scale, world.heading, world.shift, 0.01 * world.scale, chooser)
    factor = chooser.choice([0.3, 0.5, 2, 3.28, 100])
    many, wrong = some_wrong(points, chooser.randint(3, 6), 60 * world.scale, chooser)
    place = geographic(in_world(centers(), 30, world.heading, [0, 0, 0], 0.1, chooser), world.latitude, world.longitude)
    tilt = chooser.uniform(0.8, 2.2)
    tilted = [[x, math.cos(tilt) * y - math.sin(tilt) * z, math.sin(tilt) * y + math.cos(tilt) * z] for x, y, z in points]
    return chooser.choice([
        ('mirrored', {'positions': reversed_axis(points, chooser.randrange(3))}),
        ('east and north exchanged', {'positions': [[y, x, z] for x, y, z in points]}),
        ('down is up', {'positions': [[y, x, -z] for x, y, z in points]}),
        ('latitude and longitude exchanged', {'positions': [[y, x, z] for x, y, z in place], 'system': 0}),
        ('degrees for meters', {'positions': place, 'system': 1}),
        (f'an axis times {factor}', {'positions': stretched(points, chooser.randrange(3), factor)}),
        ('another order', {'positions': in_another_order(points, chooser)}),
        ('any positions', {'positions': [[chooser.gauss(0, 50) for _ in range(3)] for _ in points]}),
        (f'{len(wrong)} of {NUM_VIEWS} wrong', {'positions': many}),
        ('gravity along another axis', {'positions': tilted, 'gravity': gravity_of([0, 0, -9.81])})])


def leave_journal(path, world, chooser):
    """A change that was not finished, or that is not in the file yet, as of a program that was killed."""
    write_priors(path, world.points)
    use_log = chooser.random() < 0.5
    pid = os.fork()
    if pid == 0:
        database = sqlite3.connect(path, isolation_level=None)
        database.execute('PRAGMA journal_mode=WAL' if use_log else 'PRAGMA cache_size=1')
        database.execute('BEGIN EXCLUSIVE')
        wrong = [100 * value for point in world.points for value in point]
        for view in range(NUM_VIEWS):
            database.execute('UPDATE pose_priors SET position = ? WHERE image_id = ?',
                             (struct.pack('<3d', *wrong[3 * view:3 * view + 3]), view + 1))
        database.execute('CREATE TABLE more(x)')
        for _ in range(300):
            database.execute('INSERT INTO more VALUES(zeroblob(4000))')
        if use_log:
            database.execute('COMMIT')
        os._exit(0)
    os.waitpid(pid, 0)


def known_lengths(folder, count, scale, chooser):
    """Texts for long straight links of the drawing, and their lengths in the unit."""
    links = json.loads((folder / 'out' / 'drawing.json').read_text())['links']
    lines = [link for link in links if link.get('primitive', {}).get('type') == 'line' and not link.get('tentative')]
    lines = sorted(lines, key=lambda link: -math.dist(link['primitive']['start'], link['primitive']['end']))[:12]
    chosen = chooser.sample(lines, min(count, len(lines)))
    return [(f'link {link["id"]}', scale * math.dist(link['primitive']['start'], link['primitive']['end']))
            for link in chosen]


def run_with(options_of):
    """The drawing, which known lengths name, is there only when the case is run."""
    def run(program, folder):
        options = options_of(folder, hostile.chooser_of('alignments', folder.name, 0))
        database = folder / 'ws' / 'database.db'
        if database.exists():
            options = options + ['--database_path', str(database)]
        return program.call(['drawing_aligner', '--workspace_path', f'{folder}/ws', '--output_path', f'{folder}/out',
                             '--num_threads', '2', *options], folder, 20)[:3]
    return run


def lengths_case(world, chooser):
    count, is_wrong = chooser.randint(2, 4), chooser.random() < 0.6
    factor = chooser.choice([0.1, 0.6, 1.6, 2, 25.4]) if is_wrong else 1
    unit, meters = chooser.choice([('mm', 0.001), ('cm', 0.01), ('m', 1), ('in', 0.0254), ('ft', 0.3048)])

    def options(folder, of_case):
        lengths = known_lengths(folder, count, world.scale, of_case)
        lengths[0] = (lengths[0][0], lengths[0][1] * factor)
        texts = [f'{name} = {length / meters * of_case.uniform(0.995, 1.005):.6g} {unit}' for name, length in lengths]
        return [part for text in texts for part in ('--known_length', text)]
    name = f'{count} known lengths' + (f', one times {factor}' if is_wrong else '')
    return name, options, is_wrong


def units_case(world, chooser):
    factor = chooser.choice([0.3048, 0.01, 1000, 3])
    points = in_world(centers(), world.scale / factor, world.heading, [0, 0, 0], 0.002 * world.scale / factor, chooser)

    def options(folder, of_case):
        (text, length), = known_lengths(folder, 1, world.scale, of_case)
        return ['--known_length', f'{text} = {length:.6g} m']
    return f'positions in units of {factor} m, and a known length', {'positions': points}, options


def no_options(folder, chooser):
    return []


def prepare_with(world, priors):
    """Without priors: a database with a journal, or None: none."""
    def prepare(folder, chooser):
        database = folder / 'ws' / 'database.db'
        if priors == 'journal':
            leave_journal(database, world, chooser)
        elif priors:
            write_priors(database, **priors)
    return prepare


def make_case(world, chooser):
    """(name, what `prepare_with` takes, options, images with wrong positions, whether it contradicts itself)"""
    kind = chooser.choice(['consistent'] * 3 + ['contradicting'] * 4 + ['lengths'] * 2 + ['units', 'journal'])
    if kind == 'consistent':
        name, priors, far = consistent(world, chooser)
        return name, priors, no_options, far, False
    if kind == 'contradicting':
        name, priors = contradicting(world, chooser)
        return name, priors, no_options, [], True
    if kind == 'lengths':
        name, options, is_wrong = lengths_case(world, chooser)
        return name, None, options, [], is_wrong
    if kind == 'units':
        name, priors, options = units_case(world, chooser)
        return name, priors, options, [], True
    return 'unfinished changes', 'journal', no_options, [], True


def cases(seed, count):
    for index in range(count):
        chooser = hostile.chooser_of('alignments', seed, -index - 1)
        world = World(chooser)
        name, priors, options, far, contradicts = make_case(world, chooser)
        yield hostile.Case(name, prepare_with(world, priors), [], codes=(0, 1), drawn=True, run=run_with(options),
                           names=['database.db'] if priors else ['known_length = '],
                           data={'world': world.scale, 'far': far, 'contradicts': contradicts,
                                 'may_fit': name == 'another order'})


def told_scale(folder, output):
    """The scale in meters, or nothing, and its standard error as the run tells it."""
    world = json.loads((folder / 'out' / 'drawing.json').read_text()).get('world_from_model', {})
    found = re.search(r'alignment: scale .* standard error ([0-9.e+-]+) %', output)
    is_metric = world.get('scale_from', 'none') != 'none'
    return world.get('scale') if is_metric else None, float(found.group(1)) / 100 if found else 0.0


def check_scale(case, outcome):
    scale, error = told_scale(outcome.folder, outcome.output)
    if scale is None:
        return []
    off = abs(scale / case.data['world'] - 1)
    # A drawing's lines are off by a percent, and the sphere of geographic positions is.
    return [] if off <= 5 * error + 0.02 else [f'the scale is off by {100 * off:.2f} %, told {100 * error:.2f} %']


def check(case, outcome):
    broken = hostile.check(case, outcome)
    if broken:
        return broken
    if case.data['contradicts']:
        if outcome.code == 0:
            # Some orders fit as well: then at least the scale is right.
            broken += check_scale(case, outcome) if case.data['may_fit'] else ['a contradiction passes']
        return broken
    if outcome.code != 0:
        return ['consistent input fails']
    named = [view for view in case.data['far'] if not any(scene.image_name(view) in line for line in outcome.warnings())]
    if named:
        broken.append(f'wrong positions of {named} are not told')
    return broken + check_scale(case, outcome)
