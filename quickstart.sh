#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# From a fresh clone to layer solids: installs what the build needs, builds the program, runs it on the shipped
# boreholes of Sighthill, Glasgow, and says what it made.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

echo "== packages"
scripts/install_packages.sh build
echo "== program"
tests=()
[ -f build/CMakeCache.txt ] || tests=(-DSTRATAREEB_BUILD_TESTS=OFF)  # a build that test.sh made stays as it is
mkdir -p build
cmake --preset release "${tests[@]}" >build/configure.log 2>&1 || { cat build/configure.log; exit 1; }
cmake --build build --target stratareeb
echo "== boreholes to layers"
build/stratareeb build examples/sighthill/intervals.csv --collars examples/sighthill/collars.csv \
    --formats ply,stl,glb,step,mlp,png -o out --overwrite

cat <<'END'

Done. In out/:
  layers/*.ply      one watertight solid for each layer, 01 = top
  horizons/*.ply    the surfaces between them, 00 = ground
  model.mlp         all of it as a MeshLab project:   meshlab out/model.mlp
  model.step        named, coloured solids for CAD:   freecad out/model.step
  model.png         a picture of it
  model.glb         for any glTF viewer
  model.json        volumes, areas, thickness, checks
Your own boreholes:   build/stratareeb build TABLE -o DIR      (docs/boreholes.md says what a table looks like)
END
