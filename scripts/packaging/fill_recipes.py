#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fills in the recipes of conda-forge, vcpkg and Homebrew for a release: where it is, and checksums of its archives.

    fill_recipes.py --repository OWNER/NAME --maintainer NAME --archive limn-0.3.0.tar.gz --npm_cache limn-0.3.0-npm-cache.tar.gz --output FOLDER

The recipes beside this file hold marks like @LIMN_SHA256@. They are written to FOLDER/conda, FOLDER/vcpkg and FOLDER/homebrew."""

import argparse
import hashlib
import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
RECIPES = ("conda/recipe.yaml", "vcpkg/limn/vcpkg.json", "vcpkg/limn/portfile.cmake", "homebrew/limn.rb")
MARK = re.compile(r"@LIMN_[A-Z0-9_]+@")


def digest(path, algorithm):
    with path.open("rb") as file:
        return hashlib.file_digest(file, algorithm).hexdigest()


def values(repository, maintainer, archive, npm_cache):
    """Mark -> what stands for it."""
    return {
        "@LIMN_REPOSITORY@": repository,
        "@LIMN_MAINTAINER@": maintainer,
        "@LIMN_SHA256@": digest(archive, "sha256"),
        "@LIMN_SHA512@": digest(archive, "sha512"),
        "@LIMN_NPM_CACHE_SHA256@": digest(npm_cache, "sha256"),
        "@LIMN_NPM_CACHE_SHA512@": digest(npm_cache, "sha512"),
    }


def filled(text, known):
    """A recipe without marks; a mark that is not known is a KeyError."""
    return MARK.sub(lambda match: known[match.group()], text)


def options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--repository", required=True, help="OWNER/NAME at github.com")
    parser.add_argument("--maintainer", required=True, help="who maintains the recipe of conda-forge, at github.com")
    parser.add_argument("--archive", required=True, type=Path)
    parser.add_argument("--npm_cache", required=True, type=Path)
    parser.add_argument("--output", required=True, type=Path)
    return parser.parse_args()


def main():
    chosen = options()
    if not re.fullmatch(r"[\w.-]+/[\w.-]+", chosen.repository):
        raise SystemExit(f"--repository {chosen.repository}: not of the form OWNER/NAME")
    for path in (chosen.archive, chosen.npm_cache):
        if not path.is_file():
            raise SystemExit(f"{path}: no such file; the job of scripts/packaging/github/release.yml makes it")
    known = values(chosen.repository, chosen.maintainer, chosen.archive, chosen.npm_cache)
    for name in RECIPES:
        path = chosen.output / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(filled((HERE / name).read_text(encoding="utf-8"), known), encoding="utf-8")
        print(path)
    return 0


if __name__ == "__main__":
    sys.exit(main())
