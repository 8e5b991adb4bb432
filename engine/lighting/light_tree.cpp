// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/light_tree.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <tuple>

#include "lighting/light_group.hpp"

namespace polylume {
namespace {

/// More lights than that are not near each other for any tile.
constexpr std::size_t kMostInGroup = 256;

std::uint32_t listOf(LightKind kind) {
    switch (kind) {
        case LightKind::triangle:
            return shared::kTriangleList;
        case LightKind::polygon:
            return shared::kPolygonList;
        case LightKind::texturedParallelogram:
            return shared::kTexturedParallelogramList;
        case LightKind::texturedPolygon:
            return shared::kTexturedPolygonList;
        case LightKind::disk:
            return shared::kDiskList;
        case LightKind::ellipse:
            return shared::kEllipseList;
        case LightKind::sphere:
            return shared::kSphereList;
        case LightKind::tube:
            return shared::kTubeList;  // Of which strips are chosen.
        case LightKind::punctual:
            return shared::kPunctualList;
        case LightKind::parallelogram:
        case LightKind::none:
            break;
    }
    return shared::kParallelogramList;
}

/// Lights of equal keys can form groups: parallel, both or neither two-sided, and of about the same
/// colour, so that a group has its center where each channel has it. Normals and colours are
/// compared on grids, on which those within half a step of each other mostly fall together.
auto groupKey(const LightSummary& light) {
    const double step = shared::kParallelTolerance / 2.0;
    const glm::dvec3 cell = glm::round(light.normal / step);
    const glm::dvec3 color = glm::max(light.radiance, 1e-6 * (light.radiance.g + 1e-20));
    constexpr double kColorStep = 0.05;
    const double red = std::round(std::log(color.r / color.g) / kColorStep);
    const double blue = std::round(std::log(color.b / color.g) / kColorStep);
    return std::tuple(light.samples.empty(), light.twoSided, cell.x, cell.y, cell.z, red, blue);
}

class TreeBuilder {
  public:
    TreeBuilder(std::vector<LightSummary> lights, std::uint32_t firstGroup)
        : lights_(std::move(lights)), firstGroup_(firstGroup) {}

    LightTree build() {
        std::ranges::stable_sort(lights_, {}, [](const LightSummary& light) {
            return std::tuple(listOf(light.place.kind), groupKey(light));
        });
        const std::span<LightSummary> all(lights_);
        std::size_t first = 0;
        for (std::uint32_t list = 0; list < shared::kListKindCount; ++list) {
            std::size_t end = first;
            while (end < all.size() && listOf(all[end].place.kind) == list) ++end;
            if (end > first) addKeys(all.subspan(first, end - first));
            tree_.nodeEnds[list] = static_cast<std::uint32_t>(tree_.nodes.size());
            first = end;
        }
        return std::move(tree_);
    }

  private:
    /// Adds a node over lights of one kind, which lie by their keys.
    void addKeys(std::span<LightSummary> lights) {
        if (groupKey(lights.front()) == groupKey(lights.back())) return addNear(lights);
        // The border between keys that is nearest to the middle.
        const auto isBorder = [&](std::size_t i) {
            return groupKey(lights[i - 1]) != groupKey(lights[i]);
        };
        std::size_t middle = lights.size() / 2;
        for (std::size_t step = 0; step < lights.size(); ++step) {
            const std::size_t below = lights.size() / 2 - std::min(step, lights.size() / 2 - 1);
            const std::size_t above = std::min(lights.size() / 2 + step, lights.size() - 1);
            if (below > 0 && isBorder(below)) {
                middle = below;
                break;
            }
            if (above > 0 && isBorder(above)) {
                middle = above;
                break;
            }
        }
        const std::size_t node = beginNode();
        addKeys(lights.first(middle));
        addKeys(lights.subspan(middle));
        endNode(node, lights);
    }

    /// The same over lights of one key, in halves along the longest side of their box.
    void addNear(std::span<LightSummary> lights) {
        const std::size_t node = beginNode();
        if (lights.size() > 1) {
            glm::dvec3 low(lights.front().center), high(low);
            for (const LightSummary& light : lights) {
                low = glm::min(low, light.center);
                high = glm::max(high, light.center);
            }
            const glm::dvec3 size = high - low;
            const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
            const std::size_t middle = lights.size() / 2;
            std::ranges::nth_element(lights, lights.begin() + static_cast<std::ptrdiff_t>(middle),
                                     {}, [axis](const LightSummary& l) { return l.center[axis]; });
            addNear(lights.first(middle));
            addNear(lights.subspan(middle));
        }
        endNode(node, lights);
    }

    std::size_t beginNode() {
        tree_.nodes.emplace_back();
        return tree_.nodes.size() - 1;
    }

    /// What is below it is there by now.
    void endNode(std::size_t index, std::span<const LightSummary> lights) {
        shared::LightNodeData data{};
        glm::dvec3 flux(0.0), radiance(0.0);
        double range = 0.0;
        for (const LightSummary& light : lights) {
            flux += light.area * light.radiance;
            radiance += light.radiance;
            range = std::max(range, light.range);
        }
        const bool isOneKey = groupKey(lights.front()) == groupKey(lights.back());
        const bool isParallelogram =
            lights.size() == 1 && lights.front().place.kind == LightKind::parallelogram;
        std::optional<LightGroup> group;
        if (lights.size() <= kMostInGroup && isOneKey && !isParallelogram) {
            group = groupLights(lights);
        }
        const glm::dvec3 center = group ? group->center : centerOf(lights);
        double radius = group ? group->radius : 0.0;
        double offPlane = 0.0;
        const bool isFlat = isOneKey && lights.front().normal != glm::dvec3(0.0);
        const glm::dvec3 normal = isFlat ? lights.front().normal : glm::dvec3(0.0);
        for (const LightSummary& light : lights) {
            radius = std::max(radius, glm::distance(light.center, center) + light.radius);
            const double off = std::abs(glm::dot(light.center - center, normal));
            offPlane = std::max(offPlane, off + light.offPlane);
        }
        // Normals of one key are not quite equal.
        if (lights.size() > 1) offPlane += shared::kParallelTolerance * radius;
        // Above what rounding to float takes off.
        data.center = glm::vec4(center, 1.00001 * radius + 1e-6 * glm::length(center));
        data.normal = glm::vec4(normal, 1.00001 * offPlane + 1e-6 * glm::length(center));
        data.flux = glm::vec4(glm::min(flux, LightSummary::kUnbounded),
                              lights.front().twoSided && isFlat ? 1.0f : 0.0f);
        data.radiance =
            glm::vec4(glm::min(radiance, LightSummary::kUnbounded),
                      std::bit_cast<float>(static_cast<std::uint32_t>(tree_.nodes.size())));
        data.group.w = static_cast<float>(range);
        const LightSummary& first = lights.front();
        if (lights.size() == 1) {
            const bool isSolid = first.tubeRadius > 0.0;
            setEntry(first.place.slot, isSolid ? shared::kLightOrPointEntry : shared::kLightEntry,
                     data);
            data.moments = glm::vec4(first.axis, first.tubeRadius);
        }
        if (group) {
            const std::uint32_t parallelogram =
                firstGroup_ + static_cast<std::uint32_t>(tree_.groups.size());
            const auto& d = group->differences;
            data.moments = glm::vec4(d[0], d[1], d[2], d[3]);
            data.group.x = static_cast<float>(group->fourthMoment);
            if (lights.size() == 1) {
                setEntry(first.place.slot, shared::kLightOrGroupEntry, data);
                data.radiance.w = std::bit_cast<float>(parallelogram);
            } else {
                setEntry(parallelogram, shared::kGroupEntry, data);
            }
            tree_.groups.push_back(group->parallelogram);
        }
        tree_.nodes[index] = data;
    }

    static glm::dvec3 centerOf(std::span<const LightSummary> lights) {
        glm::dvec3 low(lights.front().center), high(low);
        for (const LightSummary& light : lights) {
            low = glm::min(low, light.center - light.radius);
            high = glm::max(high, light.center + light.radius);
        }
        return 0.5 * (low + high);
    }

    static void setEntry(std::uint32_t entry, std::uint32_t kind, shared::LightNodeData& data) {
        data.group.y = std::bit_cast<float>(entry);
        data.group.z = std::bit_cast<float>(kind);
    }

    std::vector<LightSummary> lights_;
    std::uint32_t firstGroup_;
    LightTree tree_;
};

}  // namespace

LightTree buildLightTree(std::vector<LightSummary> lights, std::uint32_t firstGroup) {
    return TreeBuilder(std::move(lights), firstGroup).build();
}

}  // namespace polylume
