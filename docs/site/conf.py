# SPDX-License-Identifier: Apache-2.0
"""Configuration of Sphinx for the site. scripts/site stages the sources and names their folder."""
import os
import pathlib
import re

ROOT = pathlib.Path(os.environ["KERF_ROOT"])

project = "Kerf"
author = "the authors of Kerf"
version = re.search(r"VERSION (\d+\.\d+\.\d+)", (ROOT / "CMakeLists.txt").read_text()).group(1)
release = version
language = "en"
# Quotation marks and hyphens of case files and options stay as they are.
smartquotes = False

extensions = ["myst_parser", "sphinx.ext.mathjax", "sphinx_copybutton"]
try:
    import kerf  # noqa: F401  The package is documented where it can be imported.

    extensions += ["sphinx.ext.autodoc", "sphinx.ext.napoleon"]
    autodoc_typehints = "description"
    napoleon_numpy_docstring = True
except ImportError:
    pass

myst_enable_extensions = ["dollarmath"]
myst_dmath_allow_space = False
myst_dmath_double_inline = False
# Links between pages name headings as forges do.
myst_heading_anchors = 4
myst_update_mathjax = False
# A page of the repository may start below the first level.
suppress_warnings = ["myst.header"]

# MathJax is copied into the site; its SVG output needs no fonts, so it works from disk.
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_SVG"
mathjax2_config = {
    "showMathMenu": False,
    "messageStyle": "none",
    "displayAlign": "left",
    "displayIndent": "1em",
    "SVG": {"scale": 85, "linebreaks": {"automatic": True}},
}

# A block of code without a language is plain text.
highlight_language = "none"

html_theme = "furo"
html_title = f"Kerf {version}"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_js_files = ["gallery.js"]
html_copy_source = False
html_show_sourcelink = False
html_show_search_summary = True
html_theme_options = {"navigation_with_keys": True}
pygments_style = "tango"
pygments_dark_style = "native"
