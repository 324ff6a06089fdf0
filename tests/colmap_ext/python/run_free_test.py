#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Work that does not stop when it is asked to: what is raised, and how the interpreter ends meanwhile."""

import tempfile
import time
import unittest
from pathlib import Path

import children
import stubborn_work

FAIL = """
def fail(*state):
    raise ValueError
"""

LEAVES_WORK = """
import atexit, sys, stubborn_work
atexit.register(print, "ending")
try:
    stubborn_work.work(float(sys.argv[1]), lambda *state: print("begin"), sys.argv[2])
except KeyboardInterrupt:
    print("interrupted")
"""

DAEMON_THREADS = FAIL + """
import threading, stubborn_work
def work(seconds, progress):
    stubborn_work.work(seconds, progress)
    print("not interrupted")
def leave(seconds):
    while True:
        try:
            stubborn_work.work(seconds, fail)
        except ValueError:
            pass
try:
    stubborn_work.work(4, fail)
except ValueError:
    pass
began = [threading.Event() for _ in range(2)]
for seconds, event in zip((0.9, 5), began):
    threading.Thread(target=work, args=(seconds, lambda *state, event=event: event.set()), daemon=True).start()
for i in range(8):
    threading.Thread(target=leave, args=(1.6 + i / 20,), daemon=True).start()
for event in began:
    event.wait()
"""

FORKS = FAIL + """
import os, sys, time, stubborn_work
try:
    stubborn_work.work(60, fail)
except ValueError:
    pass
began = time.monotonic()
child = os.fork()
if child == 0:
    stubborn_work.work(0, None)
    sys.exit(7)
print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), time.monotonic() - began < 1)
os._exit(0)
"""

FORKS_MEANWHILE = """
import os, sys, stubborn_work
child = None
def fork(*state):
    global child
    child = os.fork()
try:
    stubborn_work.work(0.5, fork)
except RuntimeError as error:
    print(error)
    sys.exit(7)
print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
"""


class RunFree(unittest.TestCase):
    def test_work_that_does_not_stop_is_left(self):
        def fail(stage, done, total):
            raise ZeroDivisionError(stage)

        began = time.monotonic()
        with self.assertRaisesRegex(ZeroDivisionError, "stubborn"):
            stubborn_work.work(3, fail)
        self.assertLess(time.monotonic() - began, 2.5)
        self.assertEqual(stubborn_work.num_working(), 1)
        while stubborn_work.num_working() > 0:
            time.sleep(0.01)
        stubborn_work.work(0, None)  # joins it

    def test_the_end_waits_for_it(self):
        child = children.Child(self, LEAVES_WORK, 4, "")
        self.assertEqual(child.line(), "begin")
        child.interrupt()
        self.assertEqual([child.line(), child.line()], ["interrupted", "ending"])
        self.assertEqual(child.wait(), (0, []))

    def test_a_second_interrupt_does_not_and_leaves_no_half_written_file(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "half")
            child = children.Child(self, LEAVES_WORK, 300, file)
            self.assertEqual(child.line(), "begin")
            self.assertTrue(file.exists())
            child.interrupt()
            self.assertEqual([child.line(), child.line()], ["interrupted", "ending"])
            time.sleep(0.5)  # the next function to be called at the end waits
            child.interrupt()
            self.assertEqual(child.wait(10), (130, []))
            self.assertFalse(file.exists())

    def test_the_end_stops_runs_of_daemon_threads(self):
        # One stops in time, one is left; others leave work again and again while the interpreter ends.
        child = children.Child(self, DAEMON_THREADS)
        self.assertEqual(child.wait(), (0, []))

    def test_a_forked_process_does_not_wait_for_work_of_its_parent(self):
        child = children.Child(self, FORKS)
        self.assertEqual(child.line(), "7 True")
        self.assertEqual(child.wait(), (0, []))

    def test_a_run_does_not_go_on_in_a_forked_process(self):
        child = children.Child(self, FORKS_MEANWHILE)
        self.assertEqual(child.wait(), (0, ["a run does not continue in a forked process", "7"]))


if __name__ == "__main__":
    unittest.main()
