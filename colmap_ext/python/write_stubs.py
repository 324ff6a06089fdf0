#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""write_stubs.py <folder of the package limn>: writes _limn.pyi, the types of the compiled module _limn, there.

pybind11 writes the signature of every function at the beginning of its documentation; this makes a stub of them.
"""

import inspect
import re
import sys
from pathlib import Path

HEAD = '''"""Types of the compiled part of limn. Written by write_stubs.py."""

import collections.abc
import os
import typing
from typing import Any, Dict, Iterator, List, Optional, Tuple

import numpy
import numpy.typing

__version__: str
'''


def python_types(signature):
    """The types of a signature by pybind11 as those of a stub."""
    for pattern, replacement in [(r"numpy\.ndarray\[([\w.]+)\]", r"numpy.typing.NDArray[\1]"), (r"numpy\.ndarray(?!\[)", "numpy.typing.NDArray[Any]"),
                                 (r"\b(\w+)\[\d+\]", r"\1"), (r"\b(limn\.)?_limn\.", ""),
                                 (r"\bos\.PathLike\b", "os.PathLike[str] | str"), (r"\bobject\b", "Any"),
                                 (r"\bdict\b", "Dict[str, Any]"), (r"\blist\b", "List[Any]"), (r"\barg0\b", "key")]:
        signature = re.sub(pattern, replacement, signature)
    return signature


def signatures_of(function, name):
    """One, or those of its overloads, which pybind11 numbers."""
    lines = (function.__doc__ or "").strip().splitlines()
    if lines[1:2] == ["Overloaded function."]:
        lines = [line.partition(". ")[2] for line in lines if re.match(r"\d+\. \w+\(", line)]
    else:
        lines = lines[:1]
    matches = [re.match(r"\w*(\(.*\)( -> .*)?)$", line) for line in lines]
    if not matches or None in matches:
        raise SystemExit(f"write_stubs.py: no signature of {name}: {lines!r}")
    return [python_types(match.group(1)) for match in matches]


def signature_of(function, name):
    return signatures_of(function, name)[0]


def stub_of_function(function, name, indent):
    signatures = signatures_of(function, name)
    overload = f"{indent}@typing.overload\n" if len(signatures) > 1 else ""
    return "".join(f"{overload}{indent}def {name}{signature}: ...\n" for signature in signatures)


def item_of(bound):
    """What iterating over a sequence or a mapping gives."""
    match = re.search(r"\(.*, key: (\w+)\) -> (\w+)", signature_of(vars(bound)["__getitem__"], "__getitem__")) \
        if "__getitem__" in vars(bound) else None
    return match and (match.group(2) if match.group(1) == "int" else match.group(1))


def stub_of_class(bound):
    lines = [f"class {bound.__name__}:\n"]
    for name, member in sorted(vars(bound).items()):
        if isinstance(member, property):
            of_self = re.sub(r"^\([^)]*\)", "(self)", signature_of(member.fget, name))
            lines.append(f"    @property\n    def {name}{of_self}: ...\n")
        elif isinstance(member, staticmethod):  # written in Python
            signature = str(inspect.signature(member.__func__)).replace("limn._limn.", "")
            lines.append(f"    @staticmethod\n    def {name}{signature}: ...\n")
        elif callable(member) and (not name.startswith("_") or name in ("__getitem__", "__len__", "__iter__")):
            text = re.sub(r"\(self: \w+", "(self", stub_of_function(member, name, "    "))
            lines.append(text.replace("Iterator", f"Iterator[{item_of(bound)}]"))
    return "".join(lines if len(lines) > 1 else [lines[0], "    ...\n"])


def main():
    folder = Path(sys.argv[1]).resolve()
    sys.path.insert(0, str(folder.parent))
    from limn import _limn
    parts = [HEAD]
    for name, member in sorted(vars(_limn).items()):
        if inspect.isclass(member):
            parts.append("\n\n" + stub_of_class(member))
    parts.append("\n\n")
    for name, member in sorted(vars(_limn).items()):
        if inspect.isbuiltin(member) and not name.startswith("_"):
            parts.append(stub_of_function(member, name, ""))
    (folder / "_limn.pyi").write_text("".join(parts), encoding="utf-8")


if __name__ == "__main__":
    main()
