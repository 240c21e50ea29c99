"""A sweep: how the contact force grows with speed.

Run it with ``python examples/sweep_of_speed.py``; each speed takes a second or two.
"""

from collections.abc import Sequence

import arcless


def main(speeds_km_h: Sequence[float] = (200, 225, 250, 275, 300, 320)) -> list[float]:
    """Run the AC simple line at several speeds; return the standard deviations in N."""
    base = arcless.load("en50318-ac-simple-320")
    print("km/h   Fm N    σ N   σ/Fm  uplift mm")
    deviations = []
    for speed in speeds_km_h:
        # The mean force of the target curve for AC lines, 0.00097 v² + 70 N with v in km/h.
        scenario = base.with_(
            **{"speed": f"{speed} km/h", "pantographs.0.mean_force": 0.00097 * speed**2 + 70}
        )
        assessment = arcless.run(scenario).assessment
        found = assessment.pantographs[0]
        ratio = found.std_force_N / found.mean_force_N
        uplift = assessment.max_uplift_at_support_mm
        print(
            f"{speed:4g}  {found.mean_force_N:5.1f}  {found.std_force_N:5.1f}  {ratio:5.2f}"
            f"  {uplift:9.1f}"
        )
        deviations.append(found.std_force_N)
    return deviations


if __name__ == "__main__":
    main()
