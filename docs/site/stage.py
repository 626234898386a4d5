#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Stages the sources of the site in a folder: the pages of the repository as they are, in the same places,
and beside them the pages of docs/site with what a build adds to them. scripts/site calls this script.

    docs/site/stage.py INTO [--program KERF] [--no-gallery | --no-runs] [--python]
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys

import furo
import gallery
import headers

SITE = pathlib.Path(__file__).resolve().parent
ROOT = SITE.parents[1]
# What pages link to, apart from docs/.
LINKED = ["python/tutorial.ipynb", "cases", "examples", "CHANGELOG.md", "CONTRIBUTING.md", "LICENSE", "web/README.md"]
MATHJAX = pathlib.Path("/usr/share/javascript/mathjax")
MATHJAX_PARTS = ["MathJax.js", "config/TeX-AMS_SVG.js", "extensions", "jax/element", "jax/input/TeX",
                 "jax/output/SVG", "localization/en"]
NORMALIZE = pathlib.Path("/usr/share/javascript/normalize.css/normalize.css")
TOCTREE = re.compile(r"^```\{toctree\}\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def copy(source, target):
    target.parent.mkdir(parents=True, exist_ok=True)
    if source.is_dir():
        shutil.copytree(source, target, dirs_exist_ok=True)
    else:
        shutil.copy2(source, target)


def complete_theme(into):
    """Replaces files of the Furo of Debian that work from a web server only: its script imports another as a
    module, so that both become one here, and its style sheet imports normalize.css by an address of Debian."""
    theme = pathlib.Path(furo.__file__).parent / "theme/furo/static"
    main, count = re.subn(r"^import Gumshoe .*$", "", (theme / "scripts/furo.js").read_text(),
                          flags=re.MULTILINE)
    if count:
        (into / "scripts").mkdir()
        (into / "scripts/furo.js").write_text((theme / "scripts/gumshoe-patched.js").read_text() + main)
    style = (theme / "styles/furo.css").read_text()
    imported = "url(/javascript/normalize.css/"
    if imported in style:
        copy(NORMALIZE, into / "styles" / NORMALIZE.name)
        (into / "styles/furo.css").write_text(style.replace(imported, "url("))


def copy_mathjax(into, may_be_missing):
    if MATHJAX.exists():
        for name in MATHJAX_PARTS:
            copy(MATHJAX / name, into / name)
    elif may_be_missing:
        print("MathJax is not installed: formulas will be shown as TeX")
        into.mkdir(parents=True)
        (into / MATHJAX_PARTS[0]).touch()
    else:
        sys.exit("MathJax is not installed (scripts/setup site)")


def pages_under(heading):
    """Returns the pages that docs/index.md lists under a heading, as entries of a toctree."""
    text = (ROOT / "docs/index.md").read_text()
    section = text.partition(f"## {heading}\n")[2].partition("\n## ")[0]
    names = re.findall(r"^\| \[[^]]*\]\(([\w/.-]+)\.md\)", section, flags=re.MULTILINE)
    if not names:
        sys.exit(f"docs/index.md has no pages under \"{heading}\"")
    return [f"docs/{name}" for name in names]


def entries_of(text):
    lists = "\n".join(TOCTREE.findall(text)).splitlines()
    return [line for line in lists if line and not line.startswith(":")]


def expanded(entry, layers):
    """Replaces an entry that describes pages by these pages."""
    if entry.startswith("pages under: "):
        return pages_under(entry.removeprefix("pages under: "))
    if entry == "layers of the source":
        return layers
    return [entry]


def page_of(entry):
    """Returns the page of an entry, which may have the form "title <page>"."""
    return re.sub(r".*<(.*)>", r"\1", entry)


def fill_toctrees(into, pages, layers):
    """Writes the toctrees of the pages; what no toctree names goes where docs/site/index.md says."""
    named = {page.stem for page in pages}
    for page in pages:
        for entry in entries_of(page.read_text()):
            named.update(map(page_of, expanded(entry, layers)))
    written = {str(path.relative_to(into).with_suffix("")) for path in into.rglob("*.md")}
    rest = sorted(written - named)

    def lines(found):
        kept = []
        for line in found.group(1).splitlines():
            entries = rest if line == "pages that no list names" else expanded(line, layers)
            kept += [entry for entry in entries
                     if page_of(entry) in written or not entry or entry.startswith(":")]
        return "```{toctree}\n" + "\n".join(kept) + "\n```"

    for page in pages:
        page.write_text(TOCTREE.sub(lines, page.read_text()))


def help_of_commands(program):
    """Yields the help of each command as Markdown."""
    def said(*words):
        return subprocess.run([program, *words, "--help"], check=True, capture_output=True,
                              text=True).stdout.rstrip()

    listed = said().partition("Subcommands:\n")[2]
    for name in re.findall(r"^  (\w+)", listed, flags=re.MULTILINE):
        yield f"\n## kerf {name}\n\n```text\n{said(name)}\n```\n"


def write_formulas(folder):
    """Rewrites blocks of code in the language math, which forges show as formulas, for MyST."""
    for page in folder.rglob("*.md"):
        text = page.read_text()
        page.write_text(re.sub(r"^```math\n(.*?)^```$", lambda found: f"$$\n{found.group(1)}$$", text,
                               flags=re.MULTILINE | re.DOTALL))


def add_to(page, parts):
    page.write_text(page.read_text() + "".join(parts))


def stage(into, options):
    shutil.rmtree(into, ignore_errors=True)
    shutil.copytree(ROOT / "docs", into / "docs", ignore=shutil.ignore_patterns("site"))
    write_formulas(into / "docs")
    for name in LINKED:
        copy(ROOT / name, into / name)
    copy_mathjax(into / "static/mathjax", options.no_gallery)
    copy(SITE / "static", into / "static")
    complete_theme(into / "static")
    copy(SITE / "conf.py", into / "conf.py")
    pages = []
    for source in sorted(SITE.glob("*.md")):
        if source.stem == "python" and not options.python:
            continue
        # docs/site/ is two folders below the root, the staged page is at the root.
        text = source.read_text().replace("](../../", "](").replace("](../", "](docs/")
        (into / source.name).write_text(text)
        pages.append(into / source.name)
    runs = None if options.no_gallery else gallery.Runs(ROOT, options.program, not options.no_runs)
    add_to(into / "gallery.md", gallery.sections(ROOT, runs, into / "static/runs"))
    if options.program:
        add_to(into / "commands.md", help_of_commands(options.program))
    layers = headers.write_pages(ROOT, into / "cpp")
    fill_toctrees(into, pages, layers)


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("into", type=pathlib.Path)
    arguments.add_argument("--program", help="the program; without it there is no help of commands")
    arguments.add_argument("--no-gallery", action="store_true", help="a gallery without pictures")
    arguments.add_argument("--no-runs", action="store_true", help="only the runs that are in out/")
    arguments.add_argument("--python", action="store_true", help="the Python package can be imported")
    options = arguments.parse_args()
    stage(options.into, options)


if __name__ == "__main__":
    main()
