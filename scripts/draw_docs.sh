#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Draws the pictures of README and docs with the program itself. Run it after a change that shows in them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

build/stratareeb build examples/sighthill/intervals.csv --collars examples/sighthill/collars.csv --formats png --quiet -o "$folder/sighthill"
build/stratareeb build examples/thesis_sample3.csv --formats png --quiet -o "$folder/thesis"
for name in sighthill thesis; do
    cp "$folder/$name/model.png" "docs/images/$name.png"
done
