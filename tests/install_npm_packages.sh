#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
#
# install_npm_packages.sh SOURCE TARGET: puts the packages that SOURCE/package-lock.json names into
# TARGET/node_modules, from the npm registry. Does nothing where they are there already.
set -euo pipefail
source=$1
target=$2

if ! command -v npm >/dev/null; then
    echo "install_npm_packages: npm is missing; ci/setup installs it (Debian: npm)" >&2
    exit 1
fi
mkdir -p "$target"
if cmp --silent "$source/package-lock.json" "$target/package-lock.json" && [[ -d $target/node_modules ]]; then
    echo "install_npm_packages: the packages are there"
    exit 0
fi
# The lock is copied last: what was broken off is begun anew.
rm -rf "$target/node_modules" "$target/package-lock.json"
staging=$target/staging
rm -rf "$staging"
mkdir "$staging"
cp "$source/package.json" "$source/package-lock.json" "$staging"
npm ci --prefix "$staging" --no-audit --no-fund --ignore-scripts
mv "$staging/node_modules" "$target/node_modules"
mv "$staging/package-lock.json" "$target/package-lock.json"
rm -r "$staging"
