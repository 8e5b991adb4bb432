# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT

# Run by polylume_embed_files() with OUTPUT, FUNCTION, BASE_DIR and FILES (separated by "|").
string(REPLACE "|" ";" FILES "${FILES}")
set(arrays "")
set(entries "")
set(index 0)
foreach(file IN LISTS FILES)
    file(READ ${BASE_DIR}/${file} hex HEX)
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
    string(APPEND arrays "alignas(16) const unsigned char bytes${index}[] = {${bytes}0};\n")
    string(APPEND entries "    {\"${file}\", {bytes${index}, sizeof(bytes${index}) - 1}},\n")
    math(EXPR index "${index} + 1")
endforeach()
file(WRITE ${OUTPUT}.tmp "// Generated from ${BASE_DIR}.
#include \"core/embedded_file.hpp\"

namespace polylume {
namespace {
${arrays}
const EmbeddedFile files[] = {
${entries}};
}  // namespace

std::span<const EmbeddedFile> ${FUNCTION}();
std::span<const EmbeddedFile> ${FUNCTION}() { return files; }
}  // namespace polylume
")
file(RENAME ${OUTPUT}.tmp ${OUTPUT})
