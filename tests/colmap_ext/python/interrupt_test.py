#!/usr/bin/env python3
"""Ctrl-C at several moments of a run: KeyboardInterrupt within two seconds, the interpreter's lock is free meanwhile."""

import os
import signal
import subprocess
import sys
import threading
import time
import unittest

import limn
import scenes

MOMENTS = [0.3, 1.0, 3.0, 8.0]  # seconds after the run began

CHILD = """
import sys, limn, scenes
print("begin", flush=True)
try:
    limn.draw(scenes.DAY, num_threads=2)
except KeyboardInterrupt:
    print("interrupted", flush=True)
    sys.exit(0)
print("drawn", flush=True)
sys.exit(1)
"""


class Interrupts(unittest.TestCase):
    def test_control_c_raises_within_two_seconds(self):
        for moment in MOMENTS:
            with self.subTest(moment=moment):
                environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
                with subprocess.Popen([sys.executable, "-c", CHILD], stdout=subprocess.PIPE, env=environment,
                                      text=True) as child:
                    self.assertEqual(child.stdout.readline(), "begin\n")
                    time.sleep(moment)
                    sent = time.monotonic()
                    child.send_signal(signal.SIGINT)
                    line = child.stdout.readline()
                    seconds = time.monotonic() - sent
                    if line == "drawn\n":  # a fast machine
                        continue
                    self.assertEqual(line, "interrupted\n")
                    self.assertLess(seconds, 2)
                    self.assertEqual(child.wait(5), 0)  # what was left has ended, too

    def test_other_threads_of_python_run_meanwhile(self):
        count, over = 0, threading.Event()

        def work():
            nonlocal count
            while not over.is_set():
                count += 1
                time.sleep(0.01)

        thread = threading.Thread(target=work)
        thread.start()
        began = time.monotonic()
        try:
            limn.link(scenes.DAY, **scenes.small_options())
        finally:
            seconds = time.monotonic() - began
            over.set()
            thread.join()
        self.assertGreater(count, min(20, 20 * seconds))

    def test_two_runs_at_once(self):
        drawings = []

        def draw():
            drawings.append(limn.draw(scenes.DAY, **scenes.small_options()))

        threads = [threading.Thread(target=draw) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        a, b = drawings
        self.assertEqual([link.points.tobytes() for link in a.links], [link.points.tobytes() for link in b.links])


if __name__ == "__main__":
    unittest.main()
