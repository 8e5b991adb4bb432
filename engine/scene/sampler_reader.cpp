// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/sampler_reader.hpp"

namespace polylume::scene {
namespace {

Wrap wrapMode(int value) {
    if (value == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::clampToEdge;
    if (value == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) return Wrap::mirroredRepeat;
    return Wrap::repeat;
}

}  // namespace

Sampler readSampler(const tinygltf::Model& model, int gltfSampler) {
    Sampler sampler;
    if (gltfSampler < 0) return sampler;
    const tinygltf::Sampler& source = model.samplers[gltfSampler];
    sampler.wrapU = wrapMode(source.wrapS);
    sampler.wrapV = wrapMode(source.wrapT);
    if (source.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST) sampler.magFilter = Filter::nearest;
    switch (source.minFilter) {
        case TINYGLTF_TEXTURE_FILTER_NEAREST:
            sampler.minFilter = Filter::nearest;
            sampler.mipFilter = MipFilter::none;
            break;
        case TINYGLTF_TEXTURE_FILTER_LINEAR:
            sampler.mipFilter = MipFilter::none;
            break;
        case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
            sampler.minFilter = Filter::nearest;
            sampler.mipFilter = MipFilter::nearest;
            break;
        case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST:
            sampler.mipFilter = MipFilter::nearest;
            break;
        case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR:
            sampler.minFilter = Filter::nearest;
            break;
        default:
            break;
    }
    return sampler;
}

}  // namespace polylume::scene
