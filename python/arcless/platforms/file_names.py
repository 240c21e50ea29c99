"""Names of files that Windows does not take: a project may go from one system to another.

Source: Microsoft, "Naming Files, Paths, and Namespaces".
"""

import re

# Devices, whatever ending follows, also behind blanks; the digits may be superscripts.
_DEVICE = re.compile(
    r"(con|prn|aux|nul|conin\$|conout\$|(com|lpt)[0-9\u00b9\u00b2\u00b3]) *(\..*)?", re.IGNORECASE
)
_FORBIDDEN = re.compile(r'[<>:"/\\|?*\x00-\x1f]')


def refused_by_windows(name: str) -> str | None:
    """Return why Windows has no file of a name; None where it may have one.

    Parameters
    ----------
    name
        The name, without folders.
    """
    if _DEVICE.fullmatch(name):
        return f"`{name.partition('.')[0].rstrip()}`, the name of a device on Windows"
    if name.endswith((".", " ")):
        return f"a {'dot' if name.endswith('.') else 'blank'} at the end, which Windows leaves out"
    found = _FORBIDDEN.search(name)
    return f"{found[0]!r}, which Windows has in no name" if found else None
