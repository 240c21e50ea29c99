"""Functions that wine 8 lacks and packages of Python call: libraries that have them, for tests.

Wine stands in for Windows here, and Debian 12 has wine 8. Its C library has neither complex numbers
(`crealf` …, which NumPy calls) nor parts of <fenv.h> (HDF5), and it has no `bcryptprimitives.dll`
(Rust's standard library). Copies of the packages are made to call libraries that have them, by
names of the same length; whatever else they call, these hand on. On Windows none of this is needed.
"""

import re
from pathlib import Path

from cross.toolchain import need, run
from cross.toolchain import text_of as said_by

# Library of Windows → name of ours, of the same length.
_MATH = ("api-ms-win-crt-math-l1-1-0.dll", "arcless-crt-math-shim-0000.dll")
_RUNTIME = ("api-ms-win-crt-runtime-l1-1-0.dll", "arcless-crt-runtime-shim-0000.dll")
_PARTS = {"abs", "arg", "imag", "real"}
_COMPLEX = re.compile(r"c(abs|arg|imag|real)(f|l|)|c(?:atan|cosh?|exp|log|sinh?|sqrt|tanh?)(f|)")
# `fenv_t` of Windows: two numbers. Exceptions of arithmetic are never seen then.
_FENV = {
    "feclearexcept": "int my_feclearexcept(int e) { (void)e; return 0; }",
    "fetestexcept": "int my_fetestexcept(int e) { (void)e; return 0; }",
    "feholdexcept": "int my_feholdexcept(unsigned long *e) { e[0] = e[1] = 0; return 0; }",
    "fesetenv": "int my_fesetenv(const unsigned long *e) { (void)e; return 0; }",
}
_RANDOM = """#include <windows.h>
BOOLEAN NTAPI SystemFunction036(PVOID, ULONG);
__declspec(dllexport) BOOL WINAPI ProcessPrng(PBYTE to, SIZE_T size)
{ return SystemFunction036(to, (ULONG)size); }
"""


def complete(site: Path, program: Path) -> None:
    """Give packages in a folder what wine lacks, by libraries next to the program."""
    files = [path for path in site.rglob("*") if path.suffix in (".pyd", ".dll")]
    for (windows, ours), made in ((_MATH, _complex), (_RUNTIME, _FENV.get)):
        users = [path for path in files if windows.encode() in path.read_bytes()]
        if windows == _RUNTIME[0]:  # all packages call it, and one of them more than wine has
            users = [path for path in users if b"feholdexcept" in path.read_bytes()]
        names = sorted({name for path in users for name in _imported(path, windows)})
        own = {name: text for name in names if (text := made(name)) is not None}
        lines = [
            f"  {name} = {f'my_{name}' if name in own else f'ucrtbase.{name}'}" for name in names
        ]
        exported = "\n".join([f"LIBRARY {ours}", "EXPORTS", *lines])
        _library(program / ours, "\n".join(["#include <complex.h>", *own.values()]), exported)
        for path in users:
            path.write_bytes(path.read_bytes().replace(windows.encode(), ours.encode()))
    put_random_numbers(program)
    (program / "_wmi.pyd").unlink(missing_ok=True)  # asks what wine does not answer


def put_random_numbers(folder: Path) -> None:
    """Write the library with random numbers that Rust's standard library calls."""
    folder.mkdir(parents=True, exist_ok=True)
    _library(folder / "bcryptprimitives.dll", _RANDOM, None)


def _complex(name: str) -> str | None:
    """Return a function of complex numbers in C; None for one of real numbers."""
    if name in ("_Cbuild", "_FCbuild", "_LCbuild"):
        real = "float" if name == "_FCbuild" else "double"
        return f"{real} complex my_{name}({real} a, {real} b) {{ return a + b * I; }}"
    if name in ("cpow", "cpowf"):
        real = "float" if name == "cpowf" else "double"
        both = f"{real} complex a, {real} complex b"
        return f"{real} complex my_{name}({both}) {{ return {name}(a, b); }}"
    found = _COMPLEX.fullmatch(name)
    if found is None:
        return None
    real = "float" if "f" in (found[2], found[3]) else "double"  # a long double is one there
    result = real if found[1] in _PARTS else f"{real} complex"
    called = name[:-1] if found[2] == "l" else name
    return f"{result} my_{name}({real} complex z) {{ return {called}(z); }}"


def _imported(path: Path, library: str) -> list[str]:
    """Return the names that a file imports from a library."""
    listed = said_by(
        need("x86_64-w64-mingw32-objdump", "binutils-mingw-w64-x86-64"), "-p", str(path)
    )
    parts = listed.split("DLL Name: ")[1:]
    return [
        line.split()[-1]
        for part in parts
        if part.startswith(library)
        for line in part.splitlines()[1:]
        if re.match(r"\t[0-9a-f]+\s", line)
    ]


def _library(target: Path, source: str, exported: str | None) -> None:
    code, names = target.with_suffix(".c"), target.with_suffix(".def")
    code.write_text(source, "utf-8")
    names.write_text(exported or "", "utf-8")
    compiler = need("x86_64-w64-mingw32-gcc", "gcc-mingw-w64-x86-64")
    given = [str(code), *([str(names)] if exported else [])]
    run(compiler, "-O2", "-shared", "-static", "-o", str(target), *given, "-ladvapi32")
