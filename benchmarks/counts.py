"""Instructions of a warm step, a solution and a complementarity problem, counted by callgrind.

    make counts            compare with benchmarks/counts.json
    make counts RENEW=1    write that file: after a change that was meant to change counts

Wall times wobble with the machine, counts do not: the same program on the same kind of processor
repeats them exactly. They are no times: a step is bound by its chain of dependent operations and by
memory. So the data that comes from beyond a first-level cache of 32 KiB is printed beside, as
simulated (64 bytes a line); that depends on where the memory lies, and is not checked.
"""

import argparse
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[1]
STORED = ROOT / "benchmarks" / "counts.json"
CASES = {
    "step-planar": "step, planar, 20 spans",
    "step-spatial": "step, three dimensions, 20 spans",
    "step-explicit-planar": "explicit step, planar, 20 spans, 0.45 m",
    "step-explicit-spatial": "explicit step, three dimensions, 20 spans, 0.45 m",
    "step-forces-given": "step, planar, contact force given",
    "solve-planar": "solution with a ready factor, planar",
    "solve-spatial": "solution, three dimensions",
    "lcp-1": "complementarity, one contact",
    "lcp-8": "complementarity, a contact and seven links",
}
# After a change elsewhere the same compiler may inline a little differently, and the C library
# copies memory as the processor likes best; less than this is not worth a look.
MARGIN = 0.03
# Another compiler optimises otherwise; only what is clearly more work is told then.
OTHER_COMPILER = 0.15
CACHES = ["--cache-sim=yes", "--I1=32768,8,64", "--D1=32768,8,64", "--LL=33554432,16,64"]
LINE = 64  # bytes


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--renew", action="store_true", help="write the stored counts anew")
    renew = parser.parse_args().renew
    missing = unable()
    if missing:
        print(f"make counts: {missing}, so nothing is counted")
        return 0
    program, compiler = build(), version()
    stored = json.loads(STORED.read_text("utf-8")) if STORED.is_file() else {}
    print("work | unknowns | instructions | stored | change | bytes from beyond 32 KiB")
    print("--- | --- | --- | --- | --- | ---")
    counts = {}
    for case, title in CASES.items():
        found = count(program, case)
        counts[case] = found["instructions"]
        before = stored.get("instructions", {}).get(case)
        change = "" if before is None else f"{found['instructions'] / before - 1.0:+.1%}"
        shown = (title, found["unknowns"], found["instructions"], before or "", change)
        print(" | ".join(map(str, (*shown, found["bytes"]))), flush=True)
    if renew:
        text = json.dumps({"compiler": compiler, "instructions": counts}, indent=2)
        STORED.write_text(text + "\n", "utf-8")
        print(f"written: {STORED.relative_to(ROOT)}, {compiler}")
        return 0
    complaints, notes = judge(counts, stored, compiler)
    print("\n".join(complaints + notes))
    return 1 if complaints else 0


def judge(
    counts: dict[str, int], stored: dict[str, Any], compiler: str
) -> tuple[list[str], list[str]]:
    """Return what has become dearer than the margin allows, and what is worth knowing."""
    is_same = stored.get("compiler") == compiler
    margin = MARGIN if is_same else OTHER_COMPILER
    notes = [f"counts may grow by {margin:.0%}"]
    if not is_same:
        notes.append(f"stored with {stored.get('compiler')}, counted with {compiler}")
    complaints = []
    for case, found in counts.items():
        before = stored.get("instructions", {}).get(case)
        if before is None:
            complaints.append(f"{CASES[case]}: no count is stored: make counts RENEW=1")
        elif found > (1.0 + margin) * before:
            complaints.append(
                f"{CASES[case]}: {found} instructions, {before} are stored. Where does the work "
                "come from? If it is meant, say so in the commit and renew: make counts RENEW=1"
            )
        elif found < (1.0 - margin) * before:
            notes.append(f"{CASES[case]} has become cheaper: keep it so: make counts RENEW=1")
    return complaints, notes


def unable() -> str | None:
    """Return why nothing can be counted here."""
    if shutil.which("valgrind") is None:
        return "valgrind is missing"
    try:
        flags = Path("/proc/cpuinfo").read_text("utf-8")
    except OSError:
        flags = ""
    # Kernels choose the widest lanes of the processor, so the counts are of one width.
    return None if " avx2 " in flags else "this processor has other lanes than the stored counts"


def build() -> str:
    """Compile the program, beside what `make build` compiled to share its core; return its path."""
    command = ["cargo", "build", "--release", "--quiet", "--workspace", "--message-format=json"]
    done = subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True)
    artifacts = (json.loads(line) for line in done.stdout.splitlines() if line.startswith("{"))
    return str([a["executable"] for a in artifacts if a.get("executable")][-1])


def version() -> str:
    done = subprocess.run(["rustc", "--version"], check=True, stdout=subprocess.PIPE, text=True)
    return " ".join(done.stdout.split()[:2])


def count(program: str, case: str) -> dict[str, int]:
    """Return unknowns, instructions and bytes from beyond the cache, of one time."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "out"
        tool = ["valgrind", "--quiet", "--tool=callgrind", "--toggle-collect=*counted*"]
        done = subprocess.run(
            [*tool, *CACHES, f"--callgrind-out-file={out}", program, case],
            check=True,
            capture_output=True,
            text=True,
        )
        times, unknowns = map(int, done.stdout.split())
        lines = (line.split() for line in out.read_text("utf-8").splitlines() if ":" in line)
        rows = {words[0]: words[1:] for words in lines if words[0] in ("events:", "summary:")}
    # Zeros at the end are left out of the file.
    events = dict(zip(rows["events:"], map(int, rows["summary:"]), strict=False))
    fetched = LINE * (events.get("D1mr", 0) + events.get("D1mw", 0))
    return {
        "unknowns": unknowns,
        "instructions": round(events["Ir"] / times),
        "bytes": round(fetched / times),
    }


if __name__ == "__main__":
    sys.exit(main())
