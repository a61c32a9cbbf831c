#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs every stratareeb command that README.md and docs/*.md show: `docs_commands_test.py PROGRAM`.

Shown means: a line in a block fenced as ```sh whose first word is stratareeb or build/stratareeb. The commands of a page
run in order in one empty folder that has the examples in it, and the files that it shows in blocks fenced as ```csv NAME.
They must succeed, or exit as a comment says ("# exits 1").
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent


def shown_commands(page):
    """(command line, expected exit code) in order; a backslash at a line's end joins it with the next."""
    for block in re.findall(r"^```sh\n(.*?)^```", page.read_text(), re.M | re.S):
        for line in block.replace("\\\n", " ").splitlines():
            if re.match(r"(build/)?stratareeb ", line):
                exits = re.search(r"# exits (\d)", line)
                yield line, int(exits[1]) if exits else 0


def run_page(page, program):
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        (place / "examples").symlink_to(ROOT / "examples")
        (place / "build").mkdir()
        (place / "build/stratareeb").symlink_to(program)
        for name, text in re.findall(r"^```csv (\S+)\n(.*?)^```", page.read_text(), re.M | re.S):
            (place / name).write_text(text)
        environment = {**os.environ, "PATH": f"{place / 'build'}:{os.environ['PATH']}"}
        for line, expected in shown_commands(page):
            run = subprocess.run(["bash", "-c", line], cwd=place, env=environment, capture_output=True, text=True,
                                 timeout=600)
            print(f"{page.relative_to(ROOT)}: {line} -> {run.returncode}")
            if run.returncode != expected:
                failures.append(f"{page.relative_to(ROOT)}: {line}\n  exits {run.returncode}, not {expected}\n{run.stderr}")
    return failures


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    pages = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
    if not any(True for page in pages for _ in shown_commands(page)):
        sys.exit("no page shows a command: the pages or this test have changed their way")
    failures = [failure for page in pages for failure in run_page(page, program)]
    print("\n".join(failures), file=sys.stderr)
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
