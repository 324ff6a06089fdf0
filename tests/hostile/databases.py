# SPDX-License-Identifier: BSD-3-Clause
"""Databases of strangers (database.db) for drawing_aligner: schemas that are programs, values of any type and size, files
that are damaged or that another program is writing.
"""

import math
import os
import pathlib
import sqlite3
import struct

import hostile
import scene

ALIGN = ['drawing_aligner', '--workspace_path', '{dir}/ws', '--output_path', '{dir}/out', '--num_threads', '2',
         '--database_path', '{dir}/ws/database.db']
COLUMNS = ['position', 'coordinate_system', 'position_covariance', 'gravity']
# What never ends, takes gigabytes or reaches outside, as a query of one row and one value, with "{i}" for an image.
PROGRAMS = [
    'WITH RECURSIVE r(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM r) SELECT max(i) FROM r',
    'WITH RECURSIVE r(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM r) SELECT count(*) FROM r, r AS s',
    'SELECT zeroblob({bytes})', 'SELECT hex(randomblob({bytes}))', "SELECT printf('%.*c', {bytes}, 'x')",
    "SELECT replace(hex(zeroblob({bytes})), '0', 'yy')", "SELECT load_extension('/nowhere/x.so')",
    "SELECT readfile('/etc/passwd')", 'SELECT count(*) FROM images a, images b, images c, images d, images e, images f, '
    'images g, images h, images i, images j, images k, images l, images m', 'SELECT position FROM pose_priors',
    "SELECT group_concat(hex(zeroblob(100000))) FROM images a, images b, images c", 'SELECT NULL', 'SELECT abs(-9223372036854775808)']
# The same as an expression, for computed columns.
EXPRESSIONS = ['zeroblob({bytes})', 'hex(zeroblob({bytes}))', "printf('%.*c', {bytes}, 'x')", 'randomblob({bytes})',
               "instr(hex(zeroblob({bytes})), hex(zeroblob(400000)) || 'x')", "hex(zeroblob({bytes})) LIKE '%%%1%2%3%4'",
               'NULL', 'x\'00\'', 'image_id || image_id']
SYSTEMS = [0, 1, -1, 2, 99, 2**31, 2**62, -2**63, 1e300, 'WGS84', None, b'\0']


def center(view):
    rotation, translation = scene.cam_from_world(view)
    return [-sum(rotation[k][i] * translation[k] for k in range(3)) for i in range(3)]


def numbers(values):
    return struct.pack(f'<{len(values)}d', *values)


def odd_number(chooser):
    return chooser.choice([0.0, 1e300, -1e300, 1e-310, 1e15, 1e16, math.nan, math.inf, -math.inf, 90.0, 91.0, 180.0, 361.0,
                           2.0**53, chooser.gauss(0, 1) * 10.0**chooser.randint(-30, 30)])


def odd_value(chooser, count):
    """In place of a matrix of `count` numbers."""
    return chooser.choice([
        lambda: numbers([odd_number(chooser) for _ in range(count)]), lambda: numbers([odd_number(chooser)] * count),
        lambda: None, lambda: b'', lambda: b'\xff' * chooser.choice([1, 7, 8 * count - 1, 8 * count + 1, 4096]),
        lambda: b'\xff' * 8 * count, lambda: 'x' * 8 * count, lambda: 'ä日' * 5, lambda: chooser.randint(-2**63, 2**63 - 1),
        lambda: odd_number(chooser), lambda: bytes(chooser.choice([10**6, 2 * 10**6, 3 * 10**7]))])()


def images_table(database, name='images', extra=''):
    database.execute(f'CREATE TABLE {name} (image_id INTEGER PRIMARY KEY, name TEXT, camera_id INTEGER{extra})')
    for view in range(scene.NUM_VIEWS):
        database.execute(f'INSERT INTO {name} (image_id, name, camera_id) VALUES (?, ?, 1)',
                         (view + 1, scene.image_name(view)))


def priors_table(database, name='pose_priors', extra=''):
    database.execute(f'CREATE TABLE {name} (image_id INTEGER PRIMARY KEY, position BLOB, coordinate_system INTEGER, '
                     f'position_covariance BLOB, gravity BLOB{extra})')
    for view in range(scene.NUM_VIEWS):
        position = [2 * x + shift for x, shift in zip(center(view), (1e6, 2e6, 0))]
        database.execute(f'INSERT INTO {name} (image_id, position, coordinate_system) VALUES (?, ?, 1)',
                         (view + 1, numbers(position)))


def program_of(chooser, programs):
    return chooser.choice(programs).replace('{bytes}', str(chooser.choice([100, 10**6, 4 * 10**8, 900_000_000])))


def write_view(database, chooser):
    """A view in place of a table."""
    target = chooser.choice(['pose_priors', 'pose_priors', 'images'])
    images_table(database, 'images' if target == 'pose_priors' else 'kept')
    priors_table(database, 'pose_priors' if target == 'images' else 'kept')
    columns = ['image_id', *COLUMNS] if target == 'pose_priors' else ['image_id', 'name', 'camera_id']
    hostile_one = chooser.choice(columns)
    values = [f'({program_of(chooser, PROGRAMS)}) AS {column}' if column == hostile_one else column for column in columns]
    temporary = chooser.choice(['', 'WHERE image_id < 5', 'ORDER BY random()', 'LIMIT 1'])
    database.execute(f'CREATE VIEW {target} AS SELECT {", ".join(values)} FROM kept {temporary}')


def write_endless_view(database, chooser):
    """A view of endless many rows."""
    images_table(database)
    column = chooser.choice(COLUMNS)
    values = ', '.join('i AS image_id' if name == 'image_id' else
                       (program_of(chooser, EXPRESSIONS).replace('image_id', 'i') if name == column else 'NULL') + f' AS {name}'
                       for name in ['image_id', *COLUMNS])
    database.execute(f'CREATE VIEW pose_priors AS WITH RECURSIVE r(i) AS (SELECT {chooser.choice([1, 10**9])} UNION ALL '
                     f'SELECT i + 1 FROM r) SELECT {values} FROM r')


def write_computed_column(database, chooser):
    """A computed column in place of a stored one."""
    column = chooser.choice(COLUMNS + ['name'])
    table = 'images' if column == 'name' else 'pose_priors'
    images_table(database, 'kept' if column == 'name' else 'images')
    priors_table(database, 'pose_priors' if column == 'name' else 'kept')
    names = ['name', 'camera_id'] if column == 'name' else COLUMNS
    columns = ', '.join(f'{name} AS (NULL)' if name == column else name for name in names)
    database.execute(f'CREATE TABLE {table} (image_id INTEGER PRIMARY KEY, {columns})')
    stored = ', '.join(name for name in ['image_id', *names] if name != column)
    database.execute(f'INSERT INTO {table} ({stored}) SELECT {stored} FROM kept')
    # Rows are computed when they are put in, too: by the expression of then.
    database.execute('PRAGMA writable_schema = 1')
    database.execute("UPDATE sqlite_master SET sql = replace(sql, 'AS (NULL)', ?) WHERE name = ?",
                     (f'AS ({program_of(chooser, EXPRESSIONS)})', table))


def write_triggers(database, chooser):
    """Triggers, indices of expressions and checks, none of which reading needs."""
    images_table(database)
    priors_table(database)
    for number in range(chooser.choice([1, 5, 2000])):
        database.execute(f'CREATE TRIGGER t{number} AFTER {chooser.choice(["INSERT", "DELETE", "UPDATE"])} ON '
                         f"{chooser.choice(['images', 'pose_priors'])} BEGIN SELECT load_extension('/nowhere/{number}.so'); END")
    database.execute('CREATE INDEX i ON images (length(name) * 2, name DESC)')


def write_virtual_table(database, chooser):
    """A virtual table in place of a table."""
    images_table(database)
    kind = chooser.choice(['fts4(image_id, position, coordinate_system)', 'fts5(image_id, position, coordinate_system)',
                           'rtree(image_id, position, coordinate_system)', 'dbstat'])
    try:
        database.execute(f'CREATE VIRTUAL TABLE pose_priors USING {kind}')
    except sqlite3.OperationalError:  # a module that this Python has not
        database.execute('CREATE VIRTUAL TABLE pose_priors USING fts4(image_id, position, coordinate_system)')


def forge(database, chooser):
    """Another program under the name of a table."""
    images_table(database)
    priors_table(database)
    database.execute('PRAGMA writable_schema = 1')
    column = chooser.choice(['position', 'gravity'])
    sql = chooser.choice([
        f'CREATE VIEW pose_priors AS SELECT 1 AS image_id, ({program_of(chooser, PROGRAMS)}) AS {column}, 1 AS coordinate_system',
        f'CREATE TABLE pose_priors (image_id INTEGER PRIMARY KEY, {column} AS ({program_of(chooser, EXPRESSIONS)}), '
        'coordinate_system)', 'CREATE VIRTUAL TABLE pose_priors USING fts4(position)', 'DROP TABLE images', 'x' * 2000000,
        'CREATE TABLE pose_priors (' + ', '.join(f'c{k}' for k in range(chooser.choice([100, 1999, 30000]))) + ')', None, ''])
    database.execute("UPDATE sqlite_master SET sql = ? WHERE name = 'pose_priors'", (sql,))
    if chooser.random() < 0.5:
        database.execute("UPDATE sqlite_master SET rootpage = ? WHERE name = 'pose_priors'",
                         (chooser.choice([0, 1, 2, 3, 99999, -5]),))


def write_many_rows(database, chooser):
    """Many rows for few images, and tables without keys."""
    unique = chooser.random() < 0.5
    key = ' PRIMARY KEY' if unique else ''
    count = chooser.choice([20_000, 100_000])
    database.execute(f'CREATE TABLE images (image_id INTEGER{key}, name TEXT)')
    database.execute(f'CREATE TABLE pose_priors (image_id INTEGER{key}, position BLOB, coordinate_system INTEGER)')
    same = chooser.random() < 0.5 and not unique
    database.executemany('INSERT INTO images VALUES (?, ?)',
                         ((1 if same else k, scene.image_name(k % scene.NUM_VIEWS)) for k in range(count)))
    database.executemany('INSERT INTO pose_priors VALUES (?, ?, 1)',
                         ((1 if same else k, numbers(center(k % scene.NUM_VIEWS))) for k in range(count)))


def write_values(database, chooser):
    """Values of any type and size."""
    images_table(database)
    priors_table(database)
    column = chooser.choice(COLUMNS)
    whole = chooser.random() < 0.3
    for view in range(scene.NUM_VIEWS):
        if not whole and chooser.random() < 0.7:
            continue
        value = chooser.choice(SYSTEMS) if column == 'coordinate_system' else odd_value(
            chooser, 9 if column == 'position_covariance' else 3)
        database.execute(f'UPDATE pose_priors SET {column} = ? WHERE image_id = ?', (value, view + 1))


def write_names(database, chooser):
    """Names of images that lead a terminal or a path astray."""
    images_table(database)
    priors_table(database)
    for view in range(0, scene.NUM_VIEWS, 3):
        name = chooser.choice(hostile_names() + ['\x1b[31mX\nERROR: forged', b'\xff\xfe', 'x' * 2000000, None, 5, 1.5, '\0a'])
        database.execute('UPDATE images SET name = ? WHERE image_id = ?', (name, view + 1))
    if chooser.random() < 0.5:
        database.execute("UPDATE pose_priors SET position = x'00'")


def hostile_names():
    from hostile_model import NAMES
    return NAMES


def write_schema(database, chooser):
    """Tables or columns that are missing, or of another name or case."""
    lost = chooser.choice(['image_id', *COLUMNS, 'name'])
    if lost == 'name':
        database.execute('CREATE TABLE images (image_id INTEGER PRIMARY KEY)')
        priors_table(database)
        return
    if chooser.random() < 0.7:
        images_table(database, chooser.choice(['images', 'IMAGES', 'picture']))
    columns = [name for name in ['image_id', *COLUMNS] if name != lost]
    database.execute(f'CREATE TABLE {chooser.choice(["pose_priors", "Pose_Priors", "priors"])} ({", ".join(columns)})')


# Each says what it does in its first sentence, and fails in another way each time.
WRITERS = [write_view, write_view, write_endless_view, write_computed_column, write_triggers, write_virtual_table, forge,
           write_many_rows, write_values, write_values, write_values, write_names, write_schema]


def damage(path, chooser):
    """Bytes replaced or cut off."""
    data = bytearray(path.read_bytes())
    how = chooser.choice(['bytes', 'bytes', 'cut', 'header', 'grown'])
    if how == 'bytes':
        for _ in range(chooser.choice([1, 10, 200])):
            data[chooser.randrange(len(data))] = chooser.randrange(256)
    elif how == 'cut':
        del data[chooser.randrange(len(data)):]
    elif how == 'header':
        data[chooser.randrange(16, 100)] = chooser.randrange(256)
    else:
        data += bytes(chooser.choice([1, 4096, 10**7]))
    path.write_bytes(data)


def no_database(path, chooser):
    """Something else of the name."""
    chooser.choice([lambda: path.mkdir(), lambda: os.mkfifo(path), lambda: path.symlink_to('/dev/zero'),
                    lambda: path.write_bytes(b''), lambda: path.write_bytes(b'SQLite format 3\0' + chooser.randbytes(9000)),
                    lambda: path.symlink_to(path.name)])()


def prepare_with(writer, damaged):
    def prepare(folder, chooser):
        path = pathlib.Path(folder, 'ws', 'database.db')
        if writer is no_database:
            no_database(path, chooser)
            return
        database = sqlite3.connect(path)
        if chooser.random() < 0.2:
            database.execute('PRAGMA page_size = 512')
        writer(database, chooser)
        database.commit()
        database.close()
        if damaged:
            damage(path, chooser)
    return prepare


def cases(seed, count):
    for index in range(count):
        chooser = hostile.chooser_of('databases', seed, -index - 1)
        writer = chooser.choice(WRITERS + [no_database])
        damaged = writer is not no_database and chooser.random() < 0.15
        yield hostile.Case(writer.__doc__.split('.')[0].split('\n')[0] + (', damaged' if damaged else ''),
                           prepare_with(writer, damaged), [ALIGN], names=['database.db'], drawn=True, max_mb=500)


def check(case, outcome):
    return hostile.check(case, outcome)
