// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/polylume_light_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/limits.hpp"
#include "core/text.hpp"
#include "lights/light_outline.hpp"
#include "polylume/error.hpp"
#include "scene/gltf_value.hpp"
#include "scene/light_value.hpp"
#include "scene/texture_plane.hpp"

namespace polylume::scene {
namespace {

constexpr std::array<const char*, 5> kTypes{"rect", "polygon", "ellipse", "sphere", "tube"};

/// Of the extent of texture coordinates, how far from affine they may be.
constexpr double kLargestTexCoordError = 1e-3;

const tinygltf::Value kNone{tinygltf::Value::Object{}};

/// Whether anything is left of the light in the world.
struct HasExtent {
    bool operator()(const PolygonLight& light) const {
        const double reach = [&] {
            glm::vec3 low(INFINITY), high(-INFINITY);
            for (const glm::vec3& vertex : light.contours.front()) {
                low = glm::min(low, vertex);
                high = glm::max(high, vertex);
            }
            return glm::length(glm::dvec3(high) - glm::dvec3(low));
        }();
        return glm::length(areaVector(light.contours.front())) > 1e-9 * reach * reach;
    }
    bool operator()(const EllipseLight& light) const {
        return glm::length(light.halfAxisX) > 0.0f && glm::length(light.halfAxisY) > 0.0f;
    }
    bool operator()(const SphereLight& light) const { return light.radius > 0.0f; }
    bool operator()(const TubeLight& light) const { return light.radius > 0.0f; }
};

/// Reads one light; each member function a part of it.
class Reader {
  public:
    Reader(const GltfDocument& document, const tinygltf::Value& light, const std::string& where,
           const NodePlacement& node, LightTextureReader& textures)
        : document_(document), light_(light), where_(where), node_(node), textures_(textures) {}

    AreaLight read() {
        const std::string type = textOr(light_, "type", "");
        if (std::ranges::find(kTypes, type) == kTypes.end()) {
            fail("\"type\" to be \"rect\", \"polygon\", \"ellipse\", \"sphere\" or \"tube\"",
                 quotedName(type));
        }
        checkParts(type);
        radiance_ = readEmission(document_, light_, 1000.0, where_);
        AreaLight area;
        if (type == "rect") area.shape = rectangle();
        if (type == "polygon") area.shape = polygon();
        if (type == "ellipse") area.shape = ellipse();
        if (type == "sphere") area.shape = sphere();
        if (type == "tube") area.shape = tube();
        const bool twoSided = isSet("twoSided");
        std::visit([twoSided](auto& shape) { shape.twoSided = twoSided; }, area.shape);
        if (auto* flat = std::get_if<PolygonLight>(&area.shape)) {
            flat->shownBySurface = isSet("shownBySurface");
        }
        return area;
    }

  private:
    [[noreturn]] void fail(std::string_view expected, std::string_view found,
                           std::string_view next = "") const {
        throw Error(concat("expected ", expected, ", found ", found, " (", document_.place(where_),
                           ")", next.empty() ? "" : "; ", next));
    }

    /// Objects of other types than the light's would do nothing.
    void checkParts(const std::string& type) const {
        for (const char* part : kTypes) {
            if (part == type || !light_.Has(part)) continue;
            fail(concat("no \"", part, "\" in a light of type ", quotedName(type)), "one");
        }
        for (const char* field : {"texture", "shownBySurface"}) {
            if (!light_.Has(field) || type == "rect" || type == "polygon") continue;
            fail(concat("no \"", field, "\" on a light of type ", quotedName(type)), "one",
                 "a \"rect\" or a \"polygon\" can have one");
        }
        if (type == "polygon" && !light_.Has("polygon")) {
            fail("\"polygon\" with \"contours\"", "none");
        }
    }

    bool isSet(const char* field) const {
        return light_.Has(field) && light_.Get(field).Get<bool>();
    }

    const tinygltf::Value& part(const char* type) const {
        return light_.Has(type) ? light_.Get(type) : kNone;
    }

    /// Metres in the world of a length of the light's own.
    double worldLength(const tinygltf::Value& shape, const char* name, double otherwise,
                       double scale) const {
        const double length = scale * numberOr(shape, name, otherwise);
        checkLightExtent(document_, length, where_);
        return length;
    }

    glm::vec2 worldSize(const char* type, double scale) const {
        return {worldLength(part(type), "width", 1.0, scale),
                worldLength(part(type), "height", 1.0, scale)};
    }

    PolygonLight rectangle() {
        const LightPlacement placement = placeLight(document_, node_, where_);
        const glm::vec2 size = worldSize("rect", placement.scale);
        PolygonLight light = makeRectangle(placement.frame, size, radiance_);
        if (light_.Has("texture")) {
            light.texture = textures_.read(light_.Get("texture"), where_);
            // Seen from -Z with Y up, local +X is to the left.
            const glm::mat3& axes = placement.frame.worldFromLight;
            light.texture->axisU = -size.x * axes[0];
            light.texture->axisV = -size.y * axes[1];
            light.texture->origin =
                placement.frame.center - 0.5f * (light.texture->axisU + light.texture->axisV);
        }
        return light;
    }

    EllipseLight ellipse() const {
        const LightPlacement placement = placeLight(document_, node_, where_);
        return makeEllipse(placement.frame, worldSize("ellipse", placement.scale), radiance_);
    }

    SphereLight sphere() const {
        const LightPlacement placement = placeLight(document_, node_, where_);
        SphereLight light;
        light.center = placement.frame.center;
        light.radius =
            static_cast<float>(worldLength(part("sphere"), "radius", 0.5, placement.scale));
        light.radiance = radiance_;
        return light;
    }

    TubeLight tube() const {
        const LightPlacement placement = placeLight(document_, node_, where_);
        const double length = worldLength(part("tube"), "length", 1.0, placement.scale);
        const double radius = worldLength(part("tube"), "radius", 0.01, placement.scale);
        return makeTube(placement.frame, static_cast<float>(length), static_cast<float>(radius),
                        radiance_);
    }

    PolygonLight polygon() {
        const tinygltf::Value& shape = light_.Get("polygon");
        const tinygltf::Value& contours = shape.Get("contours");
        checkTexCoordLengths(shape);
        PolygonLight light;
        light.radiance = radiance_;
        for (std::size_t c = 0; c < contours.ArrayLen(); ++c) {
            light.contours.push_back(worldContour(contours.Get(static_cast<int>(c))));
        }
        if (!HasExtent{}(light)) return light;
        checkTurns(light);
        checkTogether(light);
        if (light_.Has("texture")) {
            light.texture = textures_.read(light_.Get("texture"), where_);
            placeTexture(shape.Get("texCoords"), light);
        }
        // Under mirroring, what was counter-clockwise from the emitting side is clockwise.
        if (glm::determinant(glm::dmat3(node_.worldFromNode)) < 0.0) {
            for (auto& contour : light.contours) std::ranges::reverse(contour);
        }
        return light;
    }

    std::vector<glm::vec3> worldContour(const tinygltf::Value& contour) const {
        std::vector<glm::vec3> vertices;
        for (std::size_t i = 0; i < contour.ArrayLen(); ++i) {
            const tinygltf::Value& vertex = contour.Get(static_cast<int>(i));
            glm::dvec4 local(0.0, 0.0, 0.0, 1.0);
            for (int axis = 0; axis < 3; ++axis) {
                local[axis] = vertex.Get(axis).GetNumberAsDouble();
            }
            const glm::dvec4 world = node_.worldFromNode * local;
            for (int axis = 0; axis < 3; ++axis) {
                checkLightExtent(document_, std::abs(world[axis]), where_);
            }
            vertices.emplace_back(world);
        }
        return vertices;
    }

    void checkTexCoordLengths(const tinygltf::Value& shape) const {
        if (!shape.Has("texCoords")) {
            if (light_.Has("texture")) fail("\"texCoords\" beside a \"texture\"", "none");
            return;
        }
        const auto lengths = [](const tinygltf::Value& contours) {
            std::string text;
            for (std::size_t c = 0; c < contours.ArrayLen(); ++c) {
                text += concat(c == 0 ? "" : ", ", contours.Get(static_cast<int>(c)).ArrayLen());
            }
            return text;
        };
        const std::string expected = lengths(shape.Get("contours"));
        const std::string found = lengths(shape.Get("texCoords"));
        if (expected == found) return;
        fail(concat("\"texCoords\" to be contours of ", expected, " elements, as \"contours\" are"),
             concat("contours of ", found));
    }

    /// What only all vertices together show.
    void checkTogether(const PolygonLight& light) const {
        try {
            checkLights({{light}, {}});
        } catch (const Error& error) {
            throw Error(concat(error.what(), " (", document_.place(where_), ")"));
        }
    }

    void checkTurns(const PolygonLight& light) const {
        const glm::dvec3 outline = areaVector(light.contours.front());
        for (std::size_t c = 1; c < light.contours.size(); ++c) {
            if (!(glm::dot(areaVector(light.contours[c]), outline) > 0.0)) continue;
            fail(concat("contours[", c,
                        "] to be a hole, which turns the other way than the outline"),
                 "one that turns the same way", "reverse its vertices");
        }
    }

    void placeTexture(const tinygltf::Value& texCoords, PolygonLight& light) const {
        std::vector<TexturedPoint> points;
        glm::dvec2 low(INFINITY), high(-INFINITY);
        for (std::size_t c = 0; c < light.contours.size(); ++c) {
            for (std::size_t i = 0; i < light.contours[c].size(); ++i) {
                const tinygltf::Value& pair =
                    texCoords.Get(static_cast<int>(c)).Get(static_cast<int>(i));
                const glm::dvec2 texCoord(pair.Get(0).GetNumberAsDouble(),
                                          pair.Get(1).GetNumberAsDouble());
                points.push_back({light.contours[c][i], texCoord});
                low = glm::min(low, texCoord);
                high = glm::max(high, texCoord);
            }
        }
        const glm::dvec3 area = areaVector(light.contours.front());
        const TexturePlane plane(points, glm::normalize(area));
        const double extent = std::max(high.x - low.x, high.y - low.y);
        if (plane.largestError(points) > kLargestTexCoordError * extent) {
            fail(
                "\"texCoords\" that are affine over the polygon, within a thousandth of their "
                "extent",
                concat("some ", plane.largestError(points), " off"));
        }
        // Whatever they mean by a picture drawn out a thousandfold, no light can show it.
        const glm::dvec2 stretch = plane.stretch();
        if (!(stretch.y > 1e-3 * stretch.x)) {
            fail("\"texCoords\" that span an area", "ones on a line or a point");
        }
        plane.placeOn(*light.texture);
    }

    const GltfDocument& document_;
    const tinygltf::Value& light_;
    const std::string& where_;
    const NodePlacement& node_;
    LightTextureReader& textures_;
    glm::vec3 radiance_{0.0f};
};

}  // namespace

std::optional<AreaLight> readPolylumeLight(const GltfDocument& document,
                                           const tinygltf::Value& light, const std::string& where,
                                           const NodePlacement& node,
                                           LightTextureReader& textures) {
    AreaLight area = Reader(document, light, where, node, textures).read();
    if (!std::visit(HasExtent{}, area.shape)) {
        document.warn(concat(where, " has no extent and does not shine"));
        return std::nullopt;
    }
    return area;
}

}  // namespace polylume::scene
