// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/light_view.hpp"

#include "reference/random_choice.hpp"

namespace polylume::reference {
namespace {

/// Below this the sum of angles has lost too many digits, and area and solid angle agree.
constexpr double kSmallSolidAngle = 1e-5;

std::variant<FlatView, SolidView> viewOf(const AreaEmitter& emitter, const ShadingFrame& frame) {
    if (const auto* flat = std::get_if<FlatEmitter>(&emitter)) return FlatView(*flat, frame);
    return SolidView(std::get<SolidEmitter>(emitter), frame);
}

}  // namespace

LightView::LightView(const AreaEmitter& emitter, const ShadingFrame& frame,
                     std::span<const LobeShape> lobes, LightSampling sampling)
    : light_(viewOf(emitter, frame)) {
    isDark_ = std::visit([](const auto& light) { return light.isDark(); }, light_);
    if (sampling == LightSampling::area) way_ = Way::area;
    if (isDark_ || way_ == Way::area) return;
    stretched_.reserve(lobes.size());
    for (const LobeShape& lobe : lobes) {
        if (!(lobe.chance > 0.0)) continue;
        StretchedView& view = stretched_.emplace_back(lobe);
        std::visit([&](const auto& light) { light.addTo(view); }, light_);
        if (!(view.solidAngle() >= kSmallSolidAngle)) way_ = Way::small;
    }
}

template <typename Function>
auto LightView::ask(const Function& function) const {
    if (const auto* flat = std::get_if<FlatView>(&light_)) return function(*flat);
    return function(*std::get_if<SolidView>(&light_));
}

glm::dvec3 LightView::radiance(const LightSample& sample) const {
    return ask([&](const auto& light) {
        return glm::dvec3(light.radianceAt(sample.distance * sample.direction));
    });
}

template <typename Light>
double LightView::density(const Light& light, const glm::dvec3& direction, double distance) const {
    if (way_ == Way::area) return light.areaDensity(direction, distance);
    if (way_ == Way::small) return light.smallDensity(direction, distance);
    double sum = 0.0;
    for (const StretchedView& view : stretched_) sum += view.chance() * view.density(direction);
    return sum;
}

LightSample LightView::sample(const glm::dvec2& random) const {
    return ask([&](const auto& light) -> LightSample {
        if (way_ == Way::area) return light.sampleArea(random);
        if (way_ == Way::small) return light.sampleSmall(random);
        double share = random.x;
        const StretchedView& view = choose(
            stretched_, 1.0, [](const StretchedView& v) { return v.chance(); }, share);
        const glm::dvec3 direction = view.sample({share, random.y});
        const double distance = light.distanceTo(direction);
        if (light.isCoveredWidely() && !light.isHit(direction, distance)) {
            return {direction, 0.0, 0.0};
        }
        return {direction, distance, density(light, direction, distance)};
    });
}

LightSample LightView::find(const glm::dvec3& direction) const {
    return ask([&](const auto& light) -> LightSample {
        const double distance = light.distanceTo(direction);
        if (!light.isHit(direction, distance)) return {direction, 0.0, 0.0};
        return {direction, distance, density(light, direction, distance)};
    });
}

}  // namespace polylume::reference
