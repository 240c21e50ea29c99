"""The C interface from C and from Python: steps of the loop, messages, the header."""

import ctypes
import math
import re
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import arcless
from arcless.fmi import copy_library, export_model
from arcless.model import Scenario

EXAMPLE = Path(__file__).parents[4] / "examples" / "loop" / "bench.c"


@pytest.fixture(scope="module")
def bench(scenario: Scenario, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with a model, the library and its header."""
    folder = tmp_path_factory.mktemp("bench")
    copy_library(folder)
    export_model(scenario, folder / "line.loop")
    return folder


def swinging(time: float) -> float:
    return 120.0 + 40.0 * math.sin(20.0 * time)


def test_the_example_in_c_takes_the_steps_of_the_loop(scenario: Scenario, bench: Path) -> None:
    compiler = shutil.which("cc")
    if compiler is None:
        pytest.skip("no C compiler here")
    subprocess.run(
        [
            *(compiler, "-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-O2", "-I."),
            *(str(EXAMPLE), "-L.", "-larcless_loop", "-Wl,-rpath,$ORIGIN", "-lm", "-o", "bench"),
        ],
        cwd=bench,
        check=True,
    )
    done = subprocess.run(
        ["./bench", "line.loop", "1500"], cwd=bench, check=True, capture_output=True, text=True
    )
    heights = [float(text) for text in re.findall(r"(\S+) m$", done.stdout, re.MULTILINE)]
    loop = arcless.realtime(scenario)
    h, expected = loop.time_step_s, []
    for step in range(1500):
        loop.step(swinging(step * h))
        if (step + 1) % 500 == 0:
            expected.append(float(loop.height_m[0]))
    # The sine of C and that of Python may differ in the last bit, which the line does not enlarge.
    assert heights == pytest.approx(expected, abs=1e-12)
    assert len(heights) == 3
    missing = subprocess.run(
        ["./bench", "none.loop", "1"], cwd=bench, check=False, capture_output=True, text=True
    )
    assert missing.returncode == 1
    assert missing.stderr.startswith("`none.loop`: ")


# Counts what is allocated between the first and the last of many steps; a program's own `malloc`
# stands before that of the C library for every library that it loads.
COUNTING = r"""
#include <stdio.h>
#include <stdlib.h>
#include "arcless_loop.h"
extern void *__libc_malloc(size_t), *__libc_calloc(size_t, size_t), *__libc_realloc(void *, size_t);
static long counted;
void *malloc(size_t n) { counted++; return __libc_malloc(n); }
void *calloc(size_t n, size_t m) { counted++; return __libc_calloc(n, m); }
void *realloc(void *p, size_t n) { counted++; return __libc_realloc(p, n); }
int main(int count, char **words) {
    char text[300];
    arcless_loop *device = arcless_loop_open(ARCLESS_LOOP_VERSION, words[count - 1], text, 300);
    if (!device || counted == 0) return 1;
    unsigned int n = arcless_loop_count(device), numbers[500];
    double values[500];
    for (unsigned int i = 0; i < n; i++) numbers[i] = i;
    counted = 0;
    for (int step = 0; step < 500; step++) {
        if (arcless_loop_get(device, numbers, values, n)) return 2;
        if (arcless_loop_set(device, numbers + 1, values + 1, 1)) return 3;
        if (arcless_loop_step(device)) return 4;
    }
    printf("%ld\n", counted);
    return 0;
}
"""


@pytest.mark.parametrize(
    "choice",
    [{}, {"given": "strip-height"}, {"given": "control-force"}, {"pantograph": "P1"}],
    ids=repr,
)
def test_steps_allocate_nothing(scenario: Scenario, bench: Path, choice: dict[str, Any]) -> None:
    compiler = shutil.which("cc")
    if compiler is None:
        pytest.skip("no C compiler here")
    (bench / "counting.c").write_text(COUNTING, "utf-8")
    export_model(scenario, bench / "counted.loop", **choice)
    words = ("-O1", "-I.", "counting.c", "-L.", "-larcless_loop", "-Wl,-rpath,$ORIGIN")
    subprocess.run([compiler, *words, "-o", "counting"], cwd=bench, check=True)
    done = subprocess.run(
        ["./counting", "counted.loop"], cwd=bench, check=True, capture_output=True, text=True
    )
    assert done.stdout == "0\n"


@pytest.fixture
def library(bench: Path) -> Any:
    """Return the library with the types of its functions."""
    found = ctypes.CDLL(str(bench / "libarcless_loop.so"))
    pointer, number, text = ctypes.c_void_p, ctypes.c_uint, ctypes.c_char_p
    found.arcless_loop_open.restype = pointer
    for name in ("name", "unit", "description", "message"):
        getattr(found, f"arcless_loop_{name}").restype = text
    found.arcless_loop_step_length.restype = ctypes.c_double
    found.arcless_loop_find.restype = number
    return found


def opened(library: Any, path: Path, version: int = 1) -> tuple[Any, str]:
    message = ctypes.create_string_buffer(300)
    found = library.arcless_loop_open(version, str(path).encode(), message, 300)
    return (ctypes.c_void_p(found) if found else None), message.value.decode()


@pytest.fixture
def line(library: Any, bench: Path) -> Iterator[Any]:
    found, message = opened(library, bench / "line.loop")
    assert message == ""
    yield found
    library.arcless_loop_close(found)


def values(library: Any, line: Any, *numbers: int) -> list[float]:
    out = (ctypes.c_double * len(numbers))()
    asked = (ctypes.c_uint * len(numbers))(*numbers)
    assert library.arcless_loop_get(line, asked, out, ctypes.c_size_t(len(numbers))) == 0
    return list(out)


def put(library: Any, line: Any, number: int, value: float) -> int:
    given = ctypes.c_double(value)
    asked = ctypes.c_uint(number)
    return int(
        library.arcless_loop_set(line, ctypes.byref(asked), ctypes.byref(given), ctypes.c_size_t(1))
    )


def test_variables_are_described(library: Any, line: Any) -> None:
    force = library.arcless_loop_find(line, b"P1.contact_force")
    assert library.arcless_loop_name(line, force) == b"P1.contact_force"
    assert library.arcless_loop_unit(line, force) == b"N"
    assert b"Contact force" in library.arcless_loop_description(line, force)
    assert library.arcless_loop_role(line, force) == 1
    assert library.arcless_loop_role(line, 0) == 0
    assert library.arcless_loop_find(line, b"nothing") == 0xFFFFFFFF
    assert library.arcless_loop_name(line, 10_000) is None
    assert library.arcless_loop_role(line, 10_000) == -1
    assert library.arcless_loop_count(line) > force


def test_failures_have_a_code_and_a_message(library: Any, line: Any, bench: Path) -> None:
    force = library.arcless_loop_find(line, b"P1.contact_force")
    assert put(library, line, force, math.nan) == 2
    assert b"`P1.contact_force` is NaN at t = 0 s" in library.arcless_loop_message(line)
    speed = library.arcless_loop_find(line, b"speed")
    assert put(library, line, speed, 1e6) == 0
    assert library.arcless_loop_step(line) == 4
    assert b"`P1` is at" in library.arcless_loop_message(line)
    assert put(library, line, speed, 80.0) == 0
    assert library.arcless_loop_step(line) == 0
    assert values(library, line, 0) == [library.arcless_loop_step_length(line)]
    assert library.arcless_loop_step(None) == 2
    assert library.arcless_loop_get(line, None, None, ctypes.c_size_t(1)) == 2
    other, message = opened(library, bench / "line.loop", version=2)
    assert other is None
    assert "version 2 of the interface, the library has 1" in message


def test_states_are_saved_and_restored(library: Any, line: Any) -> None:
    size = ctypes.c_size_t()
    height = library.arcless_loop_find(line, b"P1.wire_height")
    assert library.arcless_loop_save(line, None, ctypes.c_size_t(0), ctypes.byref(size)) == 0
    room = ctypes.create_string_buffer(size.value)
    assert library.arcless_loop_save(line, room, ctypes.c_size_t(5), ctypes.byref(size)) == 1
    assert b"5 bytes for a state of" in library.arcless_loop_message(line)
    assert library.arcless_loop_save(line, room, size, ctypes.byref(size)) == 0
    before = values(library, line, height)
    assert library.arcless_loop_step(line) == 0
    after = values(library, line, height)
    assert library.arcless_loop_restore(line, room, size) == 0
    assert values(library, line, height) == before != after
    assert library.arcless_loop_step(line) == 0
    assert values(library, line, height) == after
    assert library.arcless_loop_reset(line) == 0
    assert values(library, line, height) == before


def test_the_header_has_every_function_and_no_other(library: Any, bench: Path) -> None:
    header = (bench / "arcless_loop.h").read_text("utf-8")
    declared = set(re.findall(r"\b(arcless_loop_\w+)\(", header))
    source = Path(__file__).parents[4] / "crates" / "ffi" / "src" / "c.rs"
    text = source.read_text("utf-8")
    defined = set(re.findall(r'extern "C" fn (arcless_loop_\w+)\(', text))
    defined |= set(re.findall(r"^    (arcless_loop_\w+): \w+;$", text, re.MULTILINE))
    assert declared == defined
    assert all(hasattr(library, name) for name in declared)
    assert f"#define ARCLESS_LOOP_VERSION {library.arcless_loop_version()}u" in header
