"""A copy of the tree, and lists in its files that get one more entry."""
import os
import pathlib
import re
import shutil
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent
ADDITIONS = ROOT / "structure/additions"
PASSED_OVER = {".git", "build", "out", "node_modules", "__pycache__"}


class Failure(Exception):
    """What is wrong, in a sentence for the user."""


def tree():
    """The paths of the sources, below the root: what git knows or would add, or else all but what is built."""
    if shutil.which("git"):
        listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT,
                                capture_output=True, text=True)
        if listed.returncode == 0 and listed.stdout:
            return sorted(path for path in listed.stdout.split("\0") if path and (ROOT / path).is_file())
    found = []
    for folder, folders, files in os.walk(ROOT):
        folders[:] = [name for name in folders if name not in PASSED_OVER]
        found += [os.path.relpath(os.path.join(folder, name), ROOT) for name in files]
    return sorted(found)


class Copy:
    """The tree with changes, in memory until it is written: a file that stays the same keeps its time."""

    def __init__(self, folder):
        self.folder = folder
        self.original = {path: (ROOT / path).read_bytes() for path in tree()}
        self.files = dict(self.original)

    def text(self, path):
        if path not in self.files:
            raise Failure(f"{path}: there is no such file")
        return self.files[path].decode()

    def change(self, path, text):
        self.files[path] = text.encode()

    def add(self, path):
        """One of structure/additions."""
        if path in self.files:
            raise Failure(f"{path} is there already")
        if not (ADDITIONS / path).is_file():
            raise Failure(f"structure/additions/{path}: there is no such file")
        self.files[path] = (ADDITIONS / path).read_bytes()

    def write(self):
        """Writes what differs, and removes what an earlier copy had and this one has not."""
        self.folder.mkdir(parents=True, exist_ok=True)
        manifest = self.folder.with_name(self.folder.name + ".files")
        for path in manifest.read_text().splitlines() if manifest.is_file() else []:
            if path not in self.files:
                (self.folder / path).unlink(missing_ok=True)
        manifest.write_text("\n".join(self.files))
        for path, content in self.files.items():
            file = self.folder / path
            if file.is_file() and file.read_bytes() == content:
                continue
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(content)
            shutil.copymode(ROOT / path if path in self.original else ADDITIONS / path, file)
        modules, linked = ROOT / "reports/page/node_modules", self.folder / "reports/page/node_modules"
        if modules.exists() and not linked.exists():
            linked.symlink_to(modules)


def with_entry(text, kind):
    """The text of the kind's list with one entry more."""
    after = text.find(kind["after"])
    before = text.find(kind["before"], after + len(kind["after"]))
    if after < 0 or before < 0:
        raise Failure(f"{kind['list']}: no list between {kind['after']!r} and {kind['before']!r}")
    return text[:before] + kind["entry"] + text[before:]


def with_include(text, header):
    """In its place among the last group of quoted includes."""
    lines = text.split("\n")
    last = max(i for i, line in enumerate(lines) if line.startswith('#include "'))
    first = last
    while first > 0 and lines[first - 1].startswith('#include "'):
        first -= 1
    line = f'#include "{header}"'
    at = next((i for i in range(first, last + 1) if lines[i] > line), last + 1)
    return "\n".join(lines[:at] + [line] + lines[at:])


def with_source(text, after, source):
    """In its place among the lines of a list of sources."""
    lines = text.split("\n")
    first = next((i for i, line in enumerate(lines) if line.startswith(after)), None)
    if first is None:
        raise Failure(f"no list begins with {after!r}")
    at = first + 1
    while re.fullmatch(r"  [\w/.]+", lines[at]) and lines[at] < f"  {source}":
        at += 1
    return "\n".join(lines[:at] + [f"  {source}"] + lines[at:])


def with_claims(text, claims):
    """Behind the last claims of the same method: the list is in the order of the report."""
    lines = text.split("\n")
    first = lines.index("plumb_claims(suites")
    last = next(i for i in range(first, len(lines)) if lines[i].endswith(")"))
    method = f"  {claims.split('/')[0]}/"
    at = max((i for i in range(first, last) if lines[i].startswith(method)), default=first) + 1
    return "\n".join(lines[:at] + [f"  {claims}"] + lines[at:])
