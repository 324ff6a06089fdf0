# SPDX-License-Identifier: BSD-3-Clause
"""Runs that end early: by a signal, or because nobody reads their lines any more. Whatever is left behind is whole, and
the same command goes on where it was."""

import os
import signal
import subprocess
import time

import hostile

SIGNALS = {'hangup': signal.SIGHUP, 'interrupt': signal.SIGINT, 'end': signal.SIGTERM}
READERS = ['none', 'first line', 'some lines', 'errors, too']
FINISHED_OR_STOPPED = (0, 130, 141, -signal.SIGPIPE)


def command_of(kind):
    if kind == 'drawer':
        return hostile.drawer('--page', '0')
    if kind == 'evaluator':
        return ['drawing_evaluator', '--input_path', '{dir}/out/drawing.json', '--truth_path', '{dir}/out/drawing.json', '--taus',
                '0.01,0.1']
    if kind == 'exporter':
        return ['drawing_exporter', '--input_path', '{dir}/out/drawing.json', '--output_path', '{dir}/out/x.dxf']
    return {'help': ['help'], 'all options': ['automatic_drawer', '--help_all']}[kind]


def wait(process, seconds=40):
    try:
        return process.wait(seconds)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
        return None


def run_with_signal(number, delay, is_ignored):
    def run(program, folder, command):
        with open(folder.parent / (folder.name + '.log'), 'w+b') as log:
            process = subprocess.Popen(command, stdout=log, stderr=log, stdin=subprocess.DEVNULL, start_new_session=True,
                                       preexec_fn=(lambda: signal.signal(number, signal.SIG_IGN)) if is_ignored else None)
            while process.poll() is None and os.fstat(log.fileno()).st_size == 0:  # it is still being loaded
                time.sleep(0.005)
            time.sleep(delay)
            process.send_signal(number)
            code = wait(process)
            log.seek(0)
            words = log.read().decode(errors='backslashreplace')
        os.unlink(log.name)
        return code, words, ''
    return run


def run_with_reader(reader, num_lines):
    def run(program, folder, command):
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stdin=subprocess.DEVNULL, start_new_session=True,
                                   stderr=subprocess.STDOUT if reader == 'errors, too' else subprocess.PIPE)
        for _ in range({'none': 0, 'first line': 1}.get(reader, num_lines)):
            process.stdout.readline()
        process.stdout.close()
        errors = process.stderr.read().decode(errors='backslashreplace') if process.stderr else ''
        return wait(process), '', errors
    return run


def again(run, arguments):
    """The run, then the same command to its end: its drawing must be that of an undisturbed run."""
    def both(program, folder):
        command = [str(program.limn)] + [part.replace('{dir}', str(folder)) for part in arguments]
        code, output, errors = run(program, folder, command)
        left = [name for name in ('curves/.lock',) if (folder / 'out' / name).exists()]
        left += [path for path in hostile.snapshot(folder) if path.endswith('.limn-tmp')]
        if left:
            errors += f'\nleft behind: {left}'
        if code is None:
            return code, output, errors
        second = hostile.run_command(command, folder, 30)
        if second[0] != 0:
            errors += f'\nthe second run ended with {second[0]}: {second[2]}'
        drawing = folder / 'out' / 'drawing.json'
        if second[0] == 0 and drawing.exists() and drawing.read_bytes() != (program.drawn / 'drawing.json').read_bytes():
            errors += '\nthe second run drew something else'
        return code, output, errors
    return both


def cases(seed, count):
    for index in range(count):
        chooser = hostile.chooser_of('ends_early', seed, -index - 1)
        kind = chooser.choice(['drawer'] * 6 + ['evaluator', 'exporter', 'help', 'all options'])
        command, codes = command_of(kind), FINISHED_OR_STOPPED
        if kind == 'drawer' and chooser.random() < 0.5:
            name, delay = chooser.choice(list(SIGNALS)), chooser.uniform(0, 0.5)
            is_ignored = name == 'hangup' and chooser.random() < 0.3  # as by nohup
            codes = (0,) if is_ignored else FINISHED_OR_STOPPED
            told = f'{name}{" that is ignored" if is_ignored else ""} after {delay:.2f} s'
            run = run_with_signal(SIGNALS[name], delay, is_ignored)
        else:
            reader, num_lines = chooser.choice(READERS), chooser.randrange(30)
            told, run = f'read by {reader}', run_with_reader(reader, num_lines)
        yield hostile.Case(f'{kind}, {told}', lambda folder, _: None, [], codes=codes, run=again(run, command),
                           drawn=kind in ('evaluator', 'exporter'), seconds=60)


def check(case, outcome):
    broken = [rule for rule in hostile.check_files(case, outcome) if not rule.startswith('failed')]
    if outcome.code is None:
        return broken + ['hangs']
    if outcome.code not in case.codes:
        broken.append(f'exit code {outcome.code}')
    lines = outcome.errors.splitlines()
    broken += [line for line in lines if line.startswith(('left behind', 'the second run'))]
    broken += [line for line in lines if line.startswith('ERROR: ')]
    return broken
