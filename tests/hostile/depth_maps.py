# SPDX-License-Identifier: BSD-3-Clause
"""Depth maps that are those of the scene, more or less, and depth maps that are not: of another scale, of other images,
moved, mirrored, inverted, noise, nothing."""

import array
import functools
import json
import math

import hostile
import scene

WIDTH, HEIGHT = scene.WIDTH, scene.HEIGHT


@functools.lru_cache(maxsize=None)
def exact_map(view):
    """Depths of the scene, row by row, at the corners of the pixels, as COLMAP's maps; 0 = nothing there."""
    wide = WIDTH * scene.SAMPLES
    grays, nearness = [0] * (wide * HEIGHT * scene.SAMPLES), [0.0] * (wide * HEIGHT * scene.SAMPLES)
    for corners, gray in scene.faces():
        scene.draw_face(corners, gray, scene.cam_from_world(view), grays, nearness)
    at_corners = (nearness[scene.SAMPLES * (y * wide + x)] for y in range(HEIGHT) for x in range(WIDTH))
    return [1 / near if near > 0 else 0.0 for near in at_corners]


def each(change):
    """A change of one depth, of all known depths of a map."""
    return lambda view, depths, chooser: [change(depth, chooser) if depth > 0 else depth for depth in depths]


def rows_of(depths):
    return [depths[y * WIDTH:(y + 1) * WIDTH] for y in range(HEIGHT)]


def joined(rows):
    return [depth for row in rows for depth in row]


def moved(depths, dx, dy):
    rows = rows_of(depths)
    rows = rows[-dy % HEIGHT:] + rows[:-dy % HEIGHT]
    return joined(row[-dx % WIDTH:] + row[:-dx % WIDTH] for row in rows)


def with_holes(depths, share, chooser):
    """Without the depths of coherent spots, of this share of the map."""
    holes, depths = set(), list(depths)
    while len(holes) < share * len(depths):
        cx, cy, radius = chooser.randrange(WIDTH), chooser.randrange(HEIGHT), chooser.randint(2, 12)
        for y in range(max(0, cy - radius), min(HEIGHT, cy + radius)):
            holes.update(range(y * WIDTH + max(0, cx - radius), y * WIDTH + min(WIDTH, cx + radius)))
    for hole in holes:
        depths[hole] = 0.0
    return depths


# Each takes a view, its depths and a chooser for this view, and returns depths.
def right_changes(chooser):
    noise, share = chooser.uniform(0.001, 0.006), chooser.uniform(0.1, 0.6)
    strays, scale = chooser.uniform(0.005, 0.05), chooser.uniform(0.997, 1.003)
    return {
        'exact': lambda view, depths, of_view: depths,
        f'noise of {100 * noise:.2f} %': each(lambda depth, of_view: depth * of_view.gauss(1, noise)),
        f'holes of {share:.2f}': lambda view, depths, of_view: with_holes(depths, share, of_view),
        f'unknown: {share:.2f}': each(lambda depth, of_view: 0.0 if of_view.random() < share else depth),
        f'not a number: {share:.2f}': each(lambda depth, of_view: math.nan if of_view.random() < share else depth),
        f'stray: {strays:.3f}': each(
            lambda depth, of_view: depth * of_view.uniform(0.3, 3) if of_view.random() < strays else depth),
        f'scale {scale:.4f}': each(lambda depth, of_view: depth * scale),
    }


def wrong_changes(chooser):
    factor = math.exp(chooser.choice([-1, 1]) * chooser.uniform(0.2, 5))
    more, share = chooser.uniform(0.8, 20), chooser.uniform(0, 0.03)
    low, high = sorted([chooser.uniform(0.1, 3), chooser.uniform(4, 20)])
    dx = chooser.choice([-1, 1]) * chooser.randint(WIDTH // 4, WIDTH // 2)
    dy = chooser.choice([-1, 1]) * chooser.randint(HEIGHT // 5, HEIGHT // 2)
    step = chooser.randint(1, scene.NUM_VIEWS - 1)
    relative = chooser.uniform(0.15, 0.5)
    bad = chooser.choice([0.0, math.nan, math.inf, -math.inf, -4.0, 3e38, 1e-40])
    constant = chooser.choice([1e-3, 1.0, 2.0, 30.0, 1e6])
    return {
        f'scale {factor:.3g}': each(lambda depth, of_view: depth * factor),
        f'{more:.2f} more': each(lambda depth, of_view: depth + more),
        'inverse': each(lambda depth, of_view: 1 / depth),
        f'all {bad}': lambda view, depths, of_view: [bad] * len(depths),
        f'all {constant}': lambda view, depths, of_view: [constant] * len(depths),
        f'known: {share:.3f}': each(lambda depth, of_view: depth if of_view.random() < share else 0.0),
        f'noise from {low:.1f} to {high:.1f}': each(lambda depth, of_view: of_view.uniform(low, high)),
        f'noise of {100 * relative:.0f} %': each(lambda depth, of_view: depth * max(0.01, of_view.gauss(1, relative))),
        'pixels in any order': lambda view, depths, of_view: of_view.sample(depths, len(depths)),
        f'moved by {dx}, {dy}': lambda view, depths, of_view: moved(depths, dx, dy),
        'upside down': lambda view, depths, of_view: joined(rows_of(depths)[::-1]),
        'turned': lambda view, depths, of_view: depths[::-1],
        f'of the image {step} on': lambda view, depths, of_view: exact_map((view + step) % scene.NUM_VIEWS),
    }


# What is no error if it is wrong with some images only: hardly any depths; or is hard to tell in pictures that are so
# small: the map of a neighbor, while no other image has its own.
NOT_SOME = ('all', 'known', 'of the image 1 ', f'of the image {scene.NUM_VIEWS - 1} ')


def prepare_with(change, wrong_views, suffix):
    def prepare(folder, chooser):
        maps = folder / 'ws' / 'stereo' / 'depth_maps'
        maps.mkdir(parents=True)
        for view in range(scene.NUM_VIEWS):
            depths = exact_map(view)
            if view in wrong_views:
                depths = change(view, depths, chooser)
            header = f'{WIDTH}&{HEIGHT}&1&'.encode()
            (maps / f'{scene.image_name(view)}.{suffix}.bin').write_bytes(header + array.array('f', depths).tobytes())
    return prepare


def cases(seed, count):
    for index in range(count):
        chooser = hostile.chooser_of('depth_maps', seed, -index - 1)
        is_right = chooser.random() < 0.35
        name, change = chooser.choice(list((right_changes if is_right else wrong_changes)(chooser).items()))
        views = list(range(scene.NUM_VIEWS))
        only_some = not is_right and not name.startswith(NOT_SOME) and chooser.random() < 0.25
        wrong = chooser.sample(views, chooser.randint(1, 3)) if only_some else views
        expected = 'judged' if is_right else 'partly' if only_some else 'not judged'
        command = ['drawing_fuser', '--workspace_path', '{dir}/ws', '--output_path', '{dir}/out', '--dense_type',
                   'depth_maps', '--num_threads', '2', '--overwrite', '1']
        yield hostile.Case(f'{name}{f" of {sorted(wrong)}" if only_some else ""}: {expected}',
                           prepare_with(change, wrong, chooser.choice(['geometric', 'photometric'])), [command],
                           codes=(0,), drawn=True, data={'expected': expected, 'wrong': sorted(wrong)})


def share_judged(folder):
    """Of the length of the drawing, on a surface or at a boundary; and not judged."""
    links = json.loads((folder / 'out' / 'drawing-fused.json').read_text())['links']
    whole = sum(link['length'] for link in links)
    length_of = lambda *classes: sum(link['length'] for link in links if link['dense']['class'] in classes)
    return length_of('surface', 'boundary') / whole, length_of('unknown') / whole


def check(case, outcome):
    broken = hostile.check(case, outcome)
    if broken:
        return broken
    expected = case.data['expected']
    warnings = [line for line in outcome.warnings() if 'stereo: ' in line]
    near, unknown = share_judged(outcome.folder)
    if expected == 'judged' and (warnings or near < 0.3):
        broken.append(f'{near:.2f} of the drawing on a surface, {len(warnings)} warnings')
    if expected == 'not judged' and (unknown < 1 or not any('no link is judged' in line for line in warnings)):
        broken.append(f'{1 - unknown:.2f} of the drawing is judged, {len(warnings)} warnings')
    if expected == 'partly':
        missing = [view for view in case.data['wrong'] if not any(scene.image_name(view) in line for line in warnings)]
        if missing or near < 0.5:
            broken.append(f'{near:.2f} of the drawing on a surface, images {missing} are not named')
    return broken
