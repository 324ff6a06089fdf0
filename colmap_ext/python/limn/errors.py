# SPDX-License-Identifier: BSD-3-Clause
"""The exceptions of limn: the text is the line that the program would print."""


class Error(Exception):
    """Base class of all errors of limn."""


class OptionError(Error, ValueError):
    """An option is unknown or outside its range; the text names option, value and range."""


class InputError(Error, ValueError):
    """Input is well-formed but unusable, such as cameras that all have the same center."""


class IoError(Error, OSError):
    """A file cannot be read or written; the text names path, place and reason."""
