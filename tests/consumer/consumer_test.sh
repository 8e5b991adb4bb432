#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
#
# consumer_test.sh CASE [static|shared]: one test of polylume::lighting as a user gets it. The environment, set by
# CMakeLists.txt: SOURCE, BUILD and WORK are folders, BUILD_TYPE and DEBUG_FLAGS those of BUILD; CMAKE, GLAD, PYTHON, CC,
# CXX and LAUNCHER programs, the last one or none.
set -euo pipefail

case_name=$1
kind=${2:-}
prefix=$WORK/$kind/moved
picture_size=(320 180)
along=$WORK/along
host_glad=$WORK/$case_name-$kind/glad

fail() {
    echo "consumer_test: $*" >&2
    exit 1
}

# The host's own loader, of the same kind as Polylume's but of another content.
make_glad() {
    "$GLAD" --api gl:core=4.5 --extensions= --out-path "$host_glad" --reproducible --quiet c --mx
}

# Configures a project in a folder as this build is configured.
configure() {
    local project=$1 folder=$2
    shift 2
    rm -rf "$folder"
    "$CMAKE" -S "$project" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE="$BUILD_TYPE" -DCMAKE_CXX_FLAGS_DEBUG="$DEBUG_FLAGS" \
        -DCMAKE_C_COMPILER="$CC" -DCMAKE_CXX_COMPILER="$CXX" -DCMAKE_C_COMPILER_LAUNCHER="$LAUNCHER" \
        -DCMAKE_CXX_COMPILER_LAUNCHER="$LAUNCHER" "$@" >"$folder.log" 2>&1 || { cat "$folder.log"; fail "no build files"; }
}

build() {
    "$CMAKE" --build "$1" || fail "$1 does not build"
}

# Installs the component alone and moves the folder: nothing may remember where it was.
install_and_move() {
    rm -rf "$prefix" "$prefix.before"
    mkdir -p "$WORK/$kind"
    "$CMAKE" --install "$1" --component lighting --prefix "$prefix.before" >/dev/null
    mv "$prefix.before" "$prefix"
    if grep -rlF -e "$prefix.before" -e "$1" -e "$SOURCE" "$prefix"/lib*/cmake "$prefix"/lib*/pkgconfig; then
        fail "an installed file names a folder of the build"
    fi
}

has_files() {
    local file
    for file in "$@"; do
        compgen -G "$prefix/$file" >/dev/null || fail "expected $file to be installed"
    done
}

# Where the headers and libraries of an installation lie.
library_dir() {
    dirname "$(compgen -G "$prefix/lib*/pkgconfig" || compgen -G "$prefix/lib*/*/pkgconfig")"
}

case $case_name in
install)
    install_and_move "$BUILD"
    has_files include/polylume/{area_lighting.hpp,polylume.h} 'lib*/libpolylume.*' share/polylume/glsl/ltc/polygon.glsl \
        share/polylume/tables/ggx.f32 share/doc/polylume/LICENSE
    if compgen -G "$prefix/bin/*"; then fail "expected the library without the command"; fi
    ;;
along)
    # The command's dependencies are hidden, as on a machine that lacks them.
    hidden=()
    for package in CLI11 Ceres Eigen3 GTest JPEG OpenImageIO PNG TBB Threads TinyGLTF benchmark embree fmt glfw3 nlohmann_json; do
        hidden+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=TRUE")
    done
    mkdir -p "$WORK"
    configure "$SOURCE/samples/embed" "$along" -DPOLYLUME_CHECKOUT="$SOURCE" -DPOLYLUME_INSTALL=ON -DBUILD_SHARED_LIBS=ON \
        "${hidden[@]}"
    if grep -e POLYLUME_OPENIMAGEIO -e POLYLUME_CERES "$along/CMakeCache.txt"; then fail "expected the command's part not to be configured"; fi
    build "$along"
    "$along/embed_sample" "$along/picture.ppm" "${picture_size[@]}"
    install_and_move "$along"
    ;;
sample)
    folder=$WORK/sample-$kind
    configure "$SOURCE/samples/embed" "$folder" -DCMAKE_PREFIX_PATH="$prefix"
    build "$folder"
    "$folder/embed_sample" "$folder/picture.ppm" "${picture_size[@]}"
    cmp "$folder/picture.ppm" "$along/picture.ppm" || fail "expected the picture of the host that built Polylume along"
    ;;
own_glm)
    # Configured only: another build of the library would show nothing new.
    mkdir -p "$WORK"
    configure "$SOURCE/tests/consumer/own_glm" "$WORK/own_glm" -DCHECKOUT="$SOURCE"
    ;;
picture)
    "$PYTHON" "$SOURCE/tests/consumer/picture_test.py" "$along/picture.ppm" "${picture_size[@]}"
    if "$along/embed_sample" "$along/none.ppm" 0 180; then fail "expected a width of 0 to be refused"; fi
    if "$along/embed_sample" /no/such/folder.ppm 16 16; then fail "expected no picture in a folder that is none"; fi
    ;;
c_project)
    make_glad
    folder=$WORK/c_project-$kind/build
    configure "$SOURCE/tests/consumer/c_project" "$folder" -DCMAKE_PREFIX_PATH="$prefix" -DHOST_GLAD="$host_glad" \
        -DEXPECTED_VERSION="$VERSION"
    build "$folder"
    "$folder/c_host" "$VERSION"
    ;;
pkg_config)
    make_glad
    cd "$WORK/pkg_config-$kind"
    libraries=$(library_dir)
    export PKG_CONFIG_PATH=$libraries/pkgconfig LD_LIBRARY_PATH=$libraries
    [[ $(pkg-config --modversion polylume) == "$VERSION" ]] || fail "expected version $VERSION of pkg-config"
    query=(pkg-config --libs)
    # Only the static library leaves the C++ library to the host.
    [[ $kind == shared ]] || query+=(--static)
    read -ra compile < <(pkg-config --cflags polylume)
    read -ra link < <("${query[@]}" polylume)
    "$CC" -O1 -isystem "$host_glad/include" -c "$host_glad/src/gl.c" -o gl.o
    # An archive, so that the linker chooses between this and Polylume's by the names alone.
    ar rcs libhost_glad.a gl.o
    flags=(-O1 -pedantic-errors -Wall -Wextra -Werror -isystem "$host_glad/include" "${compile[@]}")
    hosts=$SOURCE/tests/consumer
    "$CC" -std=c99 "${flags[@]}" "$hosts/c_host.c" -o c_host libhost_glad.a "${link[@]}" -lEGL -lm -lpthread
    ./c_host "$VERSION"
    "$CXX" -std=c++20 "${flags[@]}" "$hosts/cpp_host.cpp" -o cpp_host libhost_glad.a "${link[@]}" -lEGL
    ./cpp_host
    ;;
headers)
    warnings=(-fsyntax-only -pedantic-errors -Wall -Wextra -Wshadow -Werror "-I$prefix/include")
    cd "$WORK/static"
    for header in "$prefix"/include/polylume/*; do
        # The variable: C wants a file to hold something.
        printf '#include <polylume/%s>\nextern int something;\n' "${header##*/}" >alone.cpp
        "$CXX" -std=c++20 "${warnings[@]}" alone.cpp || fail "$header does not compile alone"
        [[ $header == *.h ]] || continue
        cp alone.cpp alone.c
        "$CC" -std=c99 "${warnings[@]}" alone.c || fail "$header does not compile alone as C99"
    done
    # Vectors of 16 bytes would be taken for ours of 12.
    printf '#include <polylume/light.hpp>\n' >aligned.cpp
    aligned=(-DGLM_FORCE_INTRINSICS -DGLM_FORCE_DEFAULT_ALIGNED_GENTYPES)
    if "$CXX" -std=c++20 "${warnings[@]}" "${aligned[@]}" aligned.cpp 2>aligned.log; then
        fail "expected padded vectors to be refused"
    fi
    grep -q "include polylume without GLM_FORCE_DEFAULT_ALIGNED_GENTYPES" aligned.log || fail "$(<aligned.log)"
    ;;
exports)
    "$PYTHON" "$SOURCE/tests/consumer/exports_test.py" "$WORK/static/moved" "$WORK/shared/moved"
    ;;
*)
    fail "no case $case_name"
    ;;
esac
echo "consumer_test: $case_name $kind passed"
