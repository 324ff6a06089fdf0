# SPDX-License-Identifier: BSD-3-Clause
"""Python programs in processes of their own, for tests of signals and of the end of the interpreter."""

import os
import queue
import signal
import subprocess
import sys
import threading

# Also where the test itself runs in the background, which ignores Ctrl-C.
HEAD = "import signal\nsignal.signal(signal.SIGINT, signal.default_int_handler)\n"


class Child:
    """A program with its output and errors, line by line. It ends with the test at the latest."""

    def __init__(self, test, program, *arguments):
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
        self._process = subprocess.Popen(
            [sys.executable, "-u", "-c", HEAD + program, *map(str, arguments)], stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, env=environment, text=True, start_new_session=True)
        test.addCleanup(self._end)
        self._lines = queue.Queue()
        self._reader = threading.Thread(target=self._read)
        self._reader.start()

    def _read(self):
        for line in self._process.stdout:
            self._lines.put(line.rstrip("\n"))

    def _end(self):
        try:
            os.killpg(self._process.pid, signal.SIGKILL)  # what it forked, too
        except ProcessLookupError:
            pass
        self._process.wait()
        self._reader.join()
        self._process.stdout.close()

    def interrupt(self):
        self._process.send_signal(signal.SIGINT)

    def line(self, seconds=60):
        """The next line. Raises queue.Empty."""
        return self._lines.get(timeout=seconds)

    def wait(self, seconds=60):
        """The exit code, and the lines that are left."""
        code = self._process.wait(seconds)
        self._reader.join(seconds)
        return code, list(self._lines.queue)
