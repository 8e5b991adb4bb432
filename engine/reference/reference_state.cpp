// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/reference_state.hpp"

#include <cstring>
#include <span>

#include "core/text.hpp"
#include "lights/lighting_model_names.hpp"
#include "polylume/error.hpp"
#include "reference/scrambled_points.hpp"
#include "view/scene_lights.hpp"

namespace polylume::reference {
namespace {

constexpr std::size_t kValueCount = sizeof(PixelState) / sizeof(float);
static_assert(kValueCount == 6 + 3 * ReferenceTracer::kReplicateCount);
static_assert(std::is_trivially_copyable_v<PixelState>);

constexpr std::string_view kDigest = " digest";
constexpr const char* kPrefix = "polylume:state.";

/// In the order of PixelState.
std::vector<std::string> channelNames() {
    std::vector<std::string> names = {"state.emitted.R", "state.emitted.G", "state.emitted.B",
                                      "state.coverage.Y"};
    for (int r = 0; r < ReferenceTracer::kReplicateCount; ++r) {
        for (const char* color : {"R", "G", "B"}) {
            names.push_back(concat("state.replicate", r, ".", color));
        }
    }
    names.emplace_back("state.paths.Y");
    names.emplace_back("state.wanted.Y");
    return names;
}

/// A running hash of values and arrays of plain data.
class Digest {
  public:
    template <typename Value>
    void add(const Value& value) {
        static_assert(std::is_arithmetic_v<Value> || std::is_enum_v<Value>);
        addBytes(std::as_bytes(std::span(&value, 1)));
    }
    template <typename Value>
    void add(const std::vector<Value>& values) {
        add(values.size());
        addBytes(std::as_bytes(std::span(values)));
    }
    template <int N>
    void add(const glm::vec<N, float>& v) {
        for (int i = 0; i < N; ++i) add(v[i]);
    }
    template <int C, int R>
    void add(const glm::mat<C, R, float>& m) {
        for (int i = 0; i < C; ++i) add(m[i]);
    }
    std::uint64_t value() const { return value_; }

  private:
    void addBytes(std::span<const std::byte> bytes) {
        while (!bytes.empty()) {
            std::uint64_t word = bytes.size();
            const std::size_t count = std::min<std::size_t>(bytes.size(), sizeof(word));
            std::memcpy(&word, bytes.data(), count);
            value_ = hash(value_, word);
            bytes = bytes.subspan(count);
        }
    }

    std::uint64_t value_ = 0;
};

void add(Digest& digest, const LightTexture& texture) {
    digest.add(texture.image->size.x);
    digest.add(texture.image->size.y);
    digest.add(texture.image->texels);
    for (const glm::vec3& v : {texture.origin, texture.axisU, texture.axisV}) digest.add(v);
    digest.add(texture.wrapU);
    digest.add(texture.wrapV);
}

void add(Digest& digest, const PolygonLight& light) {
    digest.add(light.contours.size());
    for (const std::vector<glm::vec3>& contour : light.contours) digest.add(contour);
    digest.add(light.radiance);
    digest.add(light.twoSided);
    digest.add(light.texture.has_value());
    if (light.texture) add(digest, *light.texture);
}

void add(Digest& digest, const EllipseLight& light) {
    for (const glm::vec3& v : {light.center, light.halfAxisX, light.halfAxisY, light.radiance}) {
        digest.add(v);
    }
    digest.add(light.twoSided);
}

void add(Digest& digest, const SphereLight& light) {
    digest.add(light.center);
    digest.add(light.radius);
    digest.add(light.radiance);
    digest.add(light.twoSided);
}

void add(Digest& digest, const TubeLight& light) {
    for (const glm::vec3& v : {light.start, light.end, light.radiance}) digest.add(v);
    digest.add(light.radius);
    digest.add(light.twoSided);
}

void add(Digest& digest, const PunctualLight& light) {
    digest.add(light.kind);
    for (const glm::vec3& v : {light.position, light.direction, light.intensity}) digest.add(v);
    for (const float f : {light.range, light.innerConeAngle, light.outerConeAngle}) digest.add(f);
}

template <typename Light>
void addAll(Digest& digest, const std::vector<Light>& lights) {
    digest.add(lights.size());
    for (const Light& light : lights) add(digest, light);
}

void add(Digest& digest, const scene::TextureSlot& slot) {
    digest.add(slot.texture);
    digest.add(slot.texCoordSet);
    digest.add(slot.uvFromTexCoord);
}

void add(Digest& digest, const scene::Material& m) {
    digest.add(m.baseColorFactor);
    for (const glm::vec3& v : {m.emissiveFactor, m.specularColorFactor, m.sheenColorFactor}) {
        digest.add(v);
    }
    for (const float f : {m.metallicFactor, m.roughnessFactor, m.normalScale, m.occlusionStrength,
                          m.ior, m.specularFactor, m.sheenRoughnessFactor, m.alphaCutoff}) {
        digest.add(f);
    }
    for (const scene::TextureSlot* slot :
         {&m.baseColor, &m.metallicRoughness, &m.normal, &m.occlusion, &m.emissive, &m.specular,
          &m.specularColor, &m.sheenColor, &m.sheenRoughness}) {
        add(digest, *slot);
    }
    digest.add(m.alphaMode);
    digest.add(m.doubleSided);
    digest.add(m.unlit);
}

std::string digestOf(const scene::Scene& scene) {
    Digest digest;
    for (const scene::Mesh& mesh : scene.meshes) {
        digest.add(mesh.positions);
        digest.add(mesh.normals);
        digest.add(mesh.tangents);
        digest.add(mesh.texCoords[0]);
        digest.add(mesh.texCoords[1]);
        digest.add(mesh.colors);
        digest.add(mesh.indices);
        digest.add(mesh.material);
    }
    for (const scene::Instance& instance : scene.instances) {
        digest.add(instance.mesh);
        digest.add(instance.worldFromObject);
    }
    for (const scene::Material& material : scene.materials) add(digest, material);
    for (const scene::Texture& texture : scene.textures) {
        digest.add(texture.image);
        digest.add(texture.colorSpace);
        digest.add(texture.sampler.magFilter);
        digest.add(texture.sampler.minFilter);
        digest.add(texture.sampler.mipFilter);
        digest.add(texture.sampler.wrapU);
        digest.add(texture.sampler.wrapV);
    }
    for (const PixelImage& image : scene.images) {
        digest.add(image.width);
        digest.add(image.channelCount);
        digest.add(image.pixels);
    }
    return concat(std::hex, digest.value());
}

std::string digestOf(const scene::Camera& camera) {
    Digest digest;
    digest.add(camera.worldFromCamera);
    if (const auto* lens = std::get_if<scene::Perspective>(&camera.projection)) {
        for (const float f : {lens->yFovRadians, lens->zNear, lens->zFar.value_or(-1.0f)}) {
            digest.add(f);
        }
    } else {
        const auto& orthographic = std::get<scene::Orthographic>(camera.projection);
        for (const float f :
             {orthographic.xMag, orthographic.yMag, orthographic.zNear, orthographic.zFar}) {
            digest.add(f);
        }
    }
    return concat(std::hex, digest.value());
}

std::string digestOf(const LightSet& lights) {
    Digest digest;
    addAll(digest, lights.polygons);
    addAll(digest, lights.ellipses);
    addAll(digest, lights.spheres);
    addAll(digest, lights.tubes);
    addAll(digest, lights.punctuals);
    return concat(std::hex, digest.value());
}

std::string exact(const glm::vec3& v) {
    std::string text;
    for (int i = 0; i < 3; ++i) text += concat(i == 0 ? "" : ",", formatNumber("%.9g", v[i]));
    return text;
}

}  // namespace

FloatImage ReferenceState::toImage(const std::map<std::string, std::string>& attributes) const {
    FloatImage image;
    image.width = size.x;
    image.height = size.y;
    image.channelNames = channelNames();
    image.pixels.resize(pixels.size() * kValueCount);
    std::memcpy(image.pixels.data(), pixels.data(), pixels.size() * sizeof(PixelState));
    for (const auto& [name, value] : attributes) image.metadata[kPrefix + name] = value;
    return image;
}

ReferenceState ReferenceState::fromImage(const FloatImage& image,
                                         const std::map<std::string, std::string>& attributes) {
    std::vector<std::size_t> places;
    for (const std::string& name : channelNames()) {
        const std::optional<std::size_t> place = image.channelIndex(name);
        if (!place) throw Error(concat("expected the channel ", name, " of an interrupted run"));
        places.push_back(*place);
    }
    for (const auto& [name, value] : attributes) {
        const auto found = image.metadata.find(kPrefix + name);
        const auto* text =
            found == image.metadata.end() ? nullptr : std::get_if<std::string>(&found->second);
        if (text == nullptr) throw Error(concat("expected the attribute ", kPrefix, name));
        if (*text != value && name.ends_with(kDigest)) {
            const std::string what = name.substr(0, name.size() - kDigest.size());
            throw Error(concat("expected a run of the same ", what,
                               ", found one of another; use the "
                               "same files and flags, or start anew"));
        }
        if (*text != value) {
            throw Error(concat("expected a run with ", name, " ", value, ", found one with ", *text,
                               "; use the same scene and flags, or start anew"));
        }
    }
    const std::string size = concat(image.width, "x", image.height);
    if (size != attributes.at("size")) {
        throw Error(concat("expected an interrupted run of ", attributes.at("size"),
                           " pixels, found ", size, "; the file is damaged, start anew"));
    }
    ReferenceState state;
    state.size = {image.width, image.height};
    state.pixels.resize(static_cast<std::size_t>(image.width) * image.height);
    for (std::size_t i = 0; i < state.pixels.size(); ++i) {
        float values[kValueCount];
        for (std::size_t c = 0; c < kValueCount; ++c) {
            values[c] = image.pixels[i * image.channelCount() + places[c]];
        }
        std::memcpy(&state.pixels[i], values, sizeof(values));
    }
    return state;
}

std::map<std::string, std::string> stateAttributes(const scene::Scene& scene,
                                                   const scene::Camera& camera,
                                                   const ReferenceOptions& options) {
    const auto flag = [](bool value) { return value ? "on" : "off"; };
    const auto& background = options.background;
    return {
        {"version", "3"},
        {"scene digest", digestOf(scene)},
        {"camera digest", digestOf(camera)},
        {"lights digest", digestOf(lightsOf(scene, options))},
        {"size", concat(options.size.x, "x", options.size.y)},
        {"samples", concat(options.sampleCount)},
        {"spp", concat(options.pathCount)},
        {"target error", formatNumber("%.17g", options.targetError.value_or(0.0))},
        {"seed", concat(options.seed)},
        {"shadows", flag(options.shadows)},
        {"depth", concat(options.depth)},
        {"lobes", nameOf(options.lobes)},
        {"specular", nameOf(options.model.specular)},
        {"diffuse", nameOf(options.model.diffuse)},
        {"light sampling", options.lightSampling == LightSampling::area ? "area" : "solid angle"},
        {"hidden lights", flag(options.hideLights)},
        {"background", background ? exact(*background) : "none"},
    };
}

}  // namespace polylume::reference
