// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/ray_scene.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <limits>
#include <tuple>

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::reference {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// What a filter knows of the ray that it is called for.
struct RayContext {
    RTCIntersectContext embree;  ///< First: Embree hands out a pointer to it.
    const Ray* ray;
    const SurfaceReader* reader;
    std::vector<Hit>* layers = nullptr;
};

/// A mesh within one Bvh, as its geometry knows it.
struct MeshEntry {
    unsigned index;  ///< Into RayScene's meshes.
    const WorldMesh* mesh;
};

std::vector<WorldMesh> makeMeshes(const scene::Scene& scene) {
    std::vector<WorldMesh> meshes;
    meshes.reserve(scene.instances.size());
    for (const scene::Instance& instance : scene.instances) {
        meshes.push_back(makeWorldMesh(scene, instance));
    }
    return meshes;
}

RTCRay embreeRay(const Ray& ray) {
    RTCRay result{};
    result.org_x = static_cast<float>(ray.origin.x);
    result.org_y = static_cast<float>(ray.origin.y);
    result.org_z = static_cast<float>(ray.origin.z);
    result.dir_x = static_cast<float>(ray.direction.x);
    result.dir_y = static_cast<float>(ray.direction.y);
    result.dir_z = static_cast<float>(ray.direction.z);
    result.tnear = static_cast<float>(ray.nearest);
    result.tfar = static_cast<float>(ray.farthest);
    result.mask = ~0u;
    return result;
}

Hit hitOf(const MeshEntry& entry, const RTCHit& hit, float distance) {
    return {entry.index, hit.primID, {hit.u, hit.v}, distance};
}

bool isCulled(const MeshEntry& entry, const RTCFilterFunctionNArguments& arguments,
              const Ray& ray) {
    if (!ray.isFromCamera || entry.mesh->material->doubleSided) return false;
    const auto* hit = reinterpret_cast<const RTCHit*>(arguments.hit);
    return glm::dot(entry.mesh->frontNormal(hit->primID), ray.direction) >= 0.0;
}

/// Lets pass what the camera does not see and what alpha MASK cuts out.
void filterOpaque(const RTCFilterFunctionNArguments* arguments) {
    const auto& context = *reinterpret_cast<const RayContext*>(arguments->context);
    const auto& entry = *static_cast<const MeshEntry*>(arguments->geometryUserPtr);
    if (isCulled(entry, *arguments, *context.ray)) {
        arguments->valid[0] = 0;
        return;
    }
    if (entry.mesh->material->alphaMode != scene::AlphaMode::mask) return;
    const Hit hit = hitOf(entry, *reinterpret_cast<const RTCHit*>(arguments->hit),
                          reinterpret_cast<const RTCRay*>(arguments->ray)->tfar);
    if (context.reader->alpha(*context.ray, hit) < entry.mesh->material->alphaCutoff) {
        arguments->valid[0] = 0;
    }
}

/// Notes every hit and lets the ray go on.
void filterBlended(const RTCFilterFunctionNArguments* arguments) {
    const auto& context = *reinterpret_cast<const RayContext*>(arguments->context);
    const auto& entry = *static_cast<const MeshEntry*>(arguments->geometryUserPtr);
    if (!isCulled(entry, *arguments, *context.ray)) {
        context.layers->push_back(hitOf(entry, *reinterpret_cast<const RTCHit*>(arguments->hit),
                                        reinterpret_cast<const RTCRay*>(arguments->ray)->tfar));
    }
    arguments->valid[0] = 0;
}

void checkDevice(RTCDevice device) {
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) {
        throw Error("Embree could not build the scene; there may be too little memory");
    }
}

}  // namespace

/// The meshes of one kind.
struct RayScene::Bvh {
    RTCDevice device;
    RTCScene scene;
    std::vector<MeshEntry> entries;  ///< By geometry number.

    Bvh(const std::vector<WorldMesh>& meshes, const std::vector<unsigned>& chosen, bool isBlended)
        : device(rtcNewDevice(nullptr)), scene(rtcNewScene(device)) {
        rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
        entries.reserve(chosen.size());
        for (const unsigned index : chosen) add(index, meshes[index], isBlended);
        rtcCommitScene(scene);
        checkDevice(device);
    }
    ~Bvh() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    Bvh(const Bvh&) = delete;
    Bvh& operator=(const Bvh&) = delete;

    void add(unsigned index, const WorldMesh& mesh, bool isBlended) {
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                   mesh.positions.data(), 0, sizeof(glm::vec3),
                                   mesh.positions.size() - 1);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                   mesh.mesh->indices.data(), 0, 3 * sizeof(std::uint32_t),
                                   mesh.mesh->indices.size() / 3);
        const scene::Material& material = *mesh.material;
        if (isBlended) {
            rtcSetGeometryIntersectFilterFunction(geometry, filterBlended);
        } else if (material.alphaMode == scene::AlphaMode::mask || !material.doubleSided) {
            rtcSetGeometryIntersectFilterFunction(geometry, filterOpaque);
            if (material.alphaMode == scene::AlphaMode::mask) {
                rtcSetGeometryOccludedFilterFunction(geometry, filterOpaque);
            }
        }
        entries.push_back({index, &mesh});
        rtcSetGeometryUserData(geometry, &entries.back());
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(scene, geometry, static_cast<unsigned>(entries.size() - 1));
        rtcReleaseGeometry(geometry);
    }

    /// Adds all hits in the order along the ray.
    void gather(const Ray& ray, const SurfaceReader& reader, std::vector<Hit>& hits) const {
        RayContext context{{}, &ray, &reader, &hits};
        rtcInitIntersectContext(&context.embree);
        RTCRayHit query{embreeRay(ray), {}};
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene, &context.embree, &query);
        const auto key = [](const Hit& hit) {
            return std::tuple(hit.distance, hit.mesh, hit.triangle);
        };
        std::ranges::sort(hits, {}, key);
        // A leaf may be visited twice.
        const auto repeated = std::ranges::unique(hits, {}, key);
        hits.erase(repeated.begin(), repeated.end());
    }
};

RayScene::RayScene(const scene::Scene& scene)
    : meshes_(makeMeshes(scene)), reader_(scene, meshes_) {
    std::vector<unsigned> opaque, blended;
    for (unsigned i = 0; i < meshes_.size(); ++i) {
        const bool isBlended = meshes_[i].material->alphaMode == scene::AlphaMode::blend;
        (isBlended ? blended : opaque).push_back(i);
    }
    if (!opaque.empty()) opaque_ = std::make_unique<Bvh>(meshes_, opaque, false);
    if (!blended.empty()) blended_ = std::make_unique<Bvh>(meshes_, blended, true);
}

RayScene::~RayScene() = default;

void RayScene::trace(const Ray& ray, std::vector<Hit>& hits, bool& endsOpaque) const {
    hits.clear();
    endsOpaque = false;
    std::optional<Hit> last;
    if (opaque_) {
        RayContext context{{}, &ray, &reader_};
        rtcInitIntersectContext(&context.embree);
        RTCRayHit query{embreeRay(ray), {}};
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(opaque_->scene, &context.embree, &query);
        if (query.hit.geomID != RTC_INVALID_GEOMETRY_ID) {
            last = hitOf(opaque_->entries[query.hit.geomID], query.hit, query.ray.tfar);
        }
    }
    if (blended_) {
        Ray visible = ray;
        if (last) visible.farthest = last->distance;
        blended_->gather(visible, reader_, hits);
    }
    if (last) hits.push_back(*last);
    endsOpaque = last.has_value();
}

double RayScene::transmittance(const Ray& ray) const {
    if (opaque_) {
        RayContext context{{}, &ray, &reader_};
        rtcInitIntersectContext(&context.embree);
        RTCRay query = embreeRay(ray);
        rtcOccluded1(opaque_->scene, &context.embree, &query);
        if (query.tfar == -kInfinity) return 0.0;
    }
    if (!blended_) return 1.0;
    thread_local std::vector<Hit> layers;
    layers.clear();
    blended_->gather(ray, reader_, layers);
    double transmitted = 1.0;
    for (const Hit& hit : layers) {
        transmitted *= 1.0 - std::clamp(reader_.alpha(ray, hit), 0.0f, 1.0f);
    }
    return transmitted;
}

double RayScene::offset(const glm::dvec3& position) const {
    const double reach =
        std::max({std::abs(position.x), std::abs(position.y), std::abs(position.z)});
    // Some 16 units in the last place of single precision.
    return 2e-6 * std::max(reach, 1e-3);
}

}  // namespace polylume::reference
