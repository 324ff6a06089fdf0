#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Check that every source file of these kinds says its license in its first line: check_spdx.py [--write] [folder]

    // SPDX-License-Identifier: BSD-3-Clause      .cc .h .js .mjs .ts
    # SPDX-License-Identifier: BSD-3-Clause       .py .sh .bash .cmake CMakeLists.txt
    /* SPDX-License-Identifier: BSD-3-Clause */   .css
    <!-- SPDX-License-Identifier: BSD-3-Clause --> .html

in the second line after "#!", the doctype of a page or Python's coding line; also in templates (.h.in). With --write
adds the line where it is missing. Data, documents and JSON have none: LICENSE holds for them. In a repository of git
these are the files that it tracks.
"""

import argparse
import re
import subprocess
import sys
from pathlib import Path

TAG = "SPDX-License-Identifier: BSD-3-Clause"
FORMS = {
    "// {}": (".cc", ".h", ".js", ".mjs", ".ts"),
    "# {}": (".py", ".sh", ".bash", ".cmake"),
    "/* {} */": (".css",),
    "<!-- {} -->": (".html",),
}
FORM_OF_SUFFIX = {suffix: form for form, suffixes in FORMS.items() for suffix in suffixes}
# Lines that must stay first.
BEFORE = re.compile(rb"<!doctype [^>]*>\r?\n|(?:#!.*\n)?(?:[ \t]*#.*coding[:=].*\n)?", re.I)
SKIPPED_FOLDERS = {".git", "build", "node_modules"}


def form_of(path):
    """How the tag stands in a file, or None of one that has none."""
    if path.name == "CMakeLists.txt":
        return "# {}"
    return FORM_OF_SUFFIX.get(Path(path.name.removesuffix(".in")).suffix)


def source_files(root):
    """Files of ours that have a tag: those that git tracks or, in a copy without history, all that are not built."""
    listed = subprocess.run(["git", "-C", root, "ls-files", "-z"], capture_output=True, check=False)
    if listed.returncode == 0 and listed.stdout:
        files = [root / name.decode() for name in listed.stdout.split(b"\0") if name]
    else:
        files = [path for path in root.rglob("*") if not SKIPPED_FOLDERS & set(path.relative_to(root).parts)]
    return sorted(path for path in files if form_of(path) and path.is_file() and not path.is_symlink())


def place_of_tag(content):
    """Offset in bytes of the line where the tag belongs."""
    return BEFORE.match(content).end()


def problem(path):
    """What is wrong with the tag of a file, or None."""
    content = path.read_bytes()
    line = form_of(path).format(TAG).encode()
    here = content[place_of_tag(content):].split(b"\n", 1)[0].rstrip(b"\r")
    if here == line:
        return "has the tag twice" if content.splitlines().count(line) > 1 else None
    if re.search(rb"^\W{0,5}SPDX-License-Identifier:", content, re.M):
        return f'has another tag, or has it elsewhere; make it "{line.decode()}" in the first line (after "#!")'
    return "has no tag"


def add_tag(path):
    content = path.read_bytes()
    at = place_of_tag(content)
    before = content[:at]
    end = b"\r\n" if b"\r\n" in content[:1000] else b"\n"
    path.write_bytes(before + form_of(path).format(TAG).encode() + end + content[at:])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("folder", nargs="?", type=Path, default=Path(__file__).resolve().parents[1])
    chosen = parser.parse_args()
    files = source_files(chosen.folder)
    problems = {path: text for path in files if (text := problem(path))}
    added = [path for path, text in problems.items() if text == "has no tag"] if chosen.write else []
    for path in added:
        add_tag(path)
        del problems[path]
    for path, text in problems.items():
        print(f"{path.relative_to(chosen.folder)}: {text}")
    print(f"{len(files)} files, {len(added)} tags added, {len(problems)} problems"
          + ("; check_spdx.py --write adds missing ones" if "has no tag" in problems.values() else ""))
    return 1 if problems or not files else 0


if __name__ == "__main__":
    sys.exit(main())
