"""Studies: one scenario mapped over many variants, from two cores to a cluster."""

from arcless.study.definition.json_schema import json_schema
from arcless.study.definition.load import execution, is_study, load, load_text
from arcless.study.definition.study import Execution, Study
from arcless.study.folder.folder import StudyFolder
from arcless.study.folder.row_writer import Progress
from arcless.study.folder.started_studies import open_study as open
from arcless.study.folder.status import StudyStatus, status
from arcless.study.optimisation.optimise import Optimise
from arcless.study.run import run

__all__ = [
    "Execution",
    "Optimise",
    "Progress",
    "Study",
    "StudyFolder",
    "StudyStatus",
    "execution",
    "is_study",
    "json_schema",
    "load",
    "load_text",
    "open",
    "run",
    "status",
]
