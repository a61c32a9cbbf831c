#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Draws the pictures of README and docs with the program itself. Run it after a change that shows in them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

draw() {  # NAME TABLE [OPTION…]
    local name=$1
    shift
    build/stratareeb build "$@" --formats png --quiet -o "$folder/$name" >/dev/null
    cp "$folder/$name/model.png" "docs/images/$name.png"
}

draw sighthill examples/sighthill/intervals.csv --collars examples/sighthill/collars.csv
build/stratareeb validate examples/sighthill/intervals.csv --collars examples/sighthill/collars.csv --plots png --quiet \
    -o "$folder/validation" >/dev/null
cp "$folder/validation/residual_map.png" docs/images/validate_sighthill.png
draw thesis examples/thesis_sample3.csv
build/stratareeb sample -o "$folder/wells.csv" --holes 52 --layers 3 --pinch-outs >/dev/null
draw sample "$folder/wells.csv"

build/stratareeb build examples/sighthill/wide_noheader.csv --quiet -o "$folder/glasgow" >/dev/null
build/stratareeb reeb "$folder/glasgow/layers/02_2.ply" --simplify 0.02 -o docs/images/reeb.png --overwrite >/dev/null

for graph in examples/graphs/*.json; do
    build/stratareeb reconstruct "$graph" -o "$folder/surface.ply" --overwrite \
        --picture "docs/images/graph_$(basename "$graph" .json).png" >/dev/null
done
build/stratareeb reconstruct examples/st_helens/contours.json -o "$folder/surface.ply" --overwrite \
    --picture docs/images/st_helens.png >/dev/null
build/stratareeb build examples/sighthill/intervals.csv --collars examples/sighthill/collars.csv --quiet \
    -o "$folder/fence" >/dev/null
build/stratareeb section "$folder/fence" --through GBH06,GBH02,GBH01,GBH03 -o docs/images/section.png --overwrite \
    --title "Sighthill, a fence through four boreholes" >/dev/null
build/stratareeb section "$folder/fence" --at-z 46 -o docs/images/level.png --overwrite >/dev/null
build/stratareeb map "$folder/fence" --show thickness --unit clay -o docs/images/map.png --overwrite >/dev/null
for levels in 0 2; do  # before and after smoothing, side by side in docs/smooth_layers.md
    build/stratareeb build examples/thesis_sample3.csv --refine $levels --quiet -o "$folder/smooth_$levels" >/dev/null
    build/stratareeb section "$folder/smooth_$levels" --along 0,0,318,283 --exaggeration 1.5 --overwrite \
        -o "docs/images/smooth_layers_$levels.png" --title "--refine $levels" >/dev/null
done
build/stratareeb refine examples/meshes/bracket.obj -o "$folder/bracket.ply" --levels 4 --limit \
    --crease-edges examples/meshes/bracket_creases.txt --picture docs/images/refine.png --overwrite >/dev/null

picture_of_page() {  # HTML PNG WIDTH HEIGHT, as a browser shows it
    chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking \
        --disable-component-update --disable-sync --hide-scrollbars --user-data-dir="$folder/browser" \
        --window-size="$3,$4" --screenshot="$2" "file://$1" 2>/dev/null
}
build/stratareeb report "$folder/fence" -o "$folder/report.html" --title "Sighthill, Glasgow" --no-validation >/dev/null
picture_of_page "$folder/report.html" docs/images/report.png 1200 1500
build/stratareeb split "$folder/fence" -o "$folder/slabs" --count 8 --pictures --quiet >/dev/null
cp "$folder/slabs/slab_06.png" docs/images/slab.png
build/stratareeb build examples/buried_valley/holes.csv --rules examples/buried_valley/units.csv --quiet \
    -o "$folder/valley" >/dev/null
build/stratareeb section "$folder/valley" --along 0,400,1200,400 -o docs/images/layer_rules.png --overwrite \
    --title "A buried valley" >/dev/null
build/stratareeb build examples/graben/holes.csv --faults examples/graben/faults.geojson --quiet -o "$folder/graben" >/dev/null
build/stratareeb section "$folder/graben" --along 0,300,1200,300 -o docs/images/faults.png --overwrite \
    --title "A graben between two faults" >/dev/null
build/stratareeb build examples/relay/holes.csv --faults examples/relay/faults.geojson --formats png --quiet \
    -o "$folder/relay" >/dev/null
cp "$folder/relay/model.png" docs/images/dying_faults.png

# The 3D page, as Chromium shows it without a graphics card.
[ -d viewer/node_modules/playwright-core ] || (cd viewer && npm ci --silent)
build/stratareeb view "$folder/fence" --title "Sighthill, Glasgow" >/dev/null
node viewer/draw.js "$folder/fence/model.html" 'cut=y&cutAt=0.42&hole=3' docs/images/view.png 1280x800
build/stratareeb map "$folder/fence" --show thickness --unit clay --uncertainty interval -o docs/images/uncertainty.png \
    --overwrite >/dev/null
