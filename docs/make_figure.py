"""Draw the figure of the README: `python docs/make_figure.py runs/NAME/result.nc FILE.svg`."""

import sys

import matplotlib as mpl
import matplotlib.pyplot as plt

import arcless
from arcless.assess.signals.filter import low_pass


def main(result_file: str, figure_file: str) -> None:
    mpl.rcParams.update({"svg.hashsalt": "arcless", "svg.fonttype": "none", "font.size": 9})
    result = arcless.open(result_file)
    assessment = result.assessment
    dataset = result.dataset.isel(pantograph=0)
    start, end = assessment.section_m
    position, force = dataset["position"].values, dataset["contact_force"].values
    rate = (dataset["time"].size - 1) / float(dataset["time"][-1] - dataset["time"][0])
    smooth = low_pass(force, rate, assessment.low_pass_Hz)
    inside = (position >= start) & (position <= end)

    figure, axes = plt.subplots(figsize=(8.0, 3.0), layout="constrained")
    axes.plot(position[inside], force[inside], color="0.75", lw=0.6, label="contact force")
    label = f"after the {assessment.low_pass_Hz:g} Hz low-pass"
    axes.plot(position[inside], smooth[inside], color="#1f5fa8", lw=1.1, label=label)
    for support in dataset["support_x"].values:
        if start <= support <= end:
            axes.axvline(support, color="0.5", lw=0.5, ls=":")
    axes.axhline(assessment.pantographs[0].mean_force_N, color="#1f5fa8", lw=0.5)
    speed = assessment.speed_m_s * 3.6
    axes.set_ylim(top=1.15 * force[inside].max())  # room for the legend
    axes.set(xlim=(start, end), xlabel="position along the track, m", ylabel="force, N")
    axes.set_title(f"{assessment.scenario}, {speed:.0f} km/h; dotted: supports", loc="left")
    axes.legend(loc="upper right", ncols=2, frameon=False)
    # Without a date and with fixed ids, the same run gives the same file.
    figure.savefig(figure_file, metadata={"Date": None})


if __name__ == "__main__":
    main(*sys.argv[1:])
