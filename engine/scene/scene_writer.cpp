// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/scene_writer.hpp"

#include <string>
#include <string_view>

#include "core/file.hpp"
#include "core/text.hpp"
#include "polylume/error.hpp"
#include "scene/glb_container.hpp"
#include "scene/scene_writer_container.hpp"
#include "scene/scene_writer_materials.hpp"
#include "scene/scene_writer_nodes.hpp"
#include "scene/scene_writer_pictures.hpp"

namespace polylume::scene {
namespace {

/// Throws Error where a light can't be, by the rules that all lights have to keep.
void checkEdits(const SceneEdits& edits) {
    for (const AreaLight& area : edits.areaLights) {
        LightSet one;
        if (const auto* polygon = std::get_if<PolygonLight>(&area.shape)) {
            one.polygons.push_back(*polygon);
        } else if (const auto* ellipse = std::get_if<EllipseLight>(&area.shape)) {
            one.ellipses.push_back(*ellipse);
        } else if (const auto* sphere = std::get_if<SphereLight>(&area.shape)) {
            one.spheres.push_back(*sphere);
        } else {
            one.tubes.push_back(std::get<TubeLight>(area.shape));
        }
        try {
            checkLights(one);
        } catch (const Error& error) {
            throw Error(concat(error.what(), " (the light \"", area.name, "\")"));
        }
    }
}

/// The JSON of a file that GltfDocument has checked.
OrderedJson parseRoot(std::span<const std::byte> file, const GltfDocument& source) {
    std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
    if (isGlb(file)) text = splitGlb(file, source.fileName()).json;
    return OrderedJson::parse(text);
}

std::vector<std::byte> pack(const std::filesystem::path& source, const SceneEdits& edits,
                            const std::filesystem::path& target) {
    const std::vector<std::byte> file = readFile(source);
    const GltfDocument document = GltfDocument::parse(file, source);
    OrderedJson root = parseRoot(file, document);
    PictureWriter pictures(document, root, target);
    NodeWriter nodes(document, root, pictures);
    nodes.writeLights(edits);
    if (edits.camera) nodes.writeCamera(*edits.camera);
    overrideMaterials(root, document, pictures, target, edits.roughness, edits.metalness);
    return target.extension() == ".glb" ? packGlb(std::move(root), document, target)
                                        : packGltf(std::move(root), document, target);
}

}  // namespace

void writeEditedScene(const std::filesystem::path& source, const SceneEdits& edits,
                      const std::filesystem::path& target) {
    if (target.extension() != ".glb" && target.extension() != ".gltf") {
        throw Error(concat("expected the name of a .glb or .gltf file, found ", target.string()));
    }
    checkEdits(edits);
    checkWritable(target);
    try {
        writeFile(target, pack(source, edits, target));
    } catch (const nlohmann::json::exception& error) {
        // The reader checks all that it reads; what it leaves alone may still be malformed.
        throw Error(concat("can't save ", source.filename().string(), ": ", error.what(),
                           "; the file is no valid glTF"));
    }
}

}  // namespace polylume::scene
