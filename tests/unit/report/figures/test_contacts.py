"""Figures of lines with several contact wires, and of pantographs with several contacts."""

import numpy as np

from arcless.assess import assess
from arcless.report.figures import along_track, contacts
from arcless.report.figures.run_data import RunData
from tests.support.synthetic import synthetic_dataset


def test_there_is_none_with_one_contact_each() -> None:
    dataset = synthetic_dataset()
    assert contacts.shares(RunData(dataset, assess(dataset))) is None


def test_each_contact_has_its_line() -> None:
    dataset = synthetic_dataset()
    name = str(dataset["pantograph"].values[0])
    labels = [f"{name} strip 1 wire 1", f"{name} strip 1 wire 2"]
    force = np.column_stack([np.full(dataset.sizes["time"], share) for share in (80.0, 40.0)])
    dataset = dataset.assign_coords(contact=labels)
    dataset["wire_contact_force"] = (("time", "contact"), force)
    figure = contacts.shares(RunData(dataset, assess(dataset)))
    assert figure is not None
    drawn = {r.name: r.data_source.data["y"] for r in figure.renderers if r.name in labels}
    # A low-pass leaves what is constant, to the single precision of a figure.
    for label, share in zip(labels, (80.0, 40.0), strict=True):
        np.testing.assert_allclose(drawn[label], share, rtol=1e-6)


def test_no_line_joins_the_end_of_one_contact_wire_to_the_next() -> None:
    dataset = synthetic_dataset()
    nodes = dataset.sizes["contact_wire_node"]
    number = np.where(np.arange(nodes) < nodes // 2, 1, 2)
    dataset["contact_wire_node_wire"] = (("contact_wire_node",), number)
    figure = along_track.height(RunData(dataset, assess(dataset)))
    rest = figure.renderers[0].data_source.data
    gaps = np.isnan(rest["y"])
    # One behind each of the two wires, and every node is there.
    assert gaps.sum() == 2
    assert gaps.size == nodes + 2
    assert gaps[nodes // 2]
