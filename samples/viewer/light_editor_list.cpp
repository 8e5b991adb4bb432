// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "light_editor_list.hpp"

#include <utility>

#include "core/text.hpp"

namespace polylume::viewer {

std::string describe(const LightId& id) {
    return concat(id.kind == LightId::Kind::area ? "area" : "punctual", " light ", id.index);
}

std::size_t countOf(const scene::Scene& scene) {
    return scene.areaLights.size() + scene.punctualLights.size();
}

bool exists(const scene::Scene& scene, const LightId& id) {
    const std::size_t count =
        id.kind == LightId::Kind::area ? scene.areaLights.size() : scene.punctualLights.size();
    return id.index >= 0 && static_cast<std::size_t>(id.index) < count;
}

AnyLight get(const scene::Scene& scene, const LightId& id) {
    const auto index = static_cast<std::size_t>(id.index);
    if (id.kind == LightId::Kind::area) return scene.areaLights[index];
    return scene.punctualLights[index];
}

LightId append(scene::Scene& scene, AnyLight light) {
    if (auto* area = std::get_if<scene::AreaLight>(&light)) {
        scene.areaLights.push_back(std::move(*area));
        return {LightId::Kind::area, static_cast<int>(scene.areaLights.size()) - 1};
    }
    scene.punctualLights.push_back(std::move(std::get<scene::PunctualLight>(light)));
    return {LightId::Kind::punctual, static_cast<int>(scene.punctualLights.size()) - 1};
}

void erase(scene::Scene& scene, const LightId& id) {
    if (id.kind == LightId::Kind::area) {
        scene.areaLights.erase(scene.areaLights.begin() + id.index);
    } else {
        scene.punctualLights.erase(scene.punctualLights.begin() + id.index);
    }
}

LightId replace(scene::Scene& scene, const LightId& id, AnyLight light) {
    const bool staysArea =
        id.kind == LightId::Kind::area && std::holds_alternative<scene::AreaLight>(light);
    const bool staysPunctual =
        id.kind == LightId::Kind::punctual && std::holds_alternative<scene::PunctualLight>(light);
    const auto index = static_cast<std::size_t>(id.index);
    if (staysArea) {
        scene.areaLights[index] = std::move(std::get<scene::AreaLight>(light));
        return id;
    }
    if (staysPunctual) {
        scene.punctualLights[index] = std::move(std::get<scene::PunctualLight>(light));
        return id;
    }
    erase(scene, id);
    return append(scene, std::move(light));
}

}  // namespace polylume::viewer
