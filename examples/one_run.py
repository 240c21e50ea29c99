"""One run: the reference case, its numbers, its report.

Run it with ``python examples/one_run.py``; it takes a few seconds and writes into ``runs/``.
"""

from pathlib import Path

import arcless


def main(folder: Path = Path("runs/one-run")) -> arcless.Result:
    """Run AC simple at 320 km/h, print what was found, save result and report."""
    result = arcless.run(arcless.load("en50318-ac-simple-320"))

    assessment = result.assessment
    pantograph = assessment.pantographs[0]
    print(f"mean force          {pantograph.mean_force_N:6.1f} N")
    print(f"standard deviation  {pantograph.std_force_N:6.1f} N")
    print(f"uplift at supports  {assessment.max_uplift_at_support_mm:6.1f} mm")
    for criterion in assessment.criteria:
        verdict = {True: "met", False: "missed", None: "not judged"}[criterion.passed]
        print(f"{criterion.name}: {verdict}")

    # The dataset is an ordinary xarray dataset: names, units, selection by label.
    force = result.dataset["contact_force"].sel(pantograph="P1")
    print(f"{force.long_name}, unfiltered: {float(force.min()):.1f} to {float(force.max()):.1f} N")

    folder.mkdir(parents=True, exist_ok=True)
    result.save(folder / "result.nc")
    result.write_report(folder / "report.html")
    return result


if __name__ == "__main__":
    main()
