#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The viewer's tests as ctest calls them: `ctest.sh unit|packages|build|browser FOLDER [PROGRAM]`. FOLDER, in the build tree, holds a copy
# of viewer/ with its npm packages. Exits 77 (skipped) and says why where Node.js, npm, its registry or Chromium is missing.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
folder=${2:-}

skip() {
    echo "skipped: $1"
    exit 77
}
need() { command -v "$1" >/dev/null || skip "$1 is not installed"; }
need_packages() { [ -d "$folder/node_modules/three" ] || skip "the npm packages are not there (test viewer.packages)"; }
copy_sources() {
    mkdir -p "$folder"
    rm -rf "$folder/src" "$folder/tests"
    cp -r "$here"/{src,tests,index.html,vite.config.js,package.json,package-lock.json,.npmrc} "$folder/"
}

need node
case "$1" in
    unit)
        cd "$here"
        node --test tests/unit/*.test.js
        ;;
    packages)
        need npm
        copy_sources
        cd "$folder"
        if cmp -s package-lock.json node_modules/installed-lock.json; then exit 0; fi
        npm ci --ignore-scripts --no-audit --no-fund --fetch-retries 1 --fetch-timeout 20000 >npm.log 2>&1 ||
            { tail -5 npm.log; grep -qE "ENOTFOUND|EAI_AGAIN|ETIMEDOUT|ECONNREFUSED|ECONNRESET" npm.log && skip "no npm registry"; exit 1; }
        cp package-lock.json node_modules/installed-lock.json
        ;;
    build)
        need_packages
        copy_sources
        cd "$folder"
        node node_modules/vite/bin/vite.js build --logLevel warn
        cmp dist/page.inc "$here/dist/page.inc" ||
            { echo "viewer/dist/page.inc is not what viewer/src makes: cd viewer && npm ci && npm run build"; exit 1; }
        ;;
    browser)
        need_packages
        need chromium
        copy_sources
        cd "$folder"
        STRATAREEB_PROGRAM=$3 STRATAREEB_SOURCE=$here/.. node --test tests/browser/*.test.js
        ;;
    *)
        echo "usage: ctest.sh unit|packages|build|browser FOLDER [PROGRAM]" >&2
        exit 2
        ;;
esac
