"""Pages of the public names in Python: one for `arcless`, one for each public package."""

import inspect
from importlib import import_module
from typing import Any

import arcless

PAGE = "reference/python.md"
FOLDER = "reference/python"
# Public packages whose names all stand at the top.
AT_THE_TOP = {"errors"}


def pages() -> dict[str, str]:
    """Return the page of each package, and the list of them for the page on Python."""
    packages = [name for name in arcless.__all__ if inspect.ismodule(getattr(arcless, name))]
    own = [name for name in arcless.__all__ if name not in packages and name != "__version__"]
    homes = {id(getattr(arcless, name)): name for name in own}
    made = {f"{FOLDER}/arcless.md": _page("arcless", own, {})}
    for package in packages:
        module = import_module(f"arcless.{package}")
        names = list(getattr(module, "__all__", ()))
        if package not in AT_THE_TOP:
            made[f"{FOLDER}/arcless.{package}.md"] = _page(f"arcless.{package}", names, homes)
    rows = [f"- [`{name}`](python/{name}.md): {_first_line(name)}" for name in map(_module, made)]
    entries = [f"python/{_module(path)}" for path in made]
    table = ["```{toctree}", ":hidden:", "", *entries, "```"]
    return made | {PAGE: "\n".join(["## Packages", "", *rows, "", *table, ""])}


def _module(path: str) -> str:
    return path.removeprefix(f"{FOLDER}/").removesuffix(".md")


def _first_line(name: str) -> str:
    text = (import_module(name).__doc__ or "").strip()
    return " ".join(text.partition("\n\n")[0].split())


def _page(module: str, names: list[str], homes: dict[int, str]) -> str:
    """Return the page of a package; what stands at the top as well is linked, not repeated."""
    found = import_module(module)
    above = [name for name in names if id(getattr(found, name)) in homes]
    parts = [f"# {module}\n", "```{eval-rst}", f".. py:module:: {module}\n"]
    parts += ["```\n", f"{inspect.cleandoc(found.__doc__ or '')}\n" if module != "arcless" else ""]
    if above:
        links = (f"[`arcless.{homes[id(getattr(found, n))]}`](arcless.md)" for n in above)
        parts.append(f"Also here: {', '.join(links)}.\n")
    kinds = {"Functions": [], "Classes": [], "Constants": []}
    for name in sorted(set(names) - set(above), key=str.lower):
        thing = getattr(found, name)
        kind = "Classes" if inspect.isclass(thing) else "Constants"
        kinds["Functions" if inspect.isroutine(thing) else kind].append(_entry(name, thing))
    for title, entries in kinds.items():
        if entries:
            body = "\n".join([f".. currentmodule:: {module}\n", *entries])
            parts += [f"## {title}\n", "```{eval-rst}", body, "```\n"]
    return "\n".join(parts)


def _entry(name: str, thing: Any) -> str:
    if not inspect.isclass(thing):
        return f".. auto{'function' if inspect.isroutine(thing) else 'data'}:: {name}\n"
    lines = [f".. autoclass:: {name}"]
    methods = [n for n in vars(thing) if not n.startswith("_") and _is_shown(thing, n)]
    if methods:
        lines.append(f"   :members: {', '.join(methods)}")
    return "\n".join([*lines, ""])


def _is_shown(cls: type, name: str) -> bool:
    """Return whether a member is a method or property with words of its own."""
    member = inspect.getattr_static(cls, name)
    callables = (staticmethod, classmethod, property)
    if not (inspect.isfunction(member) or isinstance(member, callables)):
        return False
    return bool(getattr(member, "__doc__", None))
