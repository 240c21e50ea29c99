"""Model files: validated lines, pantographs and scenarios, and the shipped library."""

from arcless.model.advice import line_warnings, scenario_warnings
from arcless.model.as_built import AsBuilt, DropperLengthError, Ice, Wear, Wind
from arcless.model.components import (
    AuxiliaryWire,
    DropperType,
    MessengerSupport,
    Rayleigh,
    SteadyArm,
    SteadyArmBar,
    SteadyArmSpring,
    StitchWire,
    Wire,
)
from arcless.model.documents import MARKS, Provenance
from arcless.model.geometry import DesignSpace, Geometry
from arcless.model.gusts import Gusts
from arcless.model.library import LibraryEntry, ModelRenamed, library
from arcless.model.line import Line
from arcless.model.load import load, load_any, load_line, load_pantograph
from arcless.model.overrides import parse_override
from arcless.model.pantograph import Pantograph, PantographMass
from arcless.model.placement import PantographPlacement
from arcless.model.scenario import Analysis, Scenario, Travel
from arcless.model.schema import json_schema
from arcless.model.schemes import GeneralisedAlpha, HilberHughesTaylor, Newmark, Trapezoidal
from arcless.model.settings import Contact, Output, Solver, SpeedProfile
from arcless.model.spans import SpanDroppers, SpanRun, SpanType
from arcless.model.tension_lengths import Overlap, TensionLength
from arcless.model.track import Curve, Track

__all__ = [
    "MARKS",
    "Analysis",
    "AsBuilt",
    "AuxiliaryWire",
    "Contact",
    "Curve",
    "DesignSpace",
    "DropperLengthError",
    "DropperType",
    "GeneralisedAlpha",
    "Geometry",
    "Gusts",
    "HilberHughesTaylor",
    "Ice",
    "LibraryEntry",
    "Line",
    "MessengerSupport",
    "ModelRenamed",
    "Newmark",
    "Output",
    "Overlap",
    "Pantograph",
    "PantographMass",
    "PantographPlacement",
    "Provenance",
    "Rayleigh",
    "Scenario",
    "Solver",
    "SpanDroppers",
    "SpanRun",
    "SpanType",
    "SpeedProfile",
    "SteadyArm",
    "SteadyArmBar",
    "SteadyArmSpring",
    "StitchWire",
    "TensionLength",
    "Track",
    "Trapezoidal",
    "Travel",
    "Wear",
    "Wind",
    "Wire",
    "json_schema",
    "library",
    "line_warnings",
    "load",
    "load_any",
    "load_line",
    "load_pantograph",
    "parse_override",
    "scenario_warnings",
]
