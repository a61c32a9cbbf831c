#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the packages of packages.txt that are missing: `install_packages.sh build` or `install_packages.sh test`
# (which takes in the build packages too). Says and does nothing when all are there.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

case "${1:-}" in
    build) roles='build' ;;
    test) roles='build|test' ;;
    *) echo "usage: install_packages.sh build|test" >&2; exit 2 ;;
esac
wanted=$(awk -v roles="^($roles)$" '!/^#/ && $2 ~ roles { print $1 }' "$here/packages.txt")

if ! command -v dpkg-query >/dev/null; then
    echo "This is not Debian or Ubuntu: make sure that these libraries are installed, by whatever name they have here:"
    echo $wanted
    exit 0
fi
# What another package provides counts too: some distributions of nodejs bring npm along.
installed=$(dpkg-query -W -f='${db:Status-Status} ${Package} ${Provides}\n' |
    awk '$1 == "installed" { for (i = 2; i <= NF; ++i) { sub(/,$/, "", $i); print $i } }' | sort -u)
missing=$(comm -23 <(sort -u <<<"$wanted") <(echo "$installed"))
[ -n "$missing" ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
        echo "Packages are missing and there is no sudo. As root, run:" >&2
        echo "  apt-get install" $missing >&2
        exit 1
    fi
    as_root=(sudo)
fi
echo "Installing" $missing
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null
