# SPDX-License-Identifier: BSD-3-Clause
"""What pickles call to make objects again: functions of the compiled part have no names that pickle can look up."""

from typing import Any

from limn import _limn


def scene(options: dict[str, Any]) -> Any:
    """The folder, opened again."""
    return _limn.open(options, None)


def camera(*values: Any) -> Any:
    return _limn.make_camera(*values)


def drawing(text: bytes) -> Any:
    """A drawing without its scene."""
    return _limn.make_drawing(text)


def round_body(*values: Any) -> Any:
    return _limn.make_round_body(*values)
