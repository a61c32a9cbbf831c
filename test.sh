#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds everything into build/ and runs every test and lint. `--quick` leaves the lints out; anything else is handed to
# ctest, as in `./test.sh -R sample`.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

select=()
if [ "${1:-}" = --quick ]; then
    select=(-LE lint)
    shift
fi

echo "== packages"
scripts/install_packages.sh test
echo "== configure"
mkdir -p build
cmake --preset release -DSTRATAREEB_BUILD_TESTS=ON >build/configure.log 2>&1 || { cat build/configure.log; exit 1; }
echo "== build"
cmake --build build
echo "== test"
ctest --test-dir build -j2 --output-on-failure "${select[@]}" "$@"
