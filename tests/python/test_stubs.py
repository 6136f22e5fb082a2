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


def test_keywords_of_render_are_the_options():
    tree = ast.parse((pathlib.Path(brume.__file__).parent / "__init__.pyi").read_text())
    signature = inspect.getdoc(brume.render).splitlines()[0]
    options = ast.parse(f"def {signature}: ...").body[0].args
    functions = [node for node in ast.walk(tree) if getattr(node, "name", "") == "render"]
    assert len(functions) == 2
    for function in functions:
        assert [it.arg for it in function.args.kwonlyargs] == [it.arg for it in options.kwonlyargs]
        defaults = [ast.literal_eval(it) for it in function.args.kw_defaults]
        assert defaults == [ast.literal_eval(it) for it in options.kw_defaults]


def test_everything_is_documented():
    for name in brume.__all__:
        thing = getattr(brume, name)
        if inspect.isclass(thing) and issubclass(thing, Exception):
            continue
        assert inspect.getdoc(thing), name
