// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/emissive_lights.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/log.hpp"
#include "core/text.hpp"
#include "polylume/error.hpp"
#include "scene/emissive_texture.hpp"
#include "scene/planar_patches.hpp"
#include "scene/texture_plane.hpp"
#include "scene/welded_triangles.hpp"

namespace polylume::scene {
namespace {

/// Lights from one mesh that make a warning.
constexpr std::size_t kManyLights = 64;

/// What the log says of a mesh.
struct MeshCount {
    std::size_t triangles = 0;
    std::size_t surfaces = 0;
    std::size_t planes = 0;
    std::size_t lights = 0;
};

/// "1 light", "2 lights"
std::string counted(std::size_t count, const char* noun) {
    return concat(count, " ", noun, count == 1 ? "" : "s");
}

bool isEmissive(const Material& material) {
    return !material.unlit && material.emissiveFactor != glm::vec3(0.0f);
}

/// Makes the lights of one scene.
class EmissiveLights {
  public:
    explicit EmissiveLights(Scene& scene) : scene_(scene) {}

    void add() {
        std::map<int, MeshCount> counts;
        for (const Instance& instance : scene_.instances) {
            Material& material =
                scene_.materials[static_cast<std::size_t>(meshOf(instance).material)];
            if (!isEmissive(material)) continue;
            material.emissionIsLight = true;
            addInstance(instance, material, counts[instance.mesh]);
        }
        for (const auto& [mesh, count] : counts) report(mesh, count);
    }

  private:
    const Mesh& meshOf(const Instance& instance) const {
        return scene_.meshes[static_cast<std::size_t>(instance.mesh)];
    }

    void addInstance(const Instance& instance, const Material& material, MeshCount& count) {
        const EmissiveTexture* texture = textureOf(material);
        const std::vector<SurfaceTriangle> lit = litTriangles(instance, material, texture);
        const WeldedTriangles welded = weld(lit);
        count.triangles += welded.triangles.size();
        count.surfaces += static_cast<std::size_t>(welded.surfaceCount);
        std::vector<Patch> patches = planarPatches(welded, std::nullopt);
        count.planes += patches.size();
        if (texture != nullptr) patches = planarPatches(welded, texture->size());
        for (const Patch& patch : patches)
            addPatch(instance, material, texture, welded, patch, count);
    }

    /// The texture's picture, made once for all materials that show it; null for none.
    const EmissiveTexture* textureOf(const Material& material) {
        if (material.emissive.texture < 0) return nullptr;
        auto& texture = textures_[material.emissive.texture];
        if (!texture) {
            const Texture& source =
                scene_.textures[static_cast<std::size_t>(material.emissive.texture)];
            texture = std::make_unique<EmissiveTexture>(
                scene_.images[static_cast<std::size_t>(source.image)], source.sampler);
        }
        return texture.get();
    }

    std::vector<SurfaceTriangle> litTriangles(const Instance& instance, const Material& material,
                                              const EmissiveTexture* texture) const {
        const Mesh& mesh = meshOf(instance);
        const auto& texCoords = mesh.texCoords[material.emissive.texCoordSet];
        const glm::dmat3 uvFromTexCoord(material.emissive.uvFromTexCoord);
        const glm::dmat4 worldFromObject(instance.worldFromObject);
        // Mirroring turns the winding, and the front stays the front.
        const bool isMirrored = glm::determinant(glm::dmat3(worldFromObject)) < 0.0;
        std::vector<SurfaceTriangle> lit;
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            SurfaceTriangle triangle;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t vertex = mesh.indices[i + (isMirrored ? 2 - k : k)];
                triangle.positions[k] =
                    glm::dvec3(worldFromObject * glm::dvec4(mesh.positions[vertex], 1.0));
                if (texture == nullptr || texCoords.empty()) continue;
                const glm::dvec2 texCoord(uvFromTexCoord * glm::dvec3(texCoords[vertex], 1.0));
                if (std::isfinite(texCoord.x + texCoord.y)) triangle.texCoords[k] = texCoord;
            }
            if (texture == nullptr || !texture->isBlack(triangle.texCoords))
                lit.push_back(triangle);
        }
        return lit;
    }

    void addPatch(const Instance& instance, const Material& material,
                  const EmissiveTexture* texture, const WeldedTriangles& welded, const Patch& patch,
                  MeshCount& count) {
        const std::vector<std::vector<glm::dvec3>> contours = patchContours(welded, patch);
        PolygonLight light;
        for (const auto& contour : contours) {
            light.contours.emplace_back(contour.begin(), contour.end());
        }
        if (!isValid(light)) {
            // Rounding or overlaps; triangles alone always do, but for those of no extent.
            if (patch.size() == 1) return;
            for (const int t : patch) addPatch(instance, material, texture, welded, {t}, count);
            return;
        }
        light.radiance = material.emissiveFactor;
        if (material.alphaMode == AlphaMode::blend) light.radiance *= material.baseColorFactor.a;
        light.twoSided = material.doubleSided;
        light.shownBySurface = true;
        if (texture != nullptr) texture->placeOn(welded, patch, light);
        const Mesh& mesh = meshOf(instance);
        const std::string& name = instance.name.empty() ? mesh.name : instance.name;
        scene_.areaLights.push_back(
            {name, std::move(light), concat(scene_.name, ": emissive mesh \"", mesh.name, "\"")});
        ++count.lights;
    }

    static bool isValid(const PolygonLight& light) {
        if (light.contours.empty()) return false;
        try {
            checkLights({{light}, {}});
        } catch (const Error&) {
            return false;
        }
        return true;
    }

    void report(int meshIndex, const MeshCount& count) const {
        const Mesh& mesh = scene_.meshes[static_cast<std::size_t>(meshIndex)];
        const Material& material = scene_.materials[static_cast<std::size_t>(mesh.material)];
        std::string text = concat(scene_.name, ": emissive mesh \"", mesh.name, "\" of ",
                                  counted(count.triangles, "triangle"), ": ",
                                  counted(count.lights, "polygon light"));
        if (count.planes > count.surfaces) {
            text += concat("; not planar: ", counted(count.surfaces, "connected surface"),
                           " split into ", count.planes, " planar ones");
        }
        if (count.lights > count.planes) text += "; split further where the texture bends";
        log(LogLevel::info, text);
        if (material.alphaMode != AlphaMode::opaque && material.baseColor.texture >= 0) {
            log(LogLevel::warning,
                concat(scene_.name, ": emissive mesh \"", mesh.name,
                       "\" has an alpha texture, which its lights do not follow"));
        }
        if (count.lights > kManyLights) {
            log(LogLevel::warning,
                concat(scene_.name, ": emissive mesh \"", mesh.name, "\" became ", count.lights,
                       " polygon lights, and every pixel takes time for each; put a sphere, a tube "
                       "or a few rectangles of POLYLUME_lights_area in its place, or make it of "
                       "fewer triangles"));
        }
    }

    Scene& scene_;
    std::map<int, std::unique_ptr<EmissiveTexture>> textures_;
};

}  // namespace

void addEmissiveLights(Scene& scene) {
    const bool hasThem = std::ranges::any_of(scene.areaLights, [](const AreaLight& light) {
        const auto* flat = std::get_if<PolygonLight>(&light.shape);
        return flat != nullptr && flat->shownBySurface;
    });
    if (hasThem) {
        log(LogLevel::warning,
            concat(scene.name,
                   ": its emissive surfaces have lights in the file (shownBySurface) already; "
                   "no others are made of them"));
        return;
    }
    EmissiveLights(scene).add();
}

}  // namespace polylume::scene
