# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT

# polylume_configure_target(TARGET): the language level, warnings and sanitizers that all our targets share.
function(polylume_configure_target target)
    target_compile_features(${target} PUBLIC cxx_std_20)
    set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON
                                               CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow
                                             $<$<BOOL:${POLYLUME_WARNINGS_AS_ERRORS}>:-Werror>)
    # Nobody reads errno after a square root; without this each one is followed by a call to set it.
    target_compile_options(${target} PRIVATE -fno-math-errno)
    # GCC 12 takes "literal" + std::string for overlapping memory (GCC bug 105651).
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
        target_compile_options(${target} PRIVATE -Wno-restrict)
    endif()
    if(POLYLUME_SANITIZE)
        target_compile_options(${target} PRIVATE -fsanitize=address,undefined -fno-sanitize-recover=undefined
                                                 -fno-omit-frame-pointer)
        target_link_options(${target} PUBLIC -fsanitize=address,undefined)
    endif()
endfunction()

# polylume_add_module(NAME SOURCES ... HEADERS ...): the static library polylume_NAME, alias polylume_engine::NAME,
# of one folder of engine/. Headers are named from engine/ ("ltc/table.hpp").
function(polylume_add_module name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;HEADERS")
    set(target polylume_${name})
    add_library(${target} STATIC ${arg_SOURCES})
    add_library(polylume_engine::${name} ALIAS ${target})
    target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/engine FILES ${arg_HEADERS})
    set_target_properties(${target} PROPERTIES VERIFY_INTERFACE_HEADER_SETS ON)
    polylume_configure_target(${target})
endfunction()
