// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "polylume/area_lighting.hpp"

#include "embed/area_lighting_state.hpp"

namespace polylume {

struct AreaLighting::State : embed::AreaLightingState {
    using AreaLightingState::AreaLightingState;

    /// Of an object that was not moved from.
    static State& of(const std::unique_ptr<State>& state) {
        if (state == nullptr) {
            throw Error(
                "expected an AreaLighting that has not been moved from, found one that has: call "
                "the one that it was moved to");
        }
        return *state;
    }
    /// The same, with its context current.
    static State& inContext(const std::unique_ptr<State>& state) {
        State& found = of(state);
        found.checkContext();
        return found;
    }
};

AreaLighting::AreaLighting(const GetProcAddress& getProcAddress, const AreaLightingOptions& options)
    : state_(std::make_unique<State>(getProcAddress, options)) {}

AreaLighting::~AreaLighting() = default;
AreaLighting::AreaLighting(AreaLighting&&) noexcept = default;
AreaLighting& AreaLighting::operator=(AreaLighting&&) noexcept = default;

void AreaLighting::setLights(const LightSet& lights) {
    State::inContext(state_).setLights(lights);
}

void AreaLighting::updatePolygons(std::size_t first, std::span<const PolygonLight> lights) {
    State::inContext(state_).update(first, lights);
}

void AreaLighting::updateEllipses(std::size_t first, std::span<const EllipseLight> lights) {
    State::inContext(state_).update(first, lights);
}

void AreaLighting::updateSpheres(std::size_t first, std::span<const SphereLight> lights) {
    State::inContext(state_).update(first, lights);
}

void AreaLighting::updateTubes(std::size_t first, std::span<const TubeLight> lights) {
    State::inContext(state_).update(first, lights);
}

void AreaLighting::updatePunctuals(std::size_t first, std::span<const PunctualLight> lights) {
    State::inContext(state_).update(first, lights);
}

void AreaLighting::updateLightTexture(std::size_t polygon, std::uint32_t texture) {
    State::inContext(state_).updateLightTexture(polygon, texture);
}

void AreaLighting::setLobes(Lobes lobes) {
    State::inContext(state_).setLobes(lobes);
}

void AreaLighting::setLightThreshold(std::optional<float> nits) {
    State::inContext(state_).setLightThreshold(nits);
}

void AreaLighting::draw(const LightingFrame& frame) {
    State::inContext(state_).draw(frame);
}

std::uint32_t AreaLighting::program() const {
    return State::of(state_).program();
}

std::optional<double> AreaLighting::gpuTimeSeconds() {
    return State::inContext(state_).gpuTimeSeconds();
}

}  // namespace polylume
