# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT

# polylume_embed_files(TARGET FUNCTION name BASE_DIR dir FILES ...): compiles FILES into TARGET. They are read by
# `std::span<const EmbeddedFile> polylume::FUNCTION()` (core/embedded_file.hpp), each named by its path from BASE_DIR.
function(polylume_embed_files target)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "FUNCTION;BASE_DIR" "FILES")
    set(paths ${arg_FILES})
    list(TRANSFORM paths PREPEND ${arg_BASE_DIR}/)
    set(output ${CMAKE_CURRENT_BINARY_DIR}/${arg_FUNCTION}.cpp)
    list(JOIN arg_FILES "|" files)
    add_custom_command(
        OUTPUT ${output}
        COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DFUNCTION=${arg_FUNCTION} -DBASE_DIR=${arg_BASE_DIR}
                "-DFILES=${files}" -P ${PROJECT_SOURCE_DIR}/cmake/EmbedFilesScript.cmake
        DEPENDS ${paths} ${PROJECT_SOURCE_DIR}/cmake/EmbedFilesScript.cmake
        COMMENT "Embedding the files of ${arg_FUNCTION}()"
        VERBATIM)
    target_sources(${target} PRIVATE ${output})
endfunction()
