# SPDX-License-Identifier: BSD-3-Clause
"""What all kinds of hostile cases share. A kind is a file here, and has

  def cases(seed, count):        yields `count` cases, which depend on the seed alone
  def check(case, outcome):      returns the rules that the outcome broke; usually [] or more than hostile.check

A case has a folder of its own:

  ws/       a copy of the base project (sparse/, images/), which `prepare` makes hostile
  out/      the output folder; a copy of the drawing of the base project if the case asks for it
  outside/  files that no run may change

and one command of limn, or several, that end with exit code 0 or 1, without a crash, in time, with exactly one line
"ERROR: ..." where it is 1, which names one of the case's `names`, and without half a result; nothing but out/ changes.
"""

import dataclasses
import hashlib
import os
import pathlib
import re
import resource
import shutil
import signal
import stat
import subprocess
import tempfile
import time
import unicodedata
import zlib
from typing import Callable, Optional

import scene

# Words of messages that are not ours.
RAW_WORDS = ['exception', 'std::', 'bad_alloc', 'basic_string', 'vector::', 'terminate', 'Assertion', 'CHECK', 'Eigen',
             'Corrupt JPEG', 'Premature end', 'libpng', 'TIFFRead', 'TIFFFetch', 'TIFFOpen', 'OpenCV(', 'cv::', '.cc:', '.cpp:',
             'json.', 'trust_region', 'Ceres', 'runtime error:', 'Sanitizer']
# Limits of time and memory are so many times wider for a program with sanitizers.
SLOWNESS = 10 if 'LIMN_SANITIZED' in os.environ else 1
# Results that a run may leave behind if it fails: what is kept for the next run.
KEPT = ('curves/cache',)
MAIN_RESULTS = ('drawing.json', 'drawing.ply', 'drawing.obj', 'drawing.html')


@dataclasses.dataclass
class Case:
    """`name` says what is hostile. `prepare(folder, chooser)` makes it so in the case's folder, with a random.Random of
    its own. `commands` are lists of arguments; '{dir}' in them becomes the case's folder. Empty `codes` allow any exit
    code from 0 on."""
    name: str
    prepare: Callable
    commands: list
    names: list = dataclasses.field(default_factory=list)  # one of these is in an error line; none: not judged
    codes: tuple = (0, 1)  # of the last command; those before must end with 0
    drawn: bool = False  # whether out/ has the drawing of the base project
    seconds: float = 20  # of processor time, per command
    max_mb: int = 1500
    writes: tuple = ('out',)  # folders that may change
    keeps: tuple = KEPT  # below them: what may be left behind when the run fails
    environment: dict = dataclasses.field(default_factory=dict)
    run: Optional[Callable] = None  # instead of the commands: run(program, folder) returns (exit code, stdout, stderr)
    data: dict = dataclasses.field(default_factory=dict)  # of the kind
    # Set by the runner.
    kind: str = ''
    seed: int = 0
    index: int = 0

    def label(self):
        return f'{self.kind} --seed {self.seed} --case {self.index}: {self.name}'


@dataclasses.dataclass
class Outcome:
    folder: pathlib.Path
    code: int  # negative: the signal that ended it
    output: str
    errors: str
    seconds: float  # of processor time
    max_mb: int
    timed_out: bool
    before: dict  # what was there, see snapshot
    after: dict

    def warnings(self):
        return [line for line in (self.output + self.errors).splitlines() if 'WARNING: ' in line]

    def error_lines(self):
        return [line for line in self.errors.splitlines() if line.startswith('ERROR: ')]

    def changed(self, left_out=()):
        """Relative paths whose kind or content changed, in no folder that is left out."""
        return [path for path in sorted({**self.before, **self.after})
                if self.before.get(path) != self.after.get(path) and not is_below(path, left_out)]


def is_below(path, folders):
    return any(path == folder or path.startswith(folder + '/') for folder in folders)


def chooser_of(kind, seed, index):
    """Independent of other cases: any case can be made alone. Strings are hashed the same in every process."""
    import random
    return random.Random(f'{kind} {seed} {index}')


def snapshot(folder):
    """Kind, permissions and content of all that is below a folder, by relative path; links are not followed."""
    found = {}
    for top, folders, files in os.walk(os.fsencode(folder)):
        for name in folders + files:
            path = os.path.join(top, name)
            info = os.lstat(path)
            content = b''
            if stat.S_ISREG(info.st_mode) and info.st_mode & 0o400:
                with open(path, 'rb') as file:
                    content = hashlib.sha1(file.read()).digest()
            elif stat.S_ISLNK(info.st_mode):
                content = os.readlink(path)
            mode = info.st_mode if not stat.S_ISDIR(info.st_mode) else stat.S_IFDIR
            found[os.fsdecode(os.path.relpath(path, os.fsencode(folder)))] = (mode, content)
    return found


class Program:
    """limn, and a drawing of the base project to start from."""

    def __init__(self, limn, scratch):
        self.limn = pathlib.Path(limn).resolve()
        self.scratch = pathlib.Path(scratch)
        self.base = self.scratch / 'base'
        self.drawn = self.scratch / 'drawn'
        if not self.base.exists():
            scene.write_workspace(self.base)
            done = self.call(['automatic_drawer', '--workspace_path', str(self.base), '--output_path', str(self.drawn),
                              '--num_threads', '2'], self.scratch, 120)
            if done[0] != 0:
                raise RuntimeError('the base project cannot be drawn: ' + done[2])

    def call(self, arguments, folder, seconds, environment=None, max_mb=None, stdin=None):
        """(exit code, stdout, stderr, processor seconds, peak MB, whether it hung). A case hangs after three times the
        processor time that it may take, and 10 s: other programs run meanwhile."""
        return run_command([str(self.limn)] + arguments, folder, seconds, environment, max_mb, stdin)


def run_command(command, folder, seconds, environment=None, max_mb=None, stdin=None):
    def limits():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if max_mb and SLOWNESS == 1:  # sanitizers reserve terabytes
            resource.setrlimit(resource.RLIMIT_AS, ((max_mb + 3000) << 20,) * 2)

    with tempfile.TemporaryFile() as output, tempfile.TemporaryFile() as errors:
        process = subprocess.Popen(command, stdout=output, stderr=errors, stdin=stdin or subprocess.DEVNULL, cwd=folder,
                                   start_new_session=True, preexec_fn=limits, env={**os.environ, **(environment or {})})
        end, timed_out = time.monotonic() + 3 * SLOWNESS * seconds + 10, False
        while True:
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
            if pid:
                break
            if time.monotonic() > end:
                timed_out = True
                process.send_signal(signal.SIGKILL)
                _, status, usage = os.wait4(process.pid, 0)
                break
            time.sleep(0.005)
        process.returncode = os.waitstatus_to_exitcode(status)
        texts = []
        for file in (output, errors):
            file.seek(0)
            texts.append(file.read().decode(errors='backslashreplace'))
    return (process.returncode, *texts, usage.ru_utime + usage.ru_stime, usage.ru_maxrss // 1024, timed_out)


def run_case(case, program, folder):
    """Makes the case in a new folder, runs it and returns its outcome."""
    (folder / 'outside').mkdir(parents=True)
    (folder / 'outside' / 'note.txt').write_text('not ours\n')
    shutil.copytree(program.base, folder / 'ws', symlinks=True)
    if case.drawn:
        shutil.copytree(program.drawn, folder / 'out', symlinks=True)
    case.prepare(folder, chooser_of(case.kind, case.seed, case.index))
    before = snapshot(folder)
    if case.run:
        start = time.process_time()
        code, output, errors = case.run(program, folder)
        return Outcome(folder, code, output, errors, time.process_time() - start, 0, code is None, before, snapshot(folder))
    for number, command in enumerate(case.commands):
        arguments = [part.replace('{dir}', str(folder)) for part in command]
        code, output, errors, seconds, max_mb, timed_out = program.call(arguments, folder, case.seconds,
                                                                        case.environment, case.max_mb)
        if code != 0 and number + 1 < len(case.commands):
            break
    return Outcome(folder, code, output, errors, seconds, max_mb, timed_out, before, snapshot(folder))


def is_odd(character):
    """Whether a terminal may be led astray by it: controls, formats (U+202E), ends of lines (U+2028)."""
    return character not in '\n\t' and unicodedata.category(character) in ('Cc', 'Cf', 'Zl', 'Zp', 'Cs')


def check_process(case, outcome):
    broken = []
    if outcome.timed_out:
        broken.append('hangs')
    elif outcome.code < 0:
        broken.append(f'ended by signal {-outcome.code}')
    elif case.codes and outcome.code not in case.codes:
        broken.append(f'exit code {outcome.code}, not {" or ".join(map(str, case.codes))}')
    if outcome.seconds > SLOWNESS * case.seconds:
        broken.append(f'took {outcome.seconds:.1f} s of processor time')
    if outcome.max_mb > SLOWNESS * case.max_mb:
        broken.append(f'took {outcome.max_mb} MB')
    return broken


def check_words(case, outcome):
    broken, lines = [], outcome.error_lines()
    if len(lines) != (1 if outcome.code == 1 else 0):
        broken.append(f'{len(lines)} error lines with exit code {outcome.code}')
    if lines and case.names and not any(name in line for name in case.names for line in lines):
        broken.append(f'the error line has none of {case.names}')
    if lines and any(word in line for line in lines for word in RAW_WORDS) or any(
            word in outcome.errors for word in RAW_WORDS[-4:]):
        broken.append('words of a library')
    odd = sorted({character for character in outcome.output + outcome.errors if is_odd(character)})
    if odd:
        broken.append('odd characters: ' + ' '.join(f'U+{ord(character):04X}' for character in odd[:5]))
    return broken


def check_files(case, outcome):
    broken, changed = [], outcome.changed(case.writes)
    if changed:
        broken.append('changed: ' + ', '.join(map(repr, changed[:5])))
    left = [path for path in outcome.after if re.search(r'(\.limn-tmp|/\.lock)$', path) and path not in outcome.before]
    if left:
        broken.append('left behind: ' + ', '.join(map(repr, left[:5])))
    if outcome.code != 0:
        kept = [f'{folder}/{name}' for folder in case.writes for name in case.keeps]
        folders = {path for path, (mode, _) in outcome.after.items() if stat.S_ISDIR(mode)}
        part = [path for path in outcome.changed(kept) if is_below(path, case.writes) and path not in folders]
        if part:
            broken.append('failed, but changed: ' + ', '.join(map(repr, part[:5])))
    return broken


def check(case, outcome):
    """The rules that every outcome keeps."""
    return check_process(case, outcome) + check_words(case, outcome) + check_files(case, outcome)


def drawer(*options, overwrite=True):
    """Arguments of automatic_drawer on the case's project."""
    return ['automatic_drawer', '--workspace_path', '{dir}/ws', '--output_path', '{dir}/out', '--num_threads', '2',
            '--overwrite', '1' if overwrite else '0', *options]


def gzip_bomb(size):
    """Zeros, of this many bytes when unpacked."""
    packer = zlib.compressobj(9, zlib.DEFLATED, 31)
    blocks = [packer.compress(bytes(1 << 20)) for _ in range(size >> 20)]
    return b''.join(blocks) + packer.flush()
