# SPDX-License-Identifier: Apache-2.0
"""Writes a page for each layer of src/: the contract at the head of each header, and what it declares."""
import collections
import json
import re
import shutil
import subprocess


def layers(root):
    """Yields (layer, description) in the order of the table of docs/flow.md."""
    table = (root / "docs/flow.md").read_text()
    yield from re.findall(r"^\| `src/(\w+)/` \| ([^|]*?) \|", table, flags=re.MULTILINE)


def contract_of(text):
    """Returns the comment at the head of a header, without the line of the licence."""
    lines = []
    for line in text.splitlines():
        if not line.startswith("//"):
            break
        if "SPDX-License-Identifier" not in line:
            lines.append(line[2:].removeprefix(" "))
    return "\n".join(lines).strip("\n")


def declared(root):
    """Returns the types and functions of namespace kerf by header, as Universal Ctags finds them."""
    names = collections.defaultdict(dict)
    if not shutil.which("ctags"):
        return names
    listing = subprocess.run(
        ["ctags", "--options=NONE", "--language-force=C++", "--kinds-C++=csgupft", "--fields=+KsZ",
         "--sort=no", "--output-format=json", "-I", "KERF_FUNCTION,KERF_FORMULA", "-f", "-",
         *sorted(str(path.relative_to(root)) for path in (root / "src").rglob("*.hpp"))],
        check=True, capture_output=True, text=True, cwd=root)
    for entry in map(json.loads, listing.stdout.splitlines()):
        if entry.get("scope") == "kerf" and not entry["name"].startswith("__anon"):
            call = "()" if entry["kind"] in ("function", "prototype") else ""
            names[entry["path"]][entry["name"] + call] = None
    return names


def page_of(root, layer, description, names):
    yield f"# src/{layer}\n\nThis layer has {description}.\n"
    for path in sorted((root / "src" / layer).rglob("*.hpp")):
        name = str(path.relative_to(root))
        yield f"\n## {name.removeprefix('src/')}\n"
        contract = contract_of(path.read_text())
        if contract:
            yield f"\n```text\n{contract}\n```\n"
        if names.get(name):
            yield "\nDeclares " + ", ".join(f"`{entry}`" for entry in names[name]) + ".\n"


def write_pages(root, into):
    """Writes the pages and returns their names as entries of a toctree."""
    into.mkdir(parents=True)
    names = declared(root)
    entries = []
    for layer, description in layers(root):
        (into / f"{layer}.md").write_text("".join(page_of(root, layer, description, names)))
        entries.append(f"{into.name}/{layer}")
    return entries
