# SPDX-License-Identifier: Apache-2.0
"""Writes the sections of the gallery: every case with its text and, where there is a run, a moving picture.

A run is taken from out/NAME, where `kerf run` puts it by default. Of the cases in MADE, each of which takes
seconds to two minutes on two free cores, missing runs are made first. A run that is not finished is left alone.
"""
import html
import json
import re
import shutil
import subprocess
import sys

GROUPS = [("machine", "Cuts from the setting of a machine"), ("cuts", "Real cuts"),
          ("", "Jets, solids and water")]
MADE = ["tilted-plate", "foam-30mpa", "tofu-5ms", "tofu-5ms-standard", "tofu-50ms", "column-on-wall",
        "nozzle-funnel", "nozzle-slit", "rod-impact"]
REPORT_LIMIT = 12e6  # bytes; a larger report is left out


class Case:
    """The text of a case file: name, title, sentence, and the paragraphs of the comment at its head."""

    def __init__(self, path):
        text = path.read_text()
        head = re.match(r"(?:#.*\n)*", text).group()
        self.path, self.name = path, path.stem
        self.sentence = re.match(r"# [\w-]+: (.*)", head).group(1)
        self.title = re.search(r'^title = "(.*)"', text, flags=re.MULTILINE).group(1)
        flat = re.sub(r"\n# {6,}", " ", head)
        self.facts = re.findall(r"^# (Source|Expected|Run time) +(.*)", flat, flags=re.MULTILINE)


class Runs:
    """Finds finished runs in out/, and makes those of MADE if it may."""

    def __init__(self, root, program, make):
        self.root, self.program, self.make = root, program, make

    def call(self, *words):
        done = subprocess.run([self.program, *words], cwd=self.root, capture_output=True, text=True)
        if done.returncode:
            print(f"gallery: kerf {' '.join(words)} failed: {done.stderr[-300:]}", file=sys.stderr)
        return done.returncode == 0

    def folder_of(self, case):
        """Returns the folder of the finished run of a case, with its movie, or None."""
        folder = self.root / "out" / case.name
        result = folder / "result.json"
        if not folder.exists() and self.make and self.program and case.name in MADE:
            print(f"gallery: running {case.name}", flush=True)
            self.call("run", str(case.path), "--out", str(folder), "--quiet")
        if not result.exists():
            return None
        movie = folder / "movie.mp4"
        if self.program and (not movie.exists() or movie.stat().st_mtime < result.stat().st_mtime):
            print(f"gallery: movie of {case.name}", flush=True)
            self.call("report", str(folder), "--movie")
        return folder


def pictures_of(case, folder, into):
    """Copies movie and report of a run beside the site and returns the HTML that shows them."""
    into.mkdir(parents=True, exist_ok=True)
    verdict = html.escape(json.loads((folder / "result.json").read_text())["verdict"])
    parts = []
    movie, report = folder / "movie.mp4", folder / "report.html"
    stills = sorted((folder / "pictures").glob("*.png"))
    if movie.exists():
        shutil.copy2(movie, into / f"{case.name}.mp4")
        parts.append(f'<video class="run" controls loop muted playsinline preload="metadata" '
                     f'src="_static/runs/{case.name}.mp4" title="{html.escape(case.sentence)}"></video>')
    elif stills:
        shutil.copy2(stills[-1], into / f"{case.name}.png")
        parts.append(f'<img src="_static/runs/{case.name}.png" alt="{html.escape(case.sentence)}">')
    parts.append(f"<p><b>Result of the run.</b> {verdict}")
    if report.exists() and report.stat().st_size < REPORT_LIMIT:
        shutil.copy2(report, into / f"{case.name}.html")
        parts.append(f'<a href="_static/runs/{case.name}.html">Interactive report</a>')
    parts.append("</p>")
    return "\n".join(parts)


def section(case, folder, into):
    yield f"\n### {case.title}\n\n`{case.name}`: {case.sentence}.\n"
    if folder:
        yield f"\n```{{raw}} html\n{pictures_of(case, folder, into)}\n```\n"
    for name, text in case.facts:
        yield f"\n**{name}.** {text}\n"
    yield f"\n```sh\nkerf new {case.name} > my.toml\nkerf run my.toml --out out/{case.name}\n```\n"
    where = case.path.parent.name
    place = f"cases/{where}/" if where != "cases" else "cases/"
    yield f"\nThe file: [{case.path.name}]({place}{case.path.name})\n"


def sections(root, runs, into):
    """Yields the Markdown of all cases, in each group those with a run first."""
    for group, heading in GROUPS:
        yield f"\n## {heading}\n"
        cases = [Case(path) for path in sorted((root / "cases" / group).glob("*.toml"))]
        found = [(case, runs and runs.folder_of(case)) for case in cases]
        for case, folder in sorted(found, key=lambda pair: not pair[1]):
            yield from section(case, folder, into)
