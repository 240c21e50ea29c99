"""Studies: one scenario mapped over many variants, from two cores to a cluster."""

from arcless.study.folder import StudyFolder
from arcless.study.keeper import Progress
from arcless.study.load import execution, is_study, load
from arcless.study.model import Execution, Study
from arcless.study.optimise import Optimise
from arcless.study.run import run
from arcless.study.schema import json_schema
from arcless.study.status import StudyStatus, status

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
    "run",
    "status",
]
