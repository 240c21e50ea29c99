"""Model files: validated lines, pantographs and scenarios, and the shipped library."""

from arcless.model.advice.advice import line_warnings, scenario_warnings
from arcless.model.as_built.as_built import AsBuilt, DropperLengthError, Ice, Wear, Wind
from arcless.model.as_built.gusts import Gusts
from arcless.model.fields.document import MARKS, Provenance
from arcless.model.json_schema import json_schema
from arcless.model.line.line import Line
from arcless.model.line.parts.components import (
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
from arcless.model.line.parts.geometry import DesignSpace, Geometry
from arcless.model.line.parts.spans import SpanDroppers, SpanRun, SpanType
from arcless.model.line.parts.tension_lengths import Overlap, TensionLength
from arcless.model.line.parts.track import Curve, Track
from arcless.model.load import load, load_any, load_line, load_pantograph
from arcless.model.pantograph.pantograph import Pantograph, PantographMass
from arcless.model.pantograph.placement import PantographPlacement
from arcless.model.scenario.overrides import parse_override
from arcless.model.scenario.scenario import Scenario
from arcless.model.scenario.scenario_data import Analysis, Travel
from arcless.model.settings.run_settings import Contact, Output, Solver, SpeedProfile
from arcless.model.settings.schemes import (
    GeneralisedAlpha,
    HilberHughesTaylor,
    Newmark,
    Trapezoidal,
)
from arcless.model.shipped.library import LibraryEntry, ModelRenamed, library

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
