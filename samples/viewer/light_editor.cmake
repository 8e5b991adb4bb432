# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT

# Light editing and the remembered state, without GLFW and OpenGL: the tests drive them with Dear ImGui alone.
add_library(
    polylume_viewer_lights STATIC
    light_editor.cpp
    light_editor_conversion.cpp
    light_editor_list.cpp
    light_editor_shapes.cpp
    light_gizmo.cpp
    light_gizmo_math.cpp
    light_panel.cpp
    light_picking.cpp
    viewer_state.cpp)
polylume_configure_target(polylume_viewer_lights)
target_include_directories(polylume_viewer_lights PUBLIC ${CMAKE_CURRENT_LIST_DIR})
target_link_libraries(
    polylume_viewer_lights
    PUBLIC polylume_engine::scene glm::glm
    PRIVATE polylume_engine::core polylume_engine::image polylume_engine::lights PkgConfig::POLYLUME_IMGUI
            nlohmann_json::nlohmann_json)
