// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/light_tree.hpp"

#include <gmock/gmock.h>

#include <bit>
#include <functional>
#include <map>
#include <random>
#include <set>

#include "lighting/light_summary.hpp"

namespace polylume {
namespace {

/// What a node's bounds have to hold of a light.
struct Extent {
    std::vector<glm::dvec3> points;
    double radius = 0.0;  ///< About each of them.
    glm::dvec3 normal{0.0};
    glm::dvec3 radiance{0.0};
    double flux = 0.0;  ///< Radiance's factor.
    double range = INFINITY;
    bool twoSided = false;
};

/// The section of a list that a light is in, and its index in the arrays of shared/light_data.h.
using Entry = std::pair<std::uint32_t, std::uint32_t>;

std::uint32_t sectionOf(LightKind kind) {
    static const std::map<LightKind, std::uint32_t> kSections = {
        {LightKind::triangle, shared::kTriangleList},
        {LightKind::polygon, shared::kPolygonList},
        {LightKind::parallelogram, shared::kParallelogramList},
        {LightKind::texturedParallelogram, shared::kTexturedParallelogramList},
        {LightKind::texturedPolygon, shared::kTexturedPolygonList},
        {LightKind::disk, shared::kDiskList},
        {LightKind::ellipse, shared::kEllipseList},
        {LightKind::sphere, shared::kSphereList},
        {LightKind::tube, shared::kTubeList},
        {LightKind::punctual, shared::kPunctualList}};
    return kSections.at(kind);
}

std::map<Entry, Extent> extentsOf(const LightSet& lights, const LightPlaces& places) {
    std::map<Entry, Extent> extents;
    const auto add = [&](const LightPlace& place, Extent extent) {
        if (place.kind == LightKind::none) return;
        extents[{sectionOf(place.kind), place.slot}] = std::move(extent);
    };
    for (std::size_t i = 0; i < lights.polygons.size(); ++i) {
        const PolygonLight& light = lights.polygons[i];
        Extent extent;
        for (const glm::vec3& v : light.contours.front()) extent.points.emplace_back(v);
        glm::dvec3 area(0.0);
        for (std::size_t k = 0; k < extent.points.size(); ++k) {
            const glm::dvec3 a = extent.points[k] - extent.points[0];
            const glm::dvec3 b = extent.points[(k + 1) % extent.points.size()] - extent.points[0];
            area += 0.5 * glm::cross(a, b);
        }
        extent.flux = glm::length(area);
        if (extent.flux > 0.0) extent.normal = area / extent.flux;
        extent.radiance = glm::dvec3(light.radiance);
        extent.twoSided = light.twoSided;
        add(places.polygons[i], extent);
    }
    for (std::size_t i = 0; i < lights.ellipses.size(); ++i) {
        const EllipseLight& light = lights.ellipses[i];
        Extent extent;
        const glm::dvec3 x(light.halfAxisX), y(light.halfAxisY);
        for (int k = 0; k < 32; ++k) {
            const double angle = k * 0.19634954;
            extent.points.push_back(glm::dvec3(light.center) + std::cos(angle) * x +
                                    std::sin(angle) * y);
        }
        extent.normal = glm::normalize(glm::cross(x, y));
        extent.flux = 3.14159265 * glm::length(glm::cross(x, y));
        extent.radiance = glm::dvec3(light.radiance);
        extent.twoSided = light.twoSided;
        add(places.ellipses[i], extent);
    }
    for (std::size_t i = 0; i < lights.spheres.size(); ++i) {
        const SphereLight& light = lights.spheres[i];
        add(places.spheres[i], {.points = {glm::dvec3(light.center)},
                                .radius = light.radius,
                                .radiance = glm::dvec3(light.radiance),
                                .flux = 3.14159265 * light.radius * light.radius});
    }
    for (std::size_t i = 0; i < lights.tubes.size(); ++i) {
        const TubeLight& light = lights.tubes[i];
        add(places.tubes[i], {.points = {glm::dvec3(light.start), glm::dvec3(light.end)},
                              .radius = light.radius,
                              .radiance = glm::dvec3(light.radiance)});
    }
    for (std::size_t i = 0; i < lights.punctuals.size(); ++i) {
        const PunctualLight& light = lights.punctuals[i];
        Extent extent;
        extent.radiance = glm::dvec3(1e29);
        if (light.kind != PunctualLightKind::directional) {
            extent.points = {glm::dvec3(light.position)};
            extent.range = std::min(light.range, 9e29f);
        } else {
            // Anywhere.
            extent.points = {glm::dvec3(1e15, 0, 0), glm::dvec3(0, -1e15, 0)};
            extent.range = 9e29;
        }
        add(places.punctuals[i], extent);
    }
    return extents;
}

/// Reads a tree as passes/light_lists.comp does, and checks all that it counts on.
class TreeCheck {
  public:
    TreeCheck(const LightSet& lights, std::uint32_t firstGroup = 1000) : firstGroup_(firstGroup) {
        const PackedLights packed = packLights(lights);
        extents_ = extentsOf(lights, packed.places);
        tree_ = buildLightTree(summarizeLights(lights, packed.places,
                                               std::vector<float>(lights.polygons.size(), 1.0f)),
                               firstGroup);
    }

    LightTree& tree() { return tree_; }
    std::size_t lightCount() const { return extents_.size(); }

    /// How many nodes are wrong; the first of them in words.
    int countErrors(std::string* message = nullptr) {
        errors_ = 0;
        message_.clear();
        std::set<Entry> found;
        std::uint32_t node = 0;
        for (std::uint32_t list = 0; list < shared::kListKindCount; ++list) {
            const std::uint32_t end = tree_.nodeEnds[list];
            while (node < end && errors_ == 0) {
                const std::vector<Entry> below = visit(node, list, end);
                for (const Entry& entry : below) {
                    check(found.insert(entry).second, node, "a light twice");
                }
                const std::uint32_t next = skipOf(node);
                check(next > node && next <= end, node, "skip");
                if (next <= node) break;
                node = next;
            }
            check(node == end || errors_ > 0, node, "end of a kind");
        }
        check(node == tree_.nodes.size(), node, "end");
        check(found.size() == extents_.size(), node, "all lights");
        if (message != nullptr) *message = message_;
        return errors_;
    }

    std::uint32_t skipOf(std::uint32_t node) const {
        // A leaf for which a group may stand has that in its place.
        if (kindOf(node) == shared::kLightOrGroupEntry) return node + 1;
        return std::bit_cast<std::uint32_t>(tree_.nodes[node].radiance.w);
    }

  private:
    std::uint32_t kindOf(std::uint32_t node) const {
        return std::bit_cast<std::uint32_t>(tree_.nodes[node].group.z);
    }

    void check(bool holds, std::uint32_t node, const char* what) {
        if (holds) return;
        if (errors_++ == 0) message_ = "node " + std::to_string(node) + ": " + what;
    }

    std::vector<Entry> visit(std::uint32_t node, std::uint32_t list, std::uint32_t end) {
        if (node >= end) {
            check(false, node, "beyond its kind");
            return {};
        }
        const shared::LightNodeData& data = tree_.nodes[node];
        const std::uint32_t kind = kindOf(node);
        const std::uint32_t index = std::bit_cast<std::uint32_t>(data.group.y);
        std::vector<Entry> below;
        const bool isSolid = list == shared::kSphereList || list == shared::kTubeList;
        if (kind == shared::kLightEntry || kind == shared::kLightOrGroupEntry ||
            kind == shared::kLightOrPointEntry) {
            check((kind == shared::kLightOrPointEntry) == isSolid, node, "what has a point");
            check(skipOf(node) == node + 1, node, "skip of a leaf");
            check(extents_.contains({list, index}), node, "no such light");
            if (!extents_.contains({list, index})) return {};
            below = {{list, index}};
        } else {
            int childCount = 0;
            std::uint32_t child = node + 1;
            while (child < skipOf(node) && errors_ == 0) {
                const std::vector<Entry> more = visit(child, list, end);
                below.insert(below.end(), more.begin(), more.end());
                if (skipOf(child) <= child) break;
                child = skipOf(child);
                ++childCount;
            }
            check(child == skipOf(node), node, "skip of an inner node");
            check(childCount == 2, node, "two below it");
            check(kind == shared::kNoEntry || kind == shared::kGroupEntry, node, "kind");
        }
        checkBounds(node, below);
        if (kind == shared::kGroupEntry) checkGroup(node, index);
        if (kind == shared::kLightOrGroupEntry) {
            check(list != shared::kParallelogramList, node, "a group for a parallelogram");
            checkGroup(node, std::bit_cast<std::uint32_t>(data.radiance.w));
        }
        return below;
    }

    void checkBounds(std::uint32_t node, const std::vector<Entry>& below) {
        const shared::LightNodeData& data = tree_.nodes[node];
        const glm::dvec3 center(data.center);
        const glm::dvec3 normal(data.normal);
        glm::dvec3 flux(0.0), radiance(0.0);
        double range = 0.0;
        for (const Entry& entry : below) {
            const Extent& extent = extents_.at(entry);
            flux += extent.flux * extent.radiance;
            radiance += extent.radiance;
            range = std::max(range, extent.range);
            for (const glm::dvec3& point : extent.points) {
                check(glm::distance(point, center) + extent.radius <= data.center.w, node,
                      "sphere");
                if (normal == glm::dvec3(0.0)) continue;
                check(std::abs(glm::dot(point - center, normal)) <= data.normal.w, node, "plane");
            }
            if (normal == glm::dvec3(0.0)) {
                check(data.flux.w == 0.0f, node, "sides of no plane");
                continue;
            }
            check(glm::distance(extent.normal, normal) <= shared::kParallelTolerance + 1e-6, node,
                  "normal");
            check((data.flux.w > 0.0f) == extent.twoSided, node, "sides");
        }
        // float rounds by half of 1.2e-7.
        for (int c = 0; c < 3; ++c) {
            check(data.flux[c] >= std::min(flux[c] * (1.0 - 1e-6), 1e29), node, "flux");
            check(data.radiance[c] >= std::min(radiance[c] * (1.0 - 1e-6), 1e29), node, "radiance");
        }
        check(data.group.w >= std::min(range, 9e29) * (1.0 - 1e-6), node, "range");
        for (int i = 0; i < 4; ++i) {
            check(std::isfinite(data.center[i]) && std::isfinite(data.flux[i]) &&
                      std::isfinite(data.moments[i]),
                  node, "finite");
            // A tube has its axis there.
            const bool isMoment = below.size() > 1 || below[0].first != shared::kTubeList;
            check(data.moments[i] >= 0.0f || !isMoment, node, "moments");
        }
    }

    void checkGroup(std::uint32_t node, std::uint32_t index) {
        const shared::LightNodeData& data = tree_.nodes[node];
        check(index >= firstGroup_ && index - firstGroup_ < tree_.groups.size(), node, "group");
        if (index < firstGroup_ || index - firstGroup_ >= tree_.groups.size()) return;
        const shared::ParallelogramData& group = tree_.groups[index - firstGroup_];
        const glm::dvec3 center(data.center), normal(data.normal);
        const glm::dvec3 corner(group.corner), x(group.edgeX), y(group.edgeY);
        for (const glm::dvec3& point : {corner, corner + x, corner + y, corner + x + y}) {
            check(glm::distance(point, center) <= data.center.w, node, "sphere of the group");
            check(std::abs(glm::dot(point - center, normal)) <= data.normal.w, node,
                  "plane of the group");
        }
        check((group.corner.w > 0.0f) == (data.flux.w > 0.0f), node, "sides of the group");
        const double area = glm::length(glm::cross(x, y));
        for (int c = 0; c < 3; ++c) {
            const double flux = area * static_cast<double>(group.radiance[c]);
            check(std::abs(flux - data.flux[c]) <= 1e-4 * data.flux[c] + 1e-30, node,
                  "flux of the group");
        }
    }

    std::uint32_t firstGroup_;
    std::map<Entry, Extent> extents_;
    LightTree tree_;
    int errors_ = 0;
    std::string message_;
};

class RandomLights {
  public:
    explicit RandomLights(unsigned seed) : generator_(seed) {}

    float uniform(float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(generator_);
    }
    glm::vec3 vector() { return {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}; }

    /// Some of a few planes, so that there are groups.
    PolygonLight polygon(float scale, int sides) {
        const int facade = static_cast<int>(uniform(0, 3));
        glm::vec3 x(1, 0, 0), y(0, 1, 0);
        if (facade == 1) x = {0, 0, 1};
        if (facade == 2) x = glm::normalize(vector()), y = glm::normalize(glm::cross(x, vector()));
        const glm::vec3 corner = scale * vector();
        const float width = scale * uniform(0.01f, 0.3f), height = scale * uniform(0.01f, 0.3f);
        PolygonLight light;
        light.contours = {{corner, corner + width * x, corner + width * x + height * y}};
        if (sides > 3) light.contours[0].push_back(corner + height * y);
        if (sides > 4) light.contours[0].push_back(corner - 0.3f * width * x + 0.5f * height * y);
        light.radiance = uniform(0, 1) < 0.7f ? glm::vec3(100.0f) : glm::vec3(100, 50, 2);
        light.twoSided = uniform(0, 1) < 0.2f;
        return light;
    }

    LightSet lights(int count, float scale, const glm::vec3& offset) {
        LightSet set;
        for (int i = 0; i < count; ++i) {
            switch (static_cast<int>(uniform(0, 9))) {
                case 0:
                    set.ellipses.push_back({offset + scale * vector(),
                                            {0.1f * scale, 0, 0},
                                            {0, 0.1f * scale, 0},
                                            glm::vec3(20.0f)});
                    break;
                case 1:
                    set.ellipses.push_back({offset + scale * vector(),
                                            {0.1f * scale, 0, 0},
                                            {0, 0, 0.03f * scale},
                                            glm::vec3(20.0f),
                                            true});
                    break;
                case 2:
                    set.spheres.push_back(
                        {offset + scale * vector(), uniform(0.01f, 0.2f) * scale});
                    break;
                case 3: {
                    const glm::vec3 start = offset + scale * vector();
                    set.tubes.push_back({start, start + 0.3f * scale * vector(), 0.01f * scale});
                    break;
                }
                case 4: {
                    PunctualLight lamp;
                    lamp.position = offset + scale * vector();
                    if (uniform(0, 1) < 0.5f) lamp.range = scale * uniform(0.1f, 3.0f);
                    if (uniform(0, 1) < 0.2f) lamp.kind = PunctualLightKind::directional;
                    set.punctuals.push_back(lamp);
                    break;
                }
                default: {
                    set.polygons.push_back(polygon(scale, static_cast<int>(uniform(3, 6))));
                    for (glm::vec3& v : set.polygons.back().contours[0]) v += offset;
                    break;
                }
            }
        }
        return set;
    }

  private:
    std::mt19937 generator_;
};

TEST(LightTreeTest, holdsEveryLightOnceWithinItsBounds) {
    std::size_t groupCount = 0;
    for (unsigned seed = 0; seed < 12; ++seed) {
        const int count = std::array{1, 2, 3, 33, 200, 700}[seed % 6];
        const float scale = std::array{1.0f, 1e-3f, 1e5f}[seed % 3];
        TreeCheck check(RandomLights(seed).lights(count, scale, glm::vec3(0.0f)));
        std::string message;
        EXPECT_EQ(check.countErrors(&message), 0) << "seed " << seed << " " << message;
        EXPECT_EQ(check.lightCount(), static_cast<std::size_t>(count));
        groupCount += check.tree().groups.size();
    }
    EXPECT_GT(groupCount, 100u);
}

TEST(LightTreeTest, holdsLightsFarFromTheOrigin) {
    for (unsigned seed = 0; seed < 4; ++seed) {
        TreeCheck check(RandomLights(seed).lights(100, 10.0f, {1e5f, -2e4f, 7e4f}));
        std::string message;
        EXPECT_EQ(check.countErrors(&message), 0) << "seed " << seed << " " << message;
    }
}

TEST(LightTreeTest, ofNoLightsIsEmpty) {
    const LightTree tree = buildLightTree({}, 0);
    EXPECT_TRUE(tree.nodes.empty());
    EXPECT_TRUE(tree.groups.empty());
    EXPECT_EQ(tree.nodeEnds.back(), 0u);
}

TEST(LightTreeTest, manyEqualLightsAtOnePlace) {
    LightSet set;
    set.polygons.assign(600, RandomLights(1).polygon(1.0f, 4));
    set.spheres.assign(300, {});
    set.punctuals.assign(300, {});
    TreeCheck check(set);
    std::string message;
    EXPECT_EQ(check.countErrors(&message), 0) << message;
    EXPECT_FALSE(check.tree().groups.empty());
}

TEST(LightTreeTest, lightsInARow) {
    LightSet set;
    for (int i = 0; i < 100; ++i) {
        PolygonLight light;
        const float x = static_cast<float>(i);
        light.contours = {{{x, 0, 0}, {x + 0.5f, 0, 0}, {x + 0.5f, 1e-4f, 0}, {x, 1e-4f, 0}}};
        set.polygons.push_back(light);
    }
    TreeCheck check(set);
    std::string message;
    EXPECT_EQ(check.countErrors(&message), 0) << message;
    EXPECT_EQ(check.tree().groups.size(), 99u);
}

TEST(LightTreeTest, lightsWithoutRadiance) {
    LightSet set;
    RandomLights random(5);
    for (int i = 0; i < 60; ++i) {
        PolygonLight light = random.polygon(1.0f, 4);
        light.radiance = std::array{glm::vec3(0.0f), glm::vec3(0, 5, 0), glm::vec3(5, 0, 5),
                                    glm::vec3(1e30f)}[i % 4];
        set.polygons.push_back(light);
    }
    TreeCheck check(set);
    std::string message;
    EXPECT_EQ(check.countErrors(&message), 0) << message;
}

TEST(LightTreeTest, nearlyParallelLightsStayWithinTheTolerance) {
    // Normals all about one, by up to three times the tolerance.
    RandomLights random(9);
    LightSet set;
    for (int i = 0; i < 300; ++i) {
        const float angle = 4e-4f * random.uniform(-3, 3);
        const float other = 4e-4f * random.uniform(-3, 3);
        PolygonLight light;
        const glm::vec3 corner = random.vector();
        const glm::vec3 x(1, 0, angle), y(0, 1, other);
        light.contours = {{corner, corner + x, corner + x + y, corner + y}};
        set.polygons.push_back(light);
    }
    TreeCheck check(set);
    std::string message;
    EXPECT_EQ(check.countErrors(&message), 0) << message;
    EXPECT_GT(check.tree().groups.size(), 50u);
}

TEST(LightTreeTest, sidesAreNotMixed) {
    LightSet set;
    for (int i = 0; i < 20; ++i) {
        set.polygons.push_back(RandomLights(2).polygon(1.0f, 4));
        set.polygons.back().twoSided = i % 2 == 0;
    }
    TreeCheck check(set);
    std::string message;
    EXPECT_EQ(check.countErrors(&message), 0) << message;
}

TEST(LightTreeTest, theCheckFindsBrokenTrees) {
    const LightSet set = RandomLights(4).lights(100, 1.0f, glm::vec3(0.0f));
    const auto countAfter = [&](const std::function<void(LightTree&)>& change) {
        TreeCheck check(set);
        change(check.tree());
        return check.countErrors();
    };
    EXPECT_EQ(countAfter([](LightTree&) {}), 0);
    EXPECT_GT(countAfter([](LightTree& tree) { tree.nodes[0].center.w *= 0.9f; }), 0);
    EXPECT_GT(countAfter([](LightTree& tree) { tree.nodes[0].center.x += 0.5f; }), 0);
    EXPECT_GT(
        countAfter([](LightTree& tree) { tree.nodes[0].radiance.w = std::bit_cast<float>(2u); }),
        0);
    EXPECT_GT(countAfter([](LightTree& tree) { std::swap(tree.nodes[1], tree.nodes[2]); }), 0);
    EXPECT_GT(countAfter([](LightTree& tree) { --tree.nodeEnds[shared::kTubeList]; }), 0);
    EXPECT_GT(countAfter([](LightTree& tree) { tree.nodes.back().group.w = 0.0f; }), 0);
    EXPECT_GT(countAfter([](LightTree& tree) { tree.nodes.back().flux.x *= 0.99f; }), 0);
    EXPECT_GT(countAfter([](LightTree& tree) { tree.groups[0].corner.x += 5.0f; }), 0);
    EXPECT_GT(countAfter([](LightTree& tree) {
                  tree.nodes.back().group.y = tree.nodes[tree.nodes.size() - 2].group.y;
              }),
              0);
}

}  // namespace
}  // namespace polylume
