#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C at several moments of a run: KeyboardInterrupt within two seconds, the interpreter's lock is free meanwhile."""

import threading
import time
import unittest

import children
import limn
import scenes

MOMENTS = [0.3, 1.0, 3.0, 8.0]  # seconds after the run began

DRAWS = """
import limn, scenes
try:
    print("begin")
    limn.draw(scenes.DAY, num_threads=2)
    print("drawn")
except KeyboardInterrupt:
    print("interrupted")
"""


class Interrupts(unittest.TestCase):
    def test_control_c_raises_within_two_seconds(self):
        num_interrupted = 0
        for moment in MOMENTS:
            with self.subTest(moment=moment):
                child = children.Child(self, DRAWS)
                self.assertEqual(child.line(), "begin")
                time.sleep(moment)
                sent = time.monotonic()
                child.interrupt()
                line = child.line()
                seconds = time.monotonic() - sent
                if line == "drawn":  # a fast machine
                    continue
                self.assertEqual(line, "interrupted")
                self.assertLess(seconds, 2)
                self.assertEqual(child.wait(), (0, []))  # what was left has ended, too
                num_interrupted += 1
        self.assertGreater(num_interrupted, 0)

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
