#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""write_reference.py <folder of the package limn> <page>: writes the reference of the package, from its docstrings:

    python3 colmap_ext/python/write_reference.py build/release/python/limn colmap_ext/docs/python-reference.md
"""

import ast
import inspect
import re
import sys
from pathlib import Path

import write_stubs

HEAD = """# Reference of the Python package

Written by `colmap_ext/python/write_reference.py` from the docstrings: change those, not this page. The rules that all functions share (options,
units, errors, what is written) are in [From Python](python.md); the options themselves in [Commands and options](commands.md).

In types `Path` is a `str` or an `os.PathLike`, `ndarray` an array of numpy with the type of its numbers, and `Progress` a function of
(stage: `str`, done: `int`, total: `int`) or `None`.
"""


class ReadableTypes(ast.NodeTransformer):
    """Types as one says them: X | None, list[X], ndarray[float64], Path."""

    def visit_Attribute(self, node):  # without the module
        return ast.Name({"NDArray": "ndarray"}.get(node.attr, node.attr))

    def visit_Name(self, node):
        return ast.Name(node.id.lower() if node.id in ("Dict", "List", "Tuple") else node.id)

    def visit_Subscript(self, node):
        node = self.generic_visit(node)
        items = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
        if node.value.id == "Optional":
            return ast.Name(f"{ast.unparse(items[0])} | None")
        if node.value.id == "Union":
            return ast.Name(" | ".join(map(ast.unparse, items)))
        return node.value if ast.unparse(node.slice) == "Any" else node


def type_of(annotation):
    """Nothing for Any: the text tells."""
    text = ast.unparse(ReadableTypes().visit(annotation)) if annotation else "Any"
    if text.startswith("PathLike"):  # with str and, in later versions of pybind11, bytes
        return "Path"
    return "" if text == "Any" else text


def argument_text(argument, default=None, stars=""):
    of_type = type_of(argument.annotation)
    value = f"{' = ' if of_type else '='}{ast.unparse(default)}" if default else ""
    return f"{stars}{argument.arg}{of_type and ': ' + of_type}{value}"


def signature_text(function):
    """(arguments) -> result of the syntax tree of a function, without self."""
    arguments = function.args
    defaults = [None] * (len(arguments.args) - len(arguments.defaults)) + arguments.defaults
    parts = [argument_text(*pair) for pair in zip(arguments.args, defaults) if pair[0].arg != "self"]
    parts += ["*"] if arguments.kwonlyargs else []
    parts += [argument_text(*pair) for pair in zip(arguments.kwonlyargs, arguments.kw_defaults)]
    parts += [argument_text(arguments.kwarg, stars="**")] if arguments.kwarg else []
    result = type_of(function.returns)
    return f"({', '.join(parts)})" + (f" -> {result}" if result else "")


def trees_of(function, name):
    """The syntax trees of a function, one per overload: of its source, or of what pybind11 says."""
    if inspect.isfunction(function):
        return ast.parse(inspect.getsource(function)).body
    return [ast.parse(f"def {name}{signature}: ...").body[0] for signature in write_stubs.signatures_of(function, name)]


def documentation_of(member, name):
    text = inspect.getdoc(member) or ""
    if re.match(r"\w+\(.*\)( -> .*)?$", text.partition("\n")[0]):  # by pybind11
        text = text.partition("\n")[2].strip()
    if not text:
        raise SystemExit(f"write_reference.py: {name}: no docstring")
    return text


def function_text(title, function, name, heading="###"):
    called = name.rpartition(".")[2]
    signatures = [f"{name}{signature_text(tree)}\n" for tree in trees_of(function, called)]
    return f"\n{heading} {title}\n\n```python\n{''.join(signatures)}```\n\n{documentation_of(function, name)}\n"


def properties_text(bound):
    rows = []
    for name, member in vars(bound).items():
        if isinstance(member, property):
            of_type = type_of(trees_of(member.fget, name)[0].returns).replace(" | ", " or ")
            text = " ".join(documentation_of(member, f"{bound.__name__}.{name}").split())
            rows.append(f"| `{name}` | {of_type and f'`{of_type}`'} | {text} |\n".replace("``", ""))
    return "".join(["\n| property | type | |\n|---|---|---|\n", *rows] if rows else [])


def items_text(bound):
    """What [], loops and len() give."""
    says = []
    if "__getitem__" in vars(bound):
        for tree in trees_of(vars(bound)["__getitem__"], "__getitem__"):
            says.append(f"`[{type_of(tree.args.args[1].annotation)}]` gives `{type_of(tree.returns)}`")
    says += [f"loops give `{write_stubs.item_of(bound)}`"] if "__iter__" in vars(bound) else []
    says += ["it has `len()`"] if "__len__" in vars(bound) else []
    text = ", ".join(says)
    return f"\n{text[:1].upper()}{text[1:]}.\n" if says else ""


def fields_text(bound):
    """Of a named tuple, which is written in Python."""
    if not hasattr(bound, "_fields"):
        return ""
    body = ast.parse(inspect.getsource(bound)).body[0].body
    fields = [f"{field.target.id}: {type_of(field.annotation)}" for field in body if isinstance(field, ast.AnnAssign)]
    return f"\n```python\n{bound.__name__}({', '.join(fields)})\n```\n"


def class_text(bound):
    parts = [f"\n### class {bound.__name__}\n", fields_text(bound), f"\n{documentation_of(bound, bound.__name__)}\n", items_text(bound),
             properties_text(bound)]
    for name, member in vars(bound).items():
        if not name.startswith("_") and (callable(member) or isinstance(member, staticmethod)):
            function = member.__func__ if isinstance(member, staticmethod) else member
            parts.append(function_text(f"{bound.__name__}.{name}", function, f"{bound.__name__}.{name}", "####"))
    return "".join(parts)


def error_text(error):
    bases = ", ".join(f"`{base.__name__}`" for base in error.__bases__)
    return f"| `{error.__name__}` | {bases} | {documentation_of(error, error.__name__)} |\n"


def index_text(kind, names, prefix=""):
    return f"\n{kind}: " + ", ".join(f"[`{name}`](#{prefix}{name.lower()})" for name in names) + ".\n"


def page_text(limn):
    public = {name: getattr(limn, name) for name in limn.__all__}
    functions = [member for member in vars(limn).values() if inspect.isfunction(member) and member.__name__ in public]
    errors = [member for member in vars(limn.errors).values() if inspect.isclass(member)]
    classes = [member for name, member in sorted(public.items()) if inspect.isclass(member) and member not in errors]
    parts = [HEAD, index_text("Functions", [function.__name__ for function in functions]),
             index_text("Classes", [bound.__name__ for bound in classes], "class-"), "\n[Errors](#errors).\n\n## Functions\n"]
    parts += [function_text(function.__name__, function, f"limn.{function.__name__}") for function in functions]
    parts += ["\n## Classes\n", *map(class_text, classes)]
    parts += ["\n## Errors\n\n| error | is a | |\n|---|---|---|\n", *map(error_text, errors)]
    return "".join(parts)


def main():
    folder, page = map(Path, sys.argv[1:])
    sys.path.insert(0, str(folder.resolve().parent))  # before the sources, which are beside this file
    import limn
    page.write_text(page_text(limn), encoding="utf-8")


if __name__ == "__main__":
    main()
