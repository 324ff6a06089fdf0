# SPDX-License-Identifier: BSD-3-Clause
"""The .glb of write_pictures (argument), read by Blender in background mode."""

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77  # of ctest

if __name__ == "__main__":
    if shutil.which("blender") is None:
        print("SKIPPED: blender is not installed, .glb drawings are not read back")
        sys.exit(SKIPPED)
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.argv[1], folder], check=True)
        script = Path(__file__).with_name("glb_in_blender.py")
        sys.exit(subprocess.run(["blender", "--background", "--factory-startup", "--python-exit-code", "1", "--python",
                                 script, "--", folder]).returncode)
