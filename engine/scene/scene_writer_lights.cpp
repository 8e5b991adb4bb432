// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/scene_writer_lights.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>

#include "lights/plane_axes.hpp"
#include "scene/exact_frame.hpp"
#include "scene/flat_frame.hpp"
#include "scene/texture_plane.hpp"

namespace polylume::scene {
namespace {

/// Of the coordinates' size, by how much a picture may miss a rectangle, and an ellipse a disk.
constexpr double kRounding = 1e-6;

double largest(const glm::vec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// "color" and "intensity" whose product in readEmission() is `emission` bit by bit.
void writeEmission(const glm::vec3& emission, OrderedJson& light) {
    const float most = largest(emission);
    float intensity = most;
    glm::vec3 color = most > 0.0f ? emission / most : glm::vec3(1.0f);
    const auto isExact = [&] {
        // The reader multiplies with the decimal number in double.
        const double asRead = shortestNumber(intensity).get<double>();
        for (int i = 0; i < 3; ++i) {
            if (static_cast<float>(color[i] * asRead) != emission[i]) {
                return false;
            }
        }
        return true;
    };
    if (!isExact()) {
        // Division by a power of two rounds nothing.
        int exponent = 0;
        std::frexp(most, &exponent);
        intensity = std::ldexp(1.0f, std::min(exponent, 127));
        color = emission / intensity;
    }
    light["color"] = {shortestNumber(color.r), shortestNumber(color.g), shortestNumber(color.b)};
    light["intensity"] = shortestNumber(intensity);
}

OrderedJson commonFields(const std::string& name, const char* type, const glm::vec3& emission) {
    OrderedJson light = OrderedJson::object();
    if (!name.empty()) light["name"] = name;
    light["type"] = type;
    writeEmission(emission, light);
    return light;
}

/// EXT_lights_area's light of the same name and emission.
OrderedJson extLightOf(const OrderedJson& light, const char* type, float size) {
    OrderedJson ext = light;
    ext["type"] = type;
    ext["size"] = shortestNumber(size);
    return ext;
}

/// Whether the picture fills the rectangle, upright as seen from the emitting side.
bool fillsRectangle(const LightTexture& texture, const FlatShape& shape) {
    const glm::dvec3 axisU = -shape.size.x * shape.axes[0];
    const glm::dvec3 axisV = -shape.size.y * shape.axes[1];
    const glm::dvec3 origin = shape.center - 0.5 * (axisU + axisV);
    const double tolerance =
        4.0 * kRounding *
        std::max<double>(largest(texture.origin), glm::length(axisU) + glm::length(axisV));
    return glm::length(glm::dvec3(texture.origin) - origin) <= tolerance &&
           glm::length(glm::dvec3(texture.axisU) - axisU) <= tolerance &&
           glm::length(glm::dvec3(texture.axisV) - axisV) <= tolerance;
}

/// The (u, v) of a point of the picture's plane.
glm::dvec2 texCoordOf(const LightTexture& texture, const glm::dvec3& position) {
    const glm::dvec3 u(texture.axisU), v(texture.axisV);
    const glm::dvec3 normal = glm::cross(u, v);
    const glm::dvec3 offset = position - glm::dvec3(texture.origin);
    const double scale = 1.0 / glm::dot(normal, normal);
    return {scale * glm::dot(glm::cross(offset, v), normal),
            scale * glm::dot(glm::cross(u, offset), normal)};
}

void place(const FlatShape& shape, WrittenLight& written) {
    written.translation = shape.center;
    written.rotation = glm::normalize(glm::quat_cast(shape.axes));
}

void writeFlags(const PolygonLight& light, OrderedJson& json) {
    if (light.twoSided) json["twoSided"] = true;
    if (light.shownBySurface) json["shownBySurface"] = true;
}

void writeContours(const PolygonLight& light, const WrittenLight& written, OrderedJson& polygon) {
    // In double, so that single precision reads the world's vertices back as they are.
    const glm::dmat3 axes = glm::mat3_cast(written.rotation);
    polygon["contours"] = OrderedJson::array();
    if (light.texture) polygon["texCoords"] = OrderedJson::array();
    for (const auto& contour : light.contours) {
        OrderedJson vertices = OrderedJson::array();
        OrderedJson texCoords = OrderedJson::array();
        for (const glm::vec3& vertex : contour) {
            const glm::dvec3 world(vertex);
            const glm::dvec3 local = glm::transpose(axes) * (world - written.translation);
            vertices.push_back({local.x, local.y, local.z});
            if (!light.texture) continue;
            const glm::dvec2 texCoord = texCoordOf(*light.texture, world);
            texCoords.push_back({texCoord.x, texCoord.y});
        }
        polygon["contours"].push_back(std::move(vertices));
        if (light.texture) polygon["texCoords"].push_back(std::move(texCoords));
    }
}

struct AreaLightWriter {
    const std::string& name;

    WrittenLight operator()(const PolygonLight& light) const {
        WrittenLight written;
        std::optional<FlatShape> shape = rectangleOf(light);
        const bool canBeRectangle =
            shape && (!light.texture || fillsRectangle(*light.texture, *shape));
        const bool isExact = canBeRectangle && findExactRectangle(light.contours.front(), *shape);
        written.light = commonFields(name, isExact ? "rect" : "polygon", light.radiance);
        if (shape && !light.texture && !light.twoSided && !light.shownBySurface) {
            written.extLight = extLightOf(written.light, "rect", static_cast<float>(shape->size.y));
            (*written.extLight)["rect"] = {{"aspect", shape->size.x / shape->size.y}};
        }
        writeFlags(light, written.light);
        place(shape ? *shape : polygonFrame(light), written);
        if (isExact) {
            written.light["rect"] = {{"width", shortestNumber(static_cast<float>(shape->size.x))},
                                     {"height", shortestNumber(static_cast<float>(shape->size.y))}};
        } else {
            writeContours(light, written, written.light["polygon"]);
        }
        return written;
    }

    WrittenLight operator()(const EllipseLight& light) const {
        FlatShape shape;
        shape.center = glm::dvec3(light.center);
        shape.size = 2.0 * glm::dvec2(glm::length(glm::dvec3(light.halfAxisX)),
                                      glm::length(glm::dvec3(light.halfAxisY)));
        shape.axes = rightFrame(glm::dvec3(light.halfAxisX), -glm::dvec3(light.halfAxisY));
        findExactEllipse(light, shape);
        WrittenLight written;
        place(shape, written);
        written.light = commonFields(name, "ellipse", light.radiance);
        const bool isDisk = std::abs(shape.size.x - shape.size.y) <= kRounding * shape.size.x;
        if (isDisk && !light.twoSided) {
            written.extLight = extLightOf(written.light, "disk", static_cast<float>(shape.size.x));
        }
        if (light.twoSided) written.light["twoSided"] = true;
        written.light["ellipse"] = {{"width", shortestNumber(static_cast<float>(shape.size.x))},
                                    {"height", shortestNumber(static_cast<float>(shape.size.y))}};
        return written;
    }

    WrittenLight operator()(const SphereLight& light) const {
        WrittenLight written;
        written.translation = glm::dvec3(light.center);
        written.light = commonFields(name, "sphere", light.radiance);
        if (light.twoSided) written.light["twoSided"] = true;
        written.light["sphere"] = {{"radius", shortestNumber(light.radius)}};
        return written;
    }

    WrittenLight operator()(const TubeLight& light) const {
        FlatShape shape;
        const glm::dvec3 along = glm::dvec3(light.end) - glm::dvec3(light.start);
        shape.center = 0.5 * (glm::dvec3(light.start) + glm::dvec3(light.end));
        shape.size = {glm::length(along), 0.0};
        if (shape.size.x > 0.0) {
            shape.axes = rightFrame(along, perpendicularTo(along / shape.size.x));
        }
        findExactTube(light, shape);
        WrittenLight written;
        place(shape, written);
        written.light = commonFields(name, "tube", light.radiance);
        if (light.twoSided) written.light["twoSided"] = true;
        written.light["tube"] = {{"length", shortestNumber(static_cast<float>(shape.size.x))},
                                 {"radius", shortestNumber(light.radius)}};
        return written;
    }
};

}  // namespace

OrderedJson shortestNumber(float value) {
    char text[64];
    char* const end = std::to_chars(text, text + sizeof(text) - 1, value).ptr;
    *end = '\0';
    const double number = std::strtod(text, nullptr);
    // Whole numbers without a ".0".
    if (number == std::floor(number) && std::abs(number) < 1e15) {
        return static_cast<std::int64_t>(number);
    }
    return number;
}

WrittenLight writeAreaLight(const AreaLight& area) {
    return std::visit(AreaLightWriter{area.name}, area.shape);
}

WrittenLight writePunctualLight(const PunctualLight& light) {
    constexpr const char* kTypes[] = {"directional", "point", "spot"};
    WrittenLight written;
    written.light = commonFields(light.name, kTypes[static_cast<int>(light.type)], light.intensity);
    written.translation = glm::dvec3(light.position);
    if (light.type != PunctualLightType::point) {
        const glm::dvec3 back = -glm::normalize(glm::dvec3(light.direction));
        const PlaneAxes<double> plane(back);
        written.rotation = glm::normalize(glm::quat_cast(glm::dmat3(plane.x, plane.y, back)));
    }
    // A directional light has no range.
    if (light.type != PunctualLightType::directional && std::isfinite(light.range)) {
        written.light["range"] = shortestNumber(light.range);
    }
    if (light.type == PunctualLightType::spot) {
        // A right angle in single precision lies just above it.
        constexpr double kRightAngle = 0.5 * std::numbers::pi;
        written.light["spot"] = {{"innerConeAngle", shortestNumber(light.innerConeAngle)},
                                 {"outerConeAngle", light.outerConeAngle < kRightAngle
                                                        ? shortestNumber(light.outerConeAngle)
                                                        : OrderedJson(kRightAngle)}};
    }
    return written;
}

}  // namespace polylume::scene
