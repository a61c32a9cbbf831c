#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lints of the source tree, each a ctest test: `lint.py includes|text|format|tidy [--build DIR] [--tests] [--record]`.

includes  rooms include only along the arrows that docs/architecture.md draws; headers keep heavy libraries out
text      a licence line first, headers guarded, no link of a page broken, nothing left to do, no long script in the 3D page
format    clang-format 14 would change nothing
tidy      clang-tidy 14 has nothing to say. It takes seconds a file, so files that passed are remembered by content (their own,
          their headers' and the checks') in DIR/tidy, and by --record in scripts/tidy_passed.txt, for fresh clones.
          --tests: of tests too
"""
import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
ROOMS = ["boreholes", "mesh", "reeb", "subdivision", "io", "apps", "tests", "bench"]
UNBOUND = {"tests", "bench"}  # may include any room

# What a header of a room may name besides our own and the standard library (which has no dot in its names).
PUBLIC_LIBRARIES = re.compile(r"OpenMesh/")
EXTRA_LIBRARIES = {"io": re.compile(r"fmt/|nlohmann/json_fwd"), "apps": re.compile(r"CLI/|fmt/|nlohmann/"),
                   "tests": re.compile(""), "bench": re.compile("")}

TIDY_PASSED = ROOT / "scripts/tidy_passed.txt"  # key of the content and file, a line each

LONGEST_SCRIPT = 320  # lines of a .js file in viewer/

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def sources(*suffixes):
    """Our files with these suffixes, relative to the root, sorted."""
    found = [p.relative_to(ROOT) for room in ROOMS for p in (ROOT / room).rglob("*") if p.suffix in suffixes]
    return sorted(found)


def includes_of(path):
    """(line number, quoted?, name) of each include directive."""
    for number, line in enumerate((ROOT / path).read_text().splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match[1] == '"', match[2]


def drawn_arrows():
    """room -> the rooms it may include, by the arrows `a --> b` of docs/architecture.md, followed to their ends."""
    text = (ROOT / "docs/architecture.md").read_text()
    direct = {room: set() for room in ROOMS}
    for start, end in re.findall(r"^\s*(\w+) --> (\w+)\s*$", text, re.M):
        direct[start].add(end)
    allowed = {}
    for room in ROOMS:
        reached, todo = {room}, [room]
        while todo:
            for end in direct[todo.pop()] - reached:
                reached.add(end)
                todo.append(end)
        if room in reached - {room} or any(room in allowed.get(r, ()) for r in reached - {room}):
            sys.exit(f"docs/architecture.md: the arrows from {room} lead back to it")
        allowed[room] = set(ROOMS) if room in UNBOUND else reached
    return allowed


def check_include(path, number, quoted, name, allowed):
    room = path.parts[0]
    if quoted:
        if not (ROOT / name).is_file():
            return f'{path}:{number}: "{name}" is not a file of the tree; includes are written from its root'
        target = name.split("/")[0]
        if target not in allowed[room]:
            return f"{path}:{number}: {room} includes {name}, but no arrow of docs/architecture.md leads there"
        return None
    is_standard = "." not in name and "/" not in name
    extra = EXTRA_LIBRARIES.get(room)
    if path.suffix == ".h" and not (is_standard or PUBLIC_LIBRARIES.match(name) or (extra and extra.match(name))):
        return f"{path}:{number}: <{name}> in a header; heavy libraries stay in .cpp files"
    return None


def lint_includes(_):
    allowed = drawn_arrows()
    problems = []
    for path in sources(".h", ".cpp"):
        found = list(includes_of(path))
        problems += [p for p in (check_include(path, *include, allowed) for include in found) if p]
        own = path.with_suffix(".h")
        if path.suffix == ".cpp" and (ROOT / own).is_file() and (not found or found[0][2] != str(own)):
            problems.append(f'{path}:1: the first include is not "{own}", the header of this file')
    return problems


def broken_links(path, lines):
    """Links of a page to files that are not there."""
    for number, line in enumerate(lines, 1):
        for link in re.findall(r"\]\(([^)#]+)", line):
            if "://" not in link and not (ROOT / path.parent / link).exists():
                yield f"{path}:{number}: {link} is not there"


def lint_text(_):
    unfinished = re.compile(r"\b(TO" r"DO|FIX" r"ME|X" r"XX)\b")
    problems = []
    scripts = [p.relative_to(ROOT) for pattern in ("*.sh", ".ci/*", "scripts/*.py", "scripts/*.sh", "cmake/*.cmake",
                                                   "**/CMakeLists.txt") for p in ROOT.glob(pattern)]
    scripts = [p for p in scripts if not p.parts[0].startswith("build")]
    documents = [p.relative_to(ROOT) for p in [*ROOT.glob("*.md"), *ROOT.glob("docs/*.md"),
                                                  *ROOT.glob("examples/**/*.md")]]
    page = [p.relative_to(ROOT) for pattern in ("*.js", "src/*.js", "src/*.css", "tests/*/*.js", "tests/*.sh")
            for p in (ROOT / "viewer").glob(pattern)]
    for path in [*sources(".h", ".cpp", ".py", ".cmake"), *sorted(scripts), *sorted(page), *sorted(documents)]:
        lines = (ROOT / path).read_text().splitlines()
        if path.suffix != ".md" and not any("SPDX-License-Identifier: GPL-3.0-or-later" in l for l in lines[:2]):
            problems.append(f"{path}:1: no line SPDX-License-Identifier: GPL-3.0-or-later at the top")
        if path.suffix == ".h" and "#pragma once" not in lines:
            problems.append(f"{path}:1: no #pragma once")
        problems += [f"{path}:{n}: {line.strip()}" for n, line in enumerate(lines, 1) if unfinished.search(line)]
        if path.suffix == ".js" and len(lines) > LONGEST_SCRIPT:
            problems.append(f"{path}: {len(lines)} lines, more than {LONGEST_SCRIPT}; a second story gets its own file")
        if path.suffix == ".md":
            problems += broken_links(path, lines)
    return problems


def tool(name):
    """Version 14 of a clang tool: other versions format and judge differently."""
    for candidate in (f"{name}-14", name):
        if shutil.which(candidate):
            text = subprocess.run([candidate, "--version"], capture_output=True, text=True, check=True).stdout
            if re.search(r"version 14\.", text):
                return candidate
    sys.exit(f"{name} 14 is missing: apt-get install {name}-14")


def lint_format(_):
    files = [str(p) for p in sources(".h", ".cpp")]
    run = subprocess.run([tool("clang-format"), "--dry-run", *files], cwd=ROOT, capture_output=True, text=True)
    changed = sorted({l.split(":")[0] for l in run.stderr.splitlines() if "warning: code should be" in l})
    return [f"{path}: clang-format -i would change this file" for path in changed]


def with_own_headers(path, seen):
    """A source and every header of ours that it reads, directly or not."""
    if path not in seen:
        seen.add(path)
        for _, quoted, name in includes_of(path):
            if quoted and (ROOT / name).is_file():
                with_own_headers(pathlib.Path(name), seen)
    return sorted(seen)


def content_key(path):
    digest = hashlib.sha256((ROOT / ".clang-tidy").read_bytes())
    for part in with_own_headers(path, set()):
        digest.update(str(part).encode() + (ROOT / part).read_bytes())
    return digest.hexdigest()[:32]


def tidy_one(path, build):
    """What clang-tidy says of one source, each line as `file:line:column: text [check]`.

    clang 14 cannot parse some of libstdc++ 12's ranges; what it says of such places as a compiler is g++'s matter.
    """
    run = subprocess.run([tool("clang-tidy"), "--quiet", "-p", str(build), str(path)], cwd=ROOT, capture_output=True,
                         text=True)
    said = [l.replace(f"{ROOT}/", "") for l in run.stdout.splitlines() if re.search(r": (error|warning): ", l)]
    if run.returncode != 0 and not said:
        return [f"{path}: {run.stderr.strip()}"]
    return [l for l in said if "[clang-diagnostic-error]" not in l]


def tidied_sources(args):
    """Sources that the build compiles and clang-tidy is to look at, with the key of their content."""
    rooms = [room for room in ROOMS if room != "tests" or args.tests]
    entries = json.loads((args.build / "compile_commands.json").read_text())
    paths = sorted({pathlib.Path(os.path.relpath(entry["file"], ROOT)) for entry in entries})
    return [(path, content_key(path)) for path in paths if path.parts[0] in rooms]


def lint_tidy(args):
    remembered = args.build / "tidy"
    remembered.mkdir(exist_ok=True)
    recorded = set(TIDY_PASSED.read_text().split()) if TIDY_PASSED.is_file() else set()
    files = tidied_sources(args)
    work = [(path, key) for path, key in files if key not in recorded and not (remembered / key).exists()]
    problems = []
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for (path, key), said in zip(work, pool.map(lambda w: tidy_one(w[0], args.build), work)):
            problems += said
            if not said:
                (remembered / key).touch()
    if args.record and not problems:
        TIDY_PASSED.write_text("".join(f"{key} {path}\n" for path, key in files))
    return sorted(set(problems))


def main():
    lints = {"includes": lint_includes, "text": lint_text, "format": lint_format, "tidy": lint_tidy}
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("lint", choices=lints)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build")
    parser.add_argument("--tests", action="store_true", help="tidy: look at tests too, which takes as long again")
    parser.add_argument("--record", action="store_true", help="tidy: write scripts/tidy_passed.txt if nothing was found")
    args = parser.parse_args()
    args.build = args.build.resolve()
    problems = lints[args.lint](args)
    for problem in problems:
        print(problem)
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
