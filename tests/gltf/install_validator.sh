#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
#
# install_validator.sh FOLDER: puts the locked version of the Khronos glTF validator into
# FOLDER/node_modules, from the npm registry. Does nothing where it is there already.
set -euo pipefail
source=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
target=$1

if ! command -v npm >/dev/null; then
    echo "install_validator: npm is missing; ci/setup installs it (Debian: npm)" >&2
    exit 1
fi
mkdir -p "$target"
if cmp --silent "$source/package-lock.json" "$target/package-lock.json" &&
    [[ -f $target/node_modules/gltf-validator/package.json ]]; then
    echo "install_validator: it is there"
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
