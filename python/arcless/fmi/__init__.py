"""Lines and pantographs for other programs: FMUs, and models of the C interface.

The Functional Mock-up Interface (Modelica Association, fmi-standard.org) is how programs hand one
another models: an FMU is a zip archive with a description, a library and data.
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from arcless.fmi.export.export import Export, export_fmu, export_model
    from arcless.fmi.export.library import copy_library

__all__ = ["Export", "copy_library", "export_fmu", "export_model"]


def __getattr__(name: str) -> Any:
    """Import a name at its first use."""
    from arcless.fmi.export import export, library

    if name not in __all__:
        raise AttributeError(f"module `{__name__}` has no attribute `{name}`")
    value = getattr(library if name == "copy_library" else export, name)
    globals()[name] = value
    return value
