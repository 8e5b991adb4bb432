# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT

# polylume_glad: the OpenGL 4.5 core loader, generated at build time. With --mx the function pointers live in a
# struct of ours and never meet those of a host program.
find_program(POLYLUME_GLAD glad REQUIRED DOC "The glad 2 generator (Debian: python3-glad)")

set(glad_dir ${PROJECT_BINARY_DIR}/glad)
add_custom_command(
    OUTPUT ${glad_dir}/src/gl.c ${glad_dir}/include/glad/gl.h
    COMMAND ${POLYLUME_GLAD} --api gl:core=4.5 --extensions GL_KHR_debug --out-path ${glad_dir} --reproducible --quiet
            c --mx
    COMMENT "Generating the OpenGL loader"
    VERBATIM)
add_library(polylume_glad STATIC ${glad_dir}/src/gl.c ${glad_dir}/include/glad/gl.h)
target_include_directories(polylume_glad SYSTEM PUBLIC ${glad_dir}/include)
# A host program may link a glad of its own beside ours: its two functions are not to be taken for each other's.
target_compile_definitions(polylume_glad PUBLIC gladLoadGLContext=polylume_gladLoadGLContext
                                                gladLoadGLContextUserPtr=polylume_gladLoadGLContextUserPtr)
set_target_properties(polylume_glad PROPERTIES POSITION_INDEPENDENT_CODE ON C_VISIBILITY_PRESET hidden)
