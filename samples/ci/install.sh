#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
#
# install.sh SOURCE PREFIX: builds the command from a checkout of Polylume and installs it to
# PREFIX/bin/polylume, with what it needs from the system (Debian's packages, as root or by sudo).
#
# POLYLUME_BUILT names a folder where it has been built already, which is then installed as it is.
set -euo pipefail
if [[ $# -ne 2 ]]; then
    echo "usage: install.sh SOURCE PREFIX" >&2
    exit 2
fi
source=$1
prefix=$2

build=${POLYLUME_BUILT:-}
if [[ -z $build ]]; then
    "$source/ci/setup"
    build=$source/build/ci-sample
    cmake -S "$source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DPOLYLUME_BUILD_TESTS=OFF
    cmake --build "$build" --target polylume_command
fi
cmake --install "$build" --prefix "$prefix" --component command
"$prefix/bin/polylume" --version
