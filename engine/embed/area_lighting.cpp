// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "polylume/area_lighting.hpp"

#include "embed/area_lighting_state.hpp"

namespace polylume {

struct AreaLighting::State : embed::AreaLightingState {
    using AreaLightingState::AreaLightingState;
};

AreaLighting::AreaLighting(const GetProcAddress& getProcAddress, const AreaLightingOptions& options)
    : state_(std::make_unique<State>(getProcAddress, options)) {}

AreaLighting::~AreaLighting() = default;
AreaLighting::AreaLighting(AreaLighting&&) noexcept = default;
AreaLighting& AreaLighting::operator=(AreaLighting&&) noexcept = default;

void AreaLighting::setLights(const LightSet& lights) {
    state_->setLights(lights);
}

void AreaLighting::updatePolygons(std::size_t first, std::span<const PolygonLight> lights) {
    state_->update(first, lights);
}

void AreaLighting::updateEllipses(std::size_t first, std::span<const EllipseLight> lights) {
    state_->update(first, lights);
}

void AreaLighting::updateSpheres(std::size_t first, std::span<const SphereLight> lights) {
    state_->update(first, lights);
}

void AreaLighting::updateTubes(std::size_t first, std::span<const TubeLight> lights) {
    state_->update(first, lights);
}

void AreaLighting::updatePunctuals(std::size_t first, std::span<const PunctualLight> lights) {
    state_->update(first, lights);
}

void AreaLighting::updateLightTexture(std::size_t polygon, std::uint32_t texture) {
    state_->updateLightTexture(polygon, texture);
}

void AreaLighting::setLobes(Lobes lobes) {
    state_->setLobes(lobes);
}

void AreaLighting::draw(const LightingFrame& frame) {
    state_->draw(frame);
}

std::uint32_t AreaLighting::program() const {
    return state_->program();
}

std::optional<double> AreaLighting::gpuTimeSeconds() {
    return state_->gpuTimeSeconds();
}

}  // namespace polylume
