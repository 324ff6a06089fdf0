# SPDX-License-Identifier: BSD-3-Clause
"""Keyword arguments as options of the command line."""

import os
from collections.abc import Iterable, Iterator, Mapping
from numbers import Integral
from typing import Any

import numpy as np

from limn.errors import OptionError


# Options that hold several texts.
_TEXT_LISTS = ("known_length",)


def _text_of(name: str, value: Any) -> str:
    if isinstance(value, (str, bytes, os.PathLike)):
        return os.fsdecode(value)
    if isinstance(value, (bool, np.bool_)):
        return "1" if value else "0"
    if isinstance(value, np.ndarray) and value.ndim == 0:
        return _text_of(name, value.item())
    if isinstance(value, Iterable):
        return (";" if name in _TEXT_LISTS else ",").join(_text_of(name, one) for one in value)
    try:
        return repr(int(value)) if isinstance(value, Integral) else repr(float(value))
    except (TypeError, ValueError):
        raise OptionError(f"{name} = {value!r}: must be a number, a text or a path") from None


def _named_texts(options: Iterable[tuple[str, Any]]) -> Iterator[tuple[str, str]]:
    for name, value in options:
        if isinstance(value, Mapping):
            yield from ((f"{name}.{field}", text) for field, text in _named_texts(value.items()))
        elif value is not None:
            yield name, _text_of(name, value)


def texts_of(options: Mapping[str, Any], /, **fixed: Any) -> dict[str, Any]:
    """Names and texts, as bytes, since paths may be no text; {"Drawing": {"method": "paper"}} is {"Drawing.method":
    "paper"}. None is not given. `fixed` are options that have other names in the function, or none."""
    texts: dict[str, Any] = {}
    for name, text in _named_texts([*fixed.items(), *options.items()]):
        if name in texts:
            raise OptionError(f"option '{name}' is given twice")
        try:
            texts[name] = os.fsencode(text)
        except UnicodeEncodeError:
            raise OptionError(f"{name} = {ascii(text)}: cannot be encoded") from None
    return texts
