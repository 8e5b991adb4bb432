#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
#
# ci_sample_test.sh CASE SOURCE BUILD WORK: one case of the tests of samples/ci, in the folder WORK,
# which the case "installs" fills for the others.
set -euo pipefail
case=$1
source=$2
build=$3
work=$(realpath --canonicalize-missing "$4")

sample=$source/samples/ci
scene=$source/samples/scenes/studio.glb
prefix=$work/prefix
export POLYLUME=$prefix/bin/polylume

fail() {
    echo "$case: $1" >&2
    exit 1
}

# check STORED ARTEFACTS EXPECTED: runs the sample's job and looks for all that it has to leave.
check() {
    local found=0
    rm -rf "$2"
    "$sample/check_picture.sh" "$scene" "$1" "$2" || found=$?
    [[ $found -eq $3 ]] || fail "expected exit code $3, found $found"
    for file in picture.png stored.png diff.png report.json; do
        [[ -s $2/$file ]] || fail "expected $file among the artefacts"
    done
}

# hasDifference DIFF EMPTY_DIFF: whether a heat map shows more than that of two equal pictures.
hasDifference() {
    ! "$POLYLUME" compare "$1" "$2" --max-abs 0.25 >/dev/null
}

# emptyDiff: the heat map of the stored picture against itself.
emptyDiff() {
    "$POLYLUME" compare "$sample/studio.png" "$sample/studio.png" --diff "$1" >/dev/null
}

case $case in
installs)
    rm -rf "$work"
    mkdir -p "$work"
    POLYLUME_BUILT=$build "$sample/install.sh" "$source" "$prefix"
    # Reads images by the library that was installed, not by the one that was built.
    LD_DEBUG=files LD_DEBUG_OUTPUT=$work/loads "$POLYLUME" compare "$sample/studio.png" \
        "$sample/studio.png" --max-abs 0
    grep -q "generating link map" "$work"/loads.* || fail "expected a list of loaded files"
    grep -h -A1 "file=.*polylume_image_io.*generating link map" "$work"/loads.* |
        grep -qF "file=$prefix/lib/polylume/" || fail "expected the installed image library"
    ;;
passes)
    check "$sample/studio.png" "$work/passing" 0
    grep -q '"passed": true' "$work/passing/report.json" || fail "expected a report that passes"
    emptyDiff "$work/empty.png"
    ! hasDifference "$work/passing/diff.png" "$work/empty.png" ||
        fail "expected no difference in the heat map"
    ;;
fails)
    # A picture stored from another material model: the kind of mistake that the job is there for.
    "$POLYLUME" render "$scene" -o "$work/broken.png" --backend osmesa --size 160x90 --exposure 10 \
        --specular beckmann
    check "$work/broken.png" "$work/failing" 1
    grep -q '"passed": false' "$work/failing/report.json" || fail "expected a report that fails"
    emptyDiff "$work/nothing.png"
    hasDifference "$work/failing/diff.png" "$work/nothing.png" ||
        fail "expected a difference in the heat map"
    ;;
*)
    fail "expected installs, passes or fails"
    ;;
esac
