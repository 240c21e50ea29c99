"""Names of the wires."""

CONTACT, MESSENGER = "contact wire", "messenger wire"
STITCH, AUXILIARY = "stitch wire", "auxiliary wire"
BRIDLE = "bridle"
# Two of them side by side.
TWINS = ("contact wire 1", "contact wire 2")
