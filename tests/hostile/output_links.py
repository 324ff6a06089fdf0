"""Links at every depth of the output tree, in the place of folders and of files."""

import os
import shutil

import hostile

FOLDERS = ['curves', 'curves/cache', 'curves/cache/fragments', 'curves/cache/sketch', 'curves/cache/scene',
           'curves/cache/edges', 'curves/overlays', 'curves/edges', 'refined']
FILES = ['drawing.json', 'drawing.ply', 'drawing.obj', 'drawing.html', 'curves/tracks.txt', 'curves/project.ini',
         'curves/swept-sketch.bin', 'curves/swept-sketch.ply', 'curves/cameras.csv', 'curves/account.csv', 'curves/.lock',
         'curves/overlays/view_3.png.png', 'curves/cache/sketch/view_3.png.bin', 'curves/cache/fragments/view_3.png.bin',
         'refined/cameras.bin', 'refined/images.txt', 'refined/limn.txt', 'drawing.json.limn-tmp',
         'curves/overlays/0123.limn-tmp']
TARGETS = ['full folder', 'empty folder', 'file', 'dangling', 'loop', 'relative', 'chain', 'hard link']


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


def prepare_with(place, target):
    def prepare(folder, _):
        album = folder / 'outside' / 'album'
        (album / 'fragments').mkdir(parents=True)
        (folder / 'outside' / 'empty').mkdir()
        for name in ('view_3.png.png', 'view_3.png.bin', 'cameras.bin', 'fragments/view_3.png.bin', 'x.limn-tmp'):
            (album / name).write_text('mine\n')
        put_link(folder / 'out' / place, target, folder / 'outside')
    return prepare


def cases(seed, count):
    for index in range(count):
        chooser = hostile.chooser_of('output_links', seed, -index - 1)
        place = chooser.choice(FOLDERS + FILES)
        target = chooser.choice([kind for kind in TARGETS if place in FILES or kind != 'hard link'])
        options = chooser.choice([(), (), ('--page', '0'), ('--account', '1'), ('--refine_cameras', '1')])
        overwrite = chooser.random() < 0.6
        # The error names the link, or what is not limn's in the place of a result.
        yield hostile.Case(f'{target} at {place}{", overwrite" if overwrite else ""} {" ".join(options)}',
                           prepare_with(place, target), [hostile.drawer(*options, overwrite=overwrite)],
                           names=[place], drawn=chooser.random() < 0.5)


def check(case, outcome):
    return hostile.check(case, outcome)
