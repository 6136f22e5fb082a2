"""The type stubs name what the module has, no more and no less."""

import ast
import inspect
import pathlib

import brume


def members(node):
    names = set()
    for item in node.body:
        if isinstance(item, (ast.FunctionDef, ast.ClassDef)):
            names.add(item.name)
        elif isinstance(item, ast.AnnAssign):
            names.add(item.target.id)
    return names


def public(thing):
    return {name for name in vars(thing) if not name.startswith("_")}


def test_stubs():
    text = (pathlib.Path(brume.__file__).parent / "__init__.pyi").read_text()
    tree = ast.parse(text)
    compile(text, "__init__.pyi", "exec")  # which refuses more than the parser alone
    assert {n for n in members(tree) if not n.startswith("_")} == set(brume.__all__)
    for node in tree.body:
        if isinstance(node, ast.ClassDef) and not issubclass(getattr(brume, node.name), Exception):
            stubs = {name for name in members(node) if not name.startswith("_")}
            assert stubs == public(getattr(brume, node.name)), node.name


def test_everything_is_documented():
    for name in brume.__all__:
        thing = getattr(brume, name)
        if inspect.isclass(thing) and issubclass(thing, Exception):
            continue
        assert inspect.getdoc(thing), name
