# SPDX-License-Identifier: BSD-3-Clause
"""What Debian says of the license of a package: /usr/share/doc/<package>/copyright, read as far as it can be.

A license is of one of four kinds, from the least to the most demanding: permissive (text and notice), mpl (changed files
stay open), lgpl (the library must stay replaceable), gpl (so is all that is linked to it). Copyright files are of source packages:
they name the licenses of tests and build scripts, too. What is none of these but mentions the GPL is for a person to look at; what was found is in
reviewed_licenses.txt.
"""

import re
from pathlib import Path

KINDS = ("permissive", "mpl", "lgpl", "gpl")
DOC = Path("/usr/share/doc")
COMMON = Path("/usr/share/common-licenses")
REVIEWED = Path(__file__).resolve().parent / "reviewed_licenses.txt"

# Files of a source package from which no library is made.
NOT_COMPILED = re.compile(
    r"(^|/)(debian|m4|build-aux|config|autotools|tests?|testsuite|docs?|documentation|manual|man|examples?|demos?|samples?)/"
    r"|(^|/)(aclocal\.m4|ar-lib|compile|config\.(guess|sub|rpath|h\.in)|configure(\.(ac|in))?|depcomp|install-sh|"
    r"libtool|ltmain\.sh|missing|mdate-sh|mkinstalldirs|py-compile|test-driver|ylwrap|Makefile\.(am|in))$|\.m4$|\.(1|3|html|txt|md)$")
# Exceptions that let programs made with build tools, or linked to GCC's libraries, have any license.
FREEING = re.compile(r"with[- ](the[- ])?(auto(conf|make)|libtool|bison|texinfo|gcc|runtime|linux-syscall)", re.I)


def kind_of_name(name):
    """Of the short name of a license, such as "LGPL-2.1+ or MPL-2"; of alternatives the least, of sums the most demanding."""
    alternatives = re.split(r"\s+or\s+|\s*\|\s*", name, flags=re.I)
    if len(alternatives) > 1:
        return min((kind_of_name(part) for part in alternatives), key=KINDS.index)
    parts = re.split(r"\s+and\s+|,\s*", name, flags=re.I)
    if len(parts) > 1:
        return max((kind_of_name(part) for part in parts), key=KINDS.index)
    if FREEING.search(name):
        return "permissive"
    if re.search(r"LGPL|lesser general|library general", name, re.I):
        return "lgpl"
    if re.search(r"GPL", name, re.I):
        return "gpl"
    return "mpl" if re.match(r"MPL|Mozilla|EPL|CDDL", name, re.I) else "permissive"


def fields(paragraph):
    """Field -> its lines, joined by newlines, of a paragraph of a machine-readable file."""
    result, name = {}, None
    for line in paragraph.split("\n"):
        if line[:1].isspace():
            if name:
                result[name] += "\n" + line.strip()
        elif ":" in line:
            name, _, value = line.partition(":")
            result[name] = value.strip()
    return result


def licenses_of_files(text):
    """[(license, files)] of a machine-readable copyright file, without files that are not compiled; None of another one."""
    if "copyright-format" not in text[:400] and not text.lstrip().startswith("Format:"):
        return None
    found = []
    for paragraph in re.split(r"\n\s*\n", text):
        parts = fields(paragraph)
        if "Files" not in parts:
            continue
        files = [file for file in re.split(r"[\s,]+", parts["Files"]) if file and not NOT_COMPILED.search(file)]
        if files:
            found.append((parts.get("License", "").split("\n")[0].strip(), files))
    return found


def kind_of_text(text):
    """Of a copyright file that only people can read: the most demanding kind that it mentions."""
    without_lesser = re.sub(r"GNU\s+(Lesser|Library)\s+General\s+Public|LGPL", "", text, flags=re.I)
    if re.search(r"GNU\s+General\s+Public|\bGPL", without_lesser, re.I):
        return "gpl"
    return "lgpl" if without_lesser != text else "permissive"


class License:
    """kind; name for people; where, the files under the most demanding license; reviewed, whether a person looked."""

    def __init__(self, kind, name, where="", reviewed=False):
        self.kind, self.name, self.where, self.reviewed = kind, name, where, reviewed


def reviewed_licenses(path=REVIEWED):
    """Package -> License, from lines "package | kind | license | what was found"."""
    result = {}
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        parts = [part.strip() for part in line.split("|")]
        if len(parts) != 4 or parts[1] not in KINDS:
            raise SystemExit(f"{path}:{number}: not of the form: package | {' or '.join(KINDS)} | license | what was found")
        result[parts[0]] = License(parts[1], parts[2], parts[3], reviewed=True)
    return result


def copyright_text(package):
    path = DOC / package / "copyright"
    if not path.is_file():
        raise SystemExit(f"{path}: no such file, so the license of {package} is unknown; install the package (not with excluded documents)")
    return path.read_text(encoding="utf-8", errors="replace")


def license_of(package, reviewed):
    """The License of a package: as reviewed, or as its copyright file has it."""
    if package in reviewed:
        return reviewed[package]
    text = copyright_text(package)
    found = licenses_of_files(text)
    if found is None:
        kind = kind_of_text(text)
        return License(kind, f"see its text{'' if kind == 'permissive' else f', which mentions the {kind.upper()}'}")
    if not found:
        raise SystemExit(f"{DOC / package}/copyright: names no files; look at it and add a line to {REVIEWED.name}")
    names = sorted({name for name, _ in found})
    kind = max((kind_of_name(name) for name in names), key=KINDS.index)
    demanding = [file for name, files in found if kind_of_name(name) == kind for file in files]
    return License(kind, ", ".join(names), " ".join(demanding) if kind in ("lgpl", "gpl") else "")


def common_licenses_in(text):
    """Names of /usr/share/common-licenses that a text refers to, with links (GPL -> GPL-3) resolved."""
    names = {match.rstrip(".-") for match in re.findall(r"/usr/share/common-licenses/([\w.+-]+)", text)}
    return sorted({(COMMON / name).resolve().name for name in names if (COMMON / name).is_file()})
