"""Keyword arguments as options of the command line."""

import os
from collections.abc import Iterable, Mapping
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


def texts_of(options: Mapping[str, Any]) -> dict[str, str]:
    """Names and texts; {"Drawing": {"method": "paper"}} is {"Drawing.method": "paper"}. None is not given."""
    texts: dict[str, str] = {}
    for name, value in options.items():
        if isinstance(value, Mapping):
            named = {f"{name}.{field}": text for field, text in texts_of(value).items()}
        elif value is None:
            continue
        else:
            named = {name: _text_of(name, value)}
        for one, text in named.items():
            if one in texts:
                raise OptionError(f"option '{one}' is given twice")
            texts[one] = text
    return texts
