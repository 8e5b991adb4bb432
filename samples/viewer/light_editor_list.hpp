// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <string>

#include "light_editor.hpp"
#include "light_editor_shapes.hpp"

// The two lists of lights of a scene as one.
namespace polylume::viewer {

/// "area light 2", as the log has it.
std::string describe(const LightId& id);

/// Of both lists.
std::size_t countOf(const scene::Scene& scene);

bool exists(const scene::Scene& scene, const LightId& id);

/// These take a light that exists.
AnyLight get(const scene::Scene& scene, const LightId& id);
void erase(scene::Scene& scene, const LightId& id);

/// At the end of its list; which it is now.
LightId append(scene::Scene& scene, AnyLight light);

/// In the other's place; which it is now, if it went to the other list.
LightId replace(scene::Scene& scene, const LightId& id, AnyLight light);

}  // namespace polylume::viewer
