#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of docs/validate.md: every interpolator at held-out boreholes of each data set, side by side.

    scripts/compare_interpolators.py build/stratareeb NAME=TABLE ... [--seeds 1,2,3] [--interpolators all]

For each table: ten folds with each seed. RMSE over all seeds as a share of that of `linear`, geometric mean over the layers that
30 held-out holes or more know; coverage of 95 % intervals and half their width as a share of linear's; horizons that cross. Options of
`validate` go after the table, with commas between: sighthill=intervals.csv,--collars,collars.csv
"""
import argparse
import json
import math
import subprocess
import sys
from collections import defaultdict

LEAST_HOLES = 30


def validate(program, table, interpolators, seed):
    command = [program, "validate", *table.split(","), "--interpolator", interpolators,
               "--seed", str(seed), "--json", "--quiet"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}\n{done.stderr}")
    return json.loads(done.stdout)


class Item:
    """One quantity by one interpolator, over seeds."""

    def __init__(self):
        self.squares = self.inside_squares = self.count = self.inside_count = self.covered = self.width = 0

    def add(self, found):
        count, inside = found["count"], found["inside"]
        self.squares += count * found["rmse"] ** 2
        self.inside_squares += inside["count"] * inside["rmse"] ** 2
        self.count += count
        self.inside_count += inside["count"]
        self.covered += count * found["interval"]["coverage"]
        self.width += count * found["interval"]["mean_half_width"]

    def rmse(self):
        return math.sqrt(self.squares / self.count)


def collect(program, table, interpolators, seeds):
    items, names, crossings, holes = defaultdict(Item), [], defaultdict(int), 0
    for seed in seeds:
        report = validate(program, table, interpolators, seed)
        holes = report["boreholes"]
        for result in report["interpolators"]:
            name = result["interpolator"]
            if name not in names:
                names.append(name)
            crossings[name] += result["crossings"]
            for quantity in ("layers", "horizons"):
                for number, found in enumerate(result.get(quantity, [])):
                    if found["count"] > 0 and not (quantity == "horizons" and number == 0):
                        items[name, quantity, number, found["name"]].add(found)
    return items, names, crossings, holes


def ratios(items, names, seeds, quantity):
    logs = defaultdict(list)
    for (name, kind, number, title), item in items.items():
        linear = items["linear", kind, number, title]
        if kind == quantity and item.count >= LEAST_HOLES * len(seeds) and linear.squares > 0:
            logs[name].append(math.log(item.rmse() / linear.rmse()))
    return {name: math.exp(sum(logs[name]) / len(logs[name])) for name in names if logs[name]}


def row(*cells):
    print("| " + " | ".join(str(cell) for cell in cells) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("tables", nargs="+", metavar="NAME=TABLE")
    parser.add_argument("--seeds", default="1,2,3")
    parser.add_argument("--interpolators", default="all", help="with commas between; linear must be among them")
    parser.add_argument("--layers", help="also list each layer by this interpolator")
    options = parser.parse_args()
    seeds = [int(seed) for seed in options.seeds.split(",")]
    everything, logs, coverage, crossed = {}, defaultdict(list), defaultdict(list), defaultdict(int)
    for number, table in enumerate(options.tables):
        title, path = table.split("=", 1)
        items, names, crossings, holes = collect(options.program, path, options.interpolators, seeds)
        everything[title] = items
        if number == 0:
            row("set", "holes", "", *(f"`{name}`" for name in names))
            row(*["---"] * (3 + len(names)))
        for quantity, word in (("layers", "thickness"), ("horizons", "elevation")):
            found = ratios(items, names, seeds, quantity)
            if not found:
                continue
            best = min(found.values())
            row(title, holes, word, *(f"**{found[n]:.2f}**" if found[n] <= best + 0.005 else f"{found[n]:.2f}" for n in names))
            for name in names:
                logs[name].append(math.log(found[name]))
        for name in names:
            crossed[name] += crossings[name]
            own = [item for key, item in items.items() if key[0] == name]
            coverage[name].append(sum(i.covered for i in own) / sum(i.count for i in own))
        sys.stdout.flush()
    row("all", "", "geometric mean", *(f"{math.exp(sum(logs[n]) / len(logs[n])):.3f}" for n in names))
    row("95 % intervals cover, %", "", "least to most",
        *(f"{100 * min(coverage[n]):.1f}–{100 * max(coverage[n]):.1f}" for n in names))
    row("horizons that cross", "", "", *(crossed[n] for n in names))
    if options.layers:
        print()
        row("set", "", "held out", "RMSE, linear", f"RMSE, {options.layers}", "share", "covered, %", "± / RMSE")
        row(*["---"] * 8)
        for title, items in everything.items():
            for (name, kind, number, layer), item in items.items():
                if name != options.layers:
                    continue
                linear = items["linear", kind, number, layer]
                row(title, layer if kind == "horizons" else "thickness of " + layer, item.count // len(seeds),
                    f"{linear.rmse():.4g}", f"{item.rmse():.4g}",
                    f"{item.rmse() / linear.rmse():.2f}" if linear.squares > 0 else "",
                    f"{100 * item.covered / item.count:.1f}", f"{item.width / item.count / item.rmse():.2f}" if item.squares > 0 else "")


if __name__ == "__main__":
    main()
