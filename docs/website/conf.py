"""Configuration of Sphinx for the copies of pages that `build.py` makes."""

import sys
from pathlib import Path
from typing import Any

from docutils import nodes
from docutils.utils.math.latex2mathml import tex2mathml
from pygments.lexers.special import TextLexer
from sphinx.application import Sphinx

import arcless

HERE = Path(__file__).parent
sys.path.append(str(HERE))

project = "Arcless"
author = "the authors of Arcless"
copyright = author
version = release = arcless.__version__
language = "en"

extensions = [
    "myst_nb",
    "sphinx.ext.autodoc",
    "numpydoc",
    "sphinx_copybutton",
]
root_doc = "index"
smartquotes = False  # options begin with two hyphens
highlight_language = "none"  # equations are indented text
nitpicky = True
# Names in backticks in docstrings are links where they are public names, and code elsewhere.
default_role = "py:obj"
# Without a network, types of other packages have no pages; nor has a module inside of a package.
nitpick_ignore_regex = [("py:obj", r".*"), ("py:.*", r"(?!arcless\b).*|arcless(\.\w+){3,}")]

myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
myst_dmath_double_inline = False
suppress_warnings = ["myst.header"]  # generated pages begin where others end

nb_execution_mode = "cache"
nb_execution_in_temp = True
# A cell that fails is a warning with its traceback; `build.py` takes every warning for an error.
nb_execution_raise_on_error = False
nb_execution_timeout = 300
nb_merge_streams = True
nb_execution_show_tb = True

autodoc_typehints = "none"  # docstrings have them
autodoc_member_order = "bysource"
autodoc_preserve_defaults = True
numpydoc_show_class_members = False
numpydoc_xref_param_type = False
add_module_names = False
python_use_unqualified_type_names = True
python_maximum_signature_line_length = 88

html_theme = "pydata_sphinx_theme"
html_title = f"Arcless {version}"
html_static_path = [str(HERE / "static")]
html_css_files = ["site.css"]
html_show_sourcelink = False
html_copy_source = False
html_context = {"default_mode": "auto"}
html_math_renderer = "mathml"
html_theme_options: dict[str, Any] = {
    "header_links_before_dropdown": 6,
    "navbar_align": "left",
    "navbar_end": ["theme-switcher"],
    "show_toc_level": 2,
    "navigation_with_keys": False,
    "show_prev_next": False,
    "footer_start": ["copyright"],
    "footer_end": [],
    "secondary_sidebar_items": ["page-toc"],
}
html_sidebars = {"sources/**": []}
copybutton_prompt_text = r">>> |\.\.\. |\$ "
copybutton_prompt_is_regexp = True


def inline_math(translator: Any, node: nodes.math) -> None:
    """Write a formula in a line as MathML, which browsers draw without a script."""
    translator.body.append(tex2mathml(node.astext(), as_block=False))
    raise nodes.SkipNode


def block_math(translator: Any, node: nodes.math_block) -> None:
    """Write a formula of its own as MathML."""
    translator.body.append(f'<div class="formula">{tex2mathml(node.astext(), as_block=True)}</div>')
    raise nodes.SkipNode


def setup(app: Sphinx) -> None:
    """Register what pages need besides the extensions."""
    app.add_html_math_renderer("mathml", (inline_math, None), (block_math, None))
    app.add_lexer("csv", TextLexer)
