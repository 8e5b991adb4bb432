# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT

# polylume_add_test(NAME LABEL unit|gl|image|cli|viewer SOURCES ... LIBRARIES ...): a GoogleTest program whose tests run
# one by one through ctest. They find files of the repository by the macro POLYLUME_SOURCE_DIR, the built command by
# POLYLUME_COMMAND, and may leave files in the folder that they run in.
function(polylume_add_test name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "LABEL" "SOURCES;LIBRARIES")
    add_executable(${name} ${arg_SOURCES})
    polylume_configure_target(${name})
    target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} GTest::gmock GTest::gtest_main)
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
    target_compile_definitions(${name} PRIVATE POLYLUME_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                               POLYLUME_COMMAND="$<TARGET_FILE:polylume_command>")
    file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/work)
    gtest_discover_tests(${name} WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/work DISCOVERY_TIMEOUT 60
                         PROPERTIES LABELS ${arg_LABEL} TIMEOUT 600)
endfunction()
