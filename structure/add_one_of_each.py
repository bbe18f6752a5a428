#!/usr/bin/env python3
"""Adds one of each kind of thing to a copy of the tree, counts what that touches, builds the copy and tries each.

    structure/add_one_of_each.py COPY            copies, adds and counts: seconds
    structure/add_one_of_each.py COPY --build    builds the copy and tries what was added, with the claims that judge it
                                                 (--all-claims: with all); what includes a changed list is compiled
                                                 anew, the rest comes from ccache where there is one

What is added stands in structure/additions, and kinds.toml there says where each goes. Exit code 1: a kind touches more
than its own files and one entry in one list, or the table of docs/architecture.md knows other kinds, or a try fails.
"""
import argparse
import difflib
import fnmatch
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tomllib

sys.dont_write_bytecode = True

from copied_tree import ADDITIONS, ROOT, Copy, Failure, with_claims, with_entry, with_include, with_source

ALL_HOLD = r"[1-9][0-9]* holds?, 0 refuted, 0 undecided; mutants: ([1-9][0-9]*) of \1 refuted"
CLAIMS = "verification/suites/CMakeLists.txt"


# ---- additions

def keep_claims(copy, kinds):
    """Leaves out of the build the claims of others, which take half of the time."""
    kept = {f"  {kind[key]}" for kind in kinds for key in ("claims", "judged_in") if key in kind}
    lines = copy.text(CLAIMS).split("\n")
    first = lines.index("plumb_claims(suites")
    last = next(i for i in range(first, len(lines)) if lines[i].endswith(")"))
    lines[last] = lines[last][:-1]
    lines[first + 1:last + 1] = [line for line in lines[first + 1:last + 1] if line in kept] + ["  )"]
    copy.change(CLAIMS, "\n".join(lines))


def build_list(path):
    """The CMakeLists.txt that names a source."""
    return CLAIMS if path.startswith("verification/suites/") else f"{path.split('/')[0]}/CMakeLists.txt"


def add(copy, kind):
    """Adds one; gives its own files."""
    own = list(kind.get("files", []))
    if "claims" in kind:
        own.append(f"verification/suites/{kind['claims']}.cpp")
        copy.change(CLAIMS, with_claims(copy.text(CLAIMS), kind["claims"]))
    for path in own:
        copy.add(path)
    if "list" in kind:
        copy.change(kind["list"], with_entry(copy.text(kind["list"]), kind))
        for header in own:
            if kind.get("include") and header.endswith(".h"):
                copy.change(kind["list"], with_include(copy.text(kind["list"]), header))
    for path in sources_of(kind):
        lists = build_list(path)
        copy.change(lists, with_source(copy.text(lists), kind["library"], path[path.index("/") + 1:]))
    return own


def sources_of(kind):
    return [path for path in kind.get("files", []) if path.endswith(".cpp") and "library" in kind]


# ---- counting

def changed_lines(before, after):
    """New lines, the #includes among them apart. Fails where more is lost of a line than what was put in explains."""
    old, new = before.decode().split("\n"), after.decode().split("\n")
    added = []
    for tag, i1, i2, j1, j2 in difflib.SequenceMatcher(None, old, new, autojunk=False).get_opcodes():
        if tag == "equal":
            continue
        added += new[j1:j2]
        grown = " ".join(new[j1:j2])
        for line in old[i1:i2]:
            if not is_within(line, grown):
                raise Failure(f"a line is lost: {line}")
    includes = sum(line.startswith("#include") for line in added)
    return len(added) - includes, includes


def is_within(line, grown):
    """Whether the line is left of another by leaving out what was put in."""
    rest = iter(grown)
    return all(letter in rest for letter in line)


def count(kind, before, copy, own):
    """One row of the table. Fails where more is touched than the own files, a line of one list with an #include, and
    for each .cpp its line of the build."""
    changed = {path for path in copy.files if copy.files[path] != before.get(path)} - set(own)
    expected = {"claims": 1 if "claims" in kind else 0, "build": len(sources_of(kind)), "list": 1 if "list" in kind else 0}
    found = {"claims": 0, "build": 0, "list": 0, "include": 0}
    for path in changed:
        lines, includes = changed_lines(before[path], copy.files[path])
        role = "list" if path == kind.get("list") else "claims" if path == CLAIMS else "build"
        found[role] += lines
        found["include"] += includes
    if found["include"] > 1 or any(found[role] != expected[role] for role in expected):
        raise Failure(f"{kind['name']}: touches {found} lines in {', '.join(sorted(changed))}")
    where = kind.get("list", "none: the folder is the list" if own and not changed else "")
    return [kind["name"], len(own), found["list"], found["include"], found["build"], found["claims"], where]


HEADER = ["kind", "own files", "list", "#include", "CMake", "claims", "the list"]


def print_table(rows):
    rows = [[str(cell) for cell in row] for row in [HEADER] + rows]
    widths = [max(len(row[i]) for row in rows) for i in range(len(HEADER))]
    for row in rows:
        print("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip())


# ---- docs/architecture.md

def rows_of_the_document():
    text = (ROOT / "docs/architecture.md").read_text()
    section = text[text.index("## Where a new one goes"):]
    rows = {}
    for line in section.split("\n"):
        cells = [cell.strip() for cell in line.strip().strip("|").split(" | ")]
        if line.startswith("| ") and not cells[0].startswith("one more"):
            rows[re.split(r":| \(", cells[0])[0]] = cells[1:]
    return rows


def compare_with_document(kinds, left_out):
    rows = rows_of_the_document()
    names = {kind["name"] for kind in kinds}
    for name in sorted(set(rows) - names - set(left_out)):
        raise Failure(f"docs/architecture.md has a row '{name}', of which structure/additions adds none")
    for name in sorted((names | set(left_out)) - set(rows)):
        raise Failure(f"structure/additions knows the kind '{name}', and docs/architecture.md has no row of that name")
    for kind in kinds:
        if "list" not in kind:
            continue
        named = re.findall(r"`([\w/.*{},-]+)`", " ".join(rows[kind["name"]]))
        if not any(fnmatch.fnmatch(kind["list"], name) for name in named) and "the same" not in rows[kind["name"]][1]:
            raise Failure(f"docs/architecture.md does not say that a new {kind['name']} has its line in {kind['list']}")


# ---- building and trying

def run(command, folder, log, environment=None):
    with open(log, "a") as out:
        out.write(f"$ {' '.join(map(str, command))}\n")
        out.flush()
        done = subprocess.run(list(map(str, command)), cwd=folder, stdout=out, stderr=subprocess.STDOUT, env=environment)
    if done.returncode != 0:
        tail = "".join(open(log).readlines()[-40:])
        raise Failure(f"{' '.join(map(str, command))} ended with {done.returncode}; {log} ends\n{tail}")


def built(copy, kinds, all_claims, log, jobs):
    folder = copy.folder / "build/release"
    folder.mkdir(parents=True, exist_ok=True)
    run(["cmake", "--preset", "release"], copy.folder, log)
    for kind in kinds:
        if "generated" in kind:
            target, file = kind["generated"]
            run(["cmake", "--build", folder, "--target", target, "-j", jobs], copy.folder, log)
            program = next(path for path in folder.rglob(target) if path.is_file() and os.access(path, os.X_OK))
            made = subprocess.run([program], capture_output=True, text=True, check=True).stdout
            changed_lines(copy.files[file], made.encode())
            copy.change(file, made)
            copy.write()
    tests = {"structure_test": "structure"}
    if all_claims:  # each feature has one
        tests["suites_test"] = "verification/suites"
    run(["cmake", "--build", folder, "--target", "plumb", *tests, "-j", jobs], copy.folder, log)
    for test, below in tests.items():
        run([folder / below / test], copy.folder, log)
    return folder / "cli/plumb"


def try_each(program, kinds, folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = 0
    for kind in kinds:
        tries = list(kind.get("tries", []))
        if "holds" in kind:
            tries.append([f"verify '{kind['holds']}' --seed 5", ALL_HOLD])
        for arguments, pattern in tries:
            done = subprocess.run([program, *shlex.split(arguments)], cwd=folder, capture_output=True, text=True)
            right = done.returncode == 0 and re.search(pattern, done.stdout)
            failures += not right
            print(f"{kind['name']}: plumb {arguments}: {'works' if right else 'FAILS'}", flush=True)
            if not right:
                print(f"exit code {done.returncode}, and no {pattern!r} in\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    if failures:
        raise Failure(f"{failures} of the additions do not work")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("copy", type=pathlib.Path, help="the folder of the copy; one that is there is brought up to date")
    parser.add_argument("--build", action="store_true", help="build the copy and try what was added")
    parser.add_argument("--all-claims", action="store_true",
                        help="with all claims of the tree, and the test that holds features to them: twice the time")
    parser.add_argument("--jobs", default=str(os.cpu_count()), help="processes of the build")
    options = parser.parse_args()

    with open(ADDITIONS / "kinds.toml", "rb") as file:
        table = tomllib.load(file)
    kinds = table["kind"]
    compare_with_document(kinds, table["left_out"])
    copy = Copy(options.copy.resolve())
    rows, added = [], set()
    for kind in kinds:
        before = dict(copy.files)
        own = add(copy, kind)
        added.update(own)
        rows.append(count(kind, before, copy, own))
    there = {path.relative_to(ADDITIONS).as_posix() for path in ADDITIONS.rglob("*") if path.is_file()}
    if there - added - {"kinds.toml"}:
        raise Failure(f"kinds.toml names no {', '.join(sorted(there - added - {'kinds.toml'}))}")
    if options.build and not options.all_claims:
        keep_claims(copy, kinds)
    copy.write()
    print_table(rows)
    if not options.build:
        return
    log = copy.folder.parent / "build.log"
    log.unlink(missing_ok=True)
    program = built(copy, kinds, options.all_claims, log, options.jobs)
    try_each(program, kinds, copy.folder.parent / "tries")


if __name__ == "__main__":
    try:
        main()
    except Failure as failure:
        sys.exit(f"add_one_of_each: {failure}")
