#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Gives the program changed files: cases, meshes, folders of runs, checkpoints, studies.

Whatever the bytes, every command must end within 20 s, with one of the exit codes of
docs/results.md and not 70, and where it refuses, with a message that names a file or folder.

  fuzz_program.py build/release/kerf --runs 1000 [--kind report] [--seed 1] [--keep FOLDER]
"""
import argparse
import collections
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import zlib

CASE = """title = "A small block"
dimension = {dimension}
[time]
end = "0.4 ms"
[[body]]
name = "block"
material = "tofu"
{body}
spacing = "2 mm"
[[jet]]
name = "jet"
speed = "5 m/s"
{size} = "4 mm"
position = {place}
standoff = "2 mm"
spacing = "2 mm"
[output]
frame_interval = "0.2 ms"
picture_times = ["0.4 ms"]
series_interval = "0.02 ms"
"""
FLAT = CASE.format(dimension=2, size="width", place='["0 mm", "6 mm"]',
                   body='shape = { type = "box", minimum = ["-8 mm", "0 mm"], maximum = ["8 mm", "6 mm"] }')
SOLID = CASE.format(dimension=3, size="diameter", place='["3 mm", "6 mm", "3 mm"]',
                    body='shape = { type = "mesh", file = "part.obj", scale = "1 mm" }')
STUDY = """base = "small.toml"
metrics = ["kerf.depth"]
[vary]
"jet.jet.speed" = { from = "2 m/s", to = "10 m/s", count = 2 }
[design]
type = "grid"
"""
CUBE = """v 0 0 0
v 6 0 0
v 0 6 0
v 6 6 0
v 0 0 6
v 6 0 6
v 0 6 6
v 6 6 6
f 1 3 4 2
f 5 6 8 7
f 1 2 6 5
f 3 7 8 4
f 1 5 7 3
f 2 4 8 6
"""
ALLOWED = {0, 1, 3, 4}
WORDS = [b"", b"-1", b"0", b"1e308", b"-1e-308", b"nan", b"null", b"[]", b"{}", b'""', b"true", b"\xff\xfe", b"[" * 400,
         b"18446744073709551616", b"2147483648", b'"9 mm"', b"\0", b"\n", b'"', b"../", b"%d%s"]


def changed(random_numbers, content):
    """Returns the bytes after one to four random changes."""
    content = bytearray(content)
    for _ in range(random_numbers.choice((1, 1, 1, 2, 4))):
        size = len(content)
        place = random_numbers.randrange(size + 1)
        kind = random_numbers.randrange(9)
        if kind == 0 and size:
            content[min(place, size - 1)] ^= 1 << random_numbers.randrange(8)
        elif kind == 1 and size:
            content[min(place, size - 1)] = random_numbers.choice((0, 1, 0x7f, 0x80, 0xff))
        elif kind == 2:
            del content[place:]
        elif kind == 3:
            del content[place:place + random_numbers.randrange(64)]
        elif kind == 4:
            content[place:place] = content[place:place + random_numbers.randrange(256)]
        elif kind == 5:
            content[place:place + random_numbers.randrange(8)] = random_numbers.choice(WORDS)
        elif kind >= 7:  # another digit, which often leaves a case that is accepted
            digits = [digit.start() for digit in re.finditer(rb"[0-9]", bytes(content[:1 << 16]))]
            if digits:
                content[random_numbers.choice(digits)] = random_numbers.choice(b"0123456789")
        else:  # another value at the place of a number or text
            values = list(re.finditer(rb'-?[0-9][0-9.e+-]*|"[^"\n]*"', bytes(content[:1 << 16])))
            if values:
                value = random_numbers.choice(values)
                content[value.start():value.end()] = random_numbers.choice(WORDS)
    return bytes(content)


def sealed(content):
    """Returns a changed checkpoint with the checksum of its bytes, so that the change is read."""
    seal = re.search(rb"\nkerf [a-z]+, version [ 0-9]+, crc32 [0-9a-f]{8}\n$", content)
    if not seal:
        return content
    return content[:-9] + b"%08x\n" % zlib.crc32(content[:seal.start()])


class Trials:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        self.base = folder / "base"
        self.base.mkdir()
        (self.base / "small.toml").write_text(FLAT)
        (self.base / "solid.toml").write_text(SOLID)
        (self.base / "part.obj").write_text(CUBE)
        (self.base / "study.toml").write_text(STUDY)
        for words in (["check", "solid.toml"], ["run", "small.toml", "--out", "run", "--threads", "1", "--quiet"],
                      ["run", "small.toml", "--out", "other", "--threads", "1", "--quiet"],
                      ["study", "study.toml", "--out", "study", "--jobs", "1", "--quiet"]):
            code, text = self.call(self.base, *words)
            if code:
                sys.exit(f"without a change, kerf {' '.join(words)} ends with {code}: {text}")
        (self.base / "run/report.html").unlink()

    def call(self, folder, *words):
        done = subprocess.run([self.program, *words], cwd=folder, capture_output=True, timeout=20, check=False)
        return done.returncode, (done.stdout + done.stderr).decode(errors="replace")

    # Each kind: the files of which one is changed, and the command.
    KINDS = {
        "check": (["small.toml", "solid.toml"], None),
        "mesh": (["part.obj"], ["check", "solid.toml", "--no-timing"]),
        "report": (["run/case.used.toml", "run/result.json", "run/series.csv", "run/*.series", "run/frames/*",
                    "run/pictures/*", "run/checkpoint.h5"], ["report", "run"]),
        "compare": (["run/case.used.toml", "run/result.json", "run/series.csv"], ["report", "other", "--compare", "run"]),
        "resume": (["run/checkpoint.h5", "run/series.csv", "run/case.used.toml"],
                   ["run", "small.toml", "--out", "run", "--threads", "1", "--resume", "--quiet"]),
        "study": (["study.toml", "small.toml", "study/study.db", "study/runs/*.toml", "study/runs/*.txt"],
                  ["study", "study.toml", "--out", "study", "--jobs", "1", "--quiet"]),
    }

    def one(self, kind, random_numbers, seals):
        """Returns what is wrong with the answer, or nothing; the folder `trial` holds the changed files."""
        trial = self.folder / "trial"
        shutil.rmtree(trial, ignore_errors=True)
        shutil.copytree(self.base, trial)
        patterns, words = self.KINDS[kind]
        file = random_numbers.choice([name for pattern in patterns for name in sorted(trial.glob(pattern))])
        content = changed(random_numbers, file.read_bytes())
        file.write_bytes(sealed(content) if seals else content)
        words = words or ["check", file.name, "--no-timing"]
        try:
            code, text = self.call(trial, *words)
        except subprocess.TimeoutExpired:
            return file, "hang", ""
        if code not in ALLOWED or "internal error" in text:
            return file, f"exit code {code}", text
        if code != 0 and not re.search(r"\.(toml|json|csv|h5|vtkhdf|series|obj|db|png|html|txt)|study/runs|run failed", text):
            return file, f"no file named with exit code {code}", text
        return file, "", str(code)

    def of_kind(self, kind, options):
        """Makes the trials of a kind, prints what they find, and returns the number of defects."""
        codes, found = collections.Counter(), 0
        for number in range(options.runs):
            random_numbers = random.Random(f"{options.seed} {kind} {number}")
            file, problem, text = self.one(kind, random_numbers, not options.no_seal)
            codes[problem or f"exit code {text}"] += 1
            if not problem:
                continue
            found += 1
            print(f"{kind} {number}, {file.relative_to(self.folder)}: {problem}\n{text[-600:]}", flush=True)
            if options.keep:
                shutil.copytree(self.folder / "trial", options.keep / f"{kind}-{number}", dirs_exist_ok=True)
        print(f"{kind}: " + ", ".join(f"{count} {what}" for what, count in sorted(codes.items())), flush=True)
        return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=lambda text: str(pathlib.Path(text).resolve()))
    parser.add_argument("--runs", type=int, default=200, help="of each kind")
    parser.add_argument("--kind", action="append", choices=list(Trials.KINDS))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--no-seal", action="store_true", help="leave the checksum of a changed file as it was")
    parser.add_argument("--keep", type=pathlib.Path, help="folder for the folders of failures")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="kerf-fuzz-") as name:
        trials = Trials(options.program, pathlib.Path(name))
        found = sum(trials.of_kind(kind, options) for kind in options.kind or Trials.KINDS)
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
