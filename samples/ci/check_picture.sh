#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
#
# check_picture.sh SCENE STORED ARTEFACTS: renders SCENE, compares it with the picture STORED and
# ends with 0 only where they look alike. Leaves in the folder ARTEFACTS, whatever the outcome:
#     picture.png   what was rendered
#     stored.png    what it should be
#     diff.png      where they differ: FLIP's heat map
#     report.json   how far they are apart
#
# POLYLUME names the command; without it, it is found on the PATH.
set -euo pipefail
if [[ $# -ne 3 ]]; then
    echo "usage: check_picture.sh SCENE STORED ARTEFACTS" >&2
    exit 2
fi
scene=$1
stored=$2
artefacts=$3
polylume=${POLYLUME:-polylume}

# The mean of FLIP. Another vector width of llvmpipe leaves it at 0 for the studio; 16 samples a pixel
# in place of 4 make it 0.007, one step of 255 at every value 0.03, another material model 0.04.
flip_max=0.005

mkdir -p "$artefacts"
cp "$stored" "$artefacts/stored.png"
# OSMesa draws on the CPU and needs no display. A fixed exposure, so that a change in one place does
# not change the brightness of all others.
"$polylume" render "$scene" -o "$artefacts/picture.png" --backend osmesa --size 160x90 --exposure 10
"$polylume" compare "$artefacts/picture.png" "$stored" --flip-max "$flip_max" \
    --diff "$artefacts/diff.png" --json >"$artefacts/report.json"
