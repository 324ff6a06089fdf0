"""Keyword arguments as options of the command line."""

import os
from collections.abc import Iterable, Mapping
from numbers import Integral
from typing import Any

from limn.errors import OptionError


def _text_of(name: str, value: Any) -> str:
    if isinstance(value, str):
        return value
    if isinstance(value, os.PathLike):
        return str(os.fspath(value))
    if isinstance(value, bool) or type(value).__name__ == "bool_":  # numpy's
        return "1" if value else "0"
    if isinstance(value, Iterable):
        return ",".join(_text_of(name, one) for one in value)
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
