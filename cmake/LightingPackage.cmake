# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT

# What polylume::lighting is outside this tree: its version, what it exports, and how it is installed, all in the
# component "lighting". Nothing that is installed holds an absolute path, so the folder may move.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

# Before 1.0 a new minor version may break hosts.
set_target_properties(polylume_embed PROPERTIES VERSION ${PROJECT_VERSION}
                                                SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
if(BUILD_SHARED_LIBS AND NOT APPLE)
    # Hidden visibility leaves instances of the standard library's templates visible; this leaves the API alone.
    set(version_script ${PROJECT_SOURCE_DIR}/cmake/polylume.map)
    target_link_options(polylume_embed PRIVATE LINKER:--version-script=${version_script})
    set_property(TARGET polylume_embed APPEND PROPERTY LINK_DEPENDS ${version_script})
endif()

if(NOT POLYLUME_INSTALL)
    return()
endif()

install(
    TARGETS polylume_embed
    EXPORT polylumeTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT lighting
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT lighting
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT lighting
    FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT lighting)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/polylume)
install(EXPORT polylumeTargets NAMESPACE polylume:: DESTINATION ${package_dir} COMPONENT lighting)

# The shaders and the tables for those who want no library: the build and the run of a host need neither.
set(data_dir ${CMAKE_INSTALL_DATADIR}/polylume)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/glsl ${PROJECT_SOURCE_DIR}/tables DESTINATION ${data_dir} COMPONENT lighting
        USE_SOURCE_PERMISSIONS PATTERN files.cmake EXCLUDE PATTERN __pycache__ EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT lighting)

# What a program without C++ of its own has to link beside the static library.
set(POLYLUME_CXX_LIBRARIES ${CMAKE_CXX_IMPLICIT_LINK_LIBRARIES})
list(REMOVE_ITEM POLYLUME_CXX_LIBRARIES ${CMAKE_C_IMPLICIT_LINK_LIBRARIES})
list(REMOVE_DUPLICATES POLYLUME_CXX_LIBRARIES)
list(TRANSFORM POLYLUME_CXX_LIBRARIES PREPEND -l OUTPUT_VARIABLE POLYLUME_CXX_LINK_FLAGS)
list(JOIN POLYLUME_CXX_LINK_FLAGS " " POLYLUME_CXX_LINK_FLAGS)

configure_package_config_file(
    ${PROJECT_SOURCE_DIR}/cmake/polylumeConfig.cmake.in ${PROJECT_BINARY_DIR}/polylumeConfig.cmake
    INSTALL_DESTINATION ${package_dir}
    PATH_VARS data_dir)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/polylumeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/polylumeConfig.cmake ${PROJECT_BINARY_DIR}/polylumeConfigVersion.cmake
        DESTINATION ${package_dir} COMPONENT lighting)

# Folders from the file's own, so that the prefix is wherever the file is.
set(pkgconfig_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
foreach(folder INCLUDE LIB)
    file(RELATIVE_PATH POLYLUME_PC_${folder}DIR ${CMAKE_INSTALL_PREFIX}/${pkgconfig_dir}
         ${CMAKE_INSTALL_FULL_${folder}DIR})
    string(REGEX REPLACE "/$" "" POLYLUME_PC_${folder}DIR ${POLYLUME_PC_${folder}DIR})
endforeach()
configure_file(${PROJECT_SOURCE_DIR}/cmake/polylume.pc.in ${PROJECT_BINARY_DIR}/polylume.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/polylume.pc DESTINATION ${pkgconfig_dir} COMPONENT lighting)
