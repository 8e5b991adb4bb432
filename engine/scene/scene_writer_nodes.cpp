// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/scene_writer_nodes.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "scene/camera_reader.hpp"
#include "scene/exact_frame.hpp"
#include "scene/light_reader.hpp"

namespace polylume::scene {
namespace {

constexpr const char* kOurExtension = "POLYLUME_lights_area";
constexpr const char* kExtExtension = "EXT_lights_area";
constexpr const char* kPunctualExtension = "KHR_lights_punctual";
constexpr std::array kLightExtensions{kOurExtension, kExtExtension, kPunctualExtension};

/// What marks the camera that a window saved, so that the next save takes its place.
constexpr const char* kSavedView = "polylumeSavedView";

/// Compares bit by bit, but for where a light is from.
struct IsSameShape {
    bool operator()(const PolygonLight& a, const PolygonLight& b) const {
        return a.contours == b.contours && a.radiance == b.radiance && a.twoSided == b.twoSided &&
               a.shownBySurface == b.shownBySurface && isSameTexture(a.texture, b.texture);
    }
    bool operator()(const EllipseLight& a, const EllipseLight& b) const {
        return a.center == b.center && a.halfAxisX == b.halfAxisX && a.halfAxisY == b.halfAxisY &&
               a.radiance == b.radiance && a.twoSided == b.twoSided;
    }
    bool operator()(const SphereLight& a, const SphereLight& b) const {
        return a.center == b.center && a.radius == b.radius && a.radiance == b.radiance &&
               a.twoSided == b.twoSided;
    }
    bool operator()(const TubeLight& a, const TubeLight& b) const {
        return a.start == b.start && a.end == b.end && a.radius == b.radius &&
               a.radiance == b.radiance && a.twoSided == b.twoSided;
    }
    template <typename A, typename B>
    bool operator()(const A&, const B&) const {
        return false;
    }

    static bool isSameTexture(const std::optional<LightTexture>& a,
                              const std::optional<LightTexture>& b) {
        if (!a || !b) return !a && !b;
        return a->origin == b->origin && a->axisU == b->axisU && a->axisV == b->axisV &&
               a->wrapU == b->wrapU && a->wrapV == b->wrapV && isSamePicture(*a->image, *b->image);
    }
};

bool isSame(const AreaLight& a, const AreaLight& b) {
    return a.name == b.name && std::visit(IsSameShape{}, a.shape, b.shape);
}

bool isSame(const PunctualLight& a, const PunctualLight& b) {
    const bool isCone =
        a.type != PunctualLightType::spot ||
        (a.innerConeAngle == b.innerConeAngle && a.outerConeAngle == b.outerConeAngle);
    return a.name == b.name && a.type == b.type && a.position == b.position &&
           a.direction == b.direction && a.intensity == b.intensity && a.range == b.range && isCone;
}

bool isSame(const Camera& a, const Camera& b) {
    if (a.worldFromCamera != b.worldFromCamera) return false;
    if (a.projection.index() != b.projection.index()) return false;
    if (const auto* lens = std::get_if<Perspective>(&a.projection)) {
        const auto& other = std::get<Perspective>(b.projection);
        return lens->yFovRadians == other.yFovRadians && lens->zNear == other.zNear &&
               lens->zFar == other.zFar;
    }
    const auto& lens = std::get<Orthographic>(a.projection);
    const auto& other = std::get<Orthographic>(b.projection);
    return lens.xMag == other.xMag && lens.yMag == other.yMag && lens.zNear == other.zNear &&
           lens.zFar == other.zFar;
}

/// Takes the first light that is the same as `light` from those that nothing of the file was found
/// for yet; whether there was one.
template <typename Light>
bool takeMatch(const Light& light, const std::vector<Light>& edited, std::vector<bool>& isTaken) {
    for (std::size_t i = 0; i < edited.size(); ++i) {
        if (isTaken[i] || !isSame(light, edited[i])) continue;
        isTaken[i] = true;
        return true;
    }
    return false;
}

OrderedJson cameraJson(const Camera& camera, const std::string& name) {
    OrderedJson json{{"name", name}};
    if (const auto* lens = std::get_if<Perspective>(&camera.projection)) {
        OrderedJson perspective{{"yfov", shortestNumber(lens->yFovRadians)},
                                {"znear", shortestNumber(lens->zNear)}};
        if (lens->zFar) perspective["zfar"] = shortestNumber(*lens->zFar);
        if (lens->aspectRatio) perspective["aspectRatio"] = shortestNumber(*lens->aspectRatio);
        json["type"] = "perspective";
        json["perspective"] = std::move(perspective);
    } else {
        const auto& orthographic = std::get<Orthographic>(camera.projection);
        json["type"] = "orthographic";
        json["orthographic"] = {{"xmag", shortestNumber(orthographic.xMag)},
                                {"ymag", shortestNumber(orthographic.yMag)},
                                {"zfar", shortestNumber(orthographic.zFar)},
                                {"znear", shortestNumber(orthographic.zNear)}};
    }
    return json;
}

void eraseEmpty(OrderedJson& object, const char* name) {
    if (object.contains(name) && object[name].empty()) object.erase(name);
}

}  // namespace

struct NodeWriter::NewLight {
    WrittenLight written;
    bool isArea = false;
};

NodeWriter::NodeWriter(const GltfDocument& source, OrderedJson& root, PictureWriter& pictures)
    : source_(source), root_(root), pictures_(pictures), graph_(source) {
    for (const int node : graph_.sceneNodes()) {
        if (source_.model().nodes[static_cast<std::size_t>(node)].camera < 0) continue;
        lights_.cameras.push_back(readCamera(source_, graph_, node));
    }
}

void NodeWriter::writeLights(const SceneEdits& edits) {
    std::array<std::vector<int>, kLightExtensions.size()> counts;
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = countUses(kLightExtensions[i]);
    const std::vector<NewLight> added = keepKnownLights(edits);
    for (std::size_t i = 0; i < counts.size(); ++i) {
        dropUnusedLights(kLightExtensions[i], counts[i]);
    }
    for (const NewLight& light : added) addLight(light);
    dropTrailingNodes();
    for (const char* extension : kLightExtensions) listExtension(extension);
}

std::vector<NodeWriter::NewLight> NodeWriter::keepKnownLights(const SceneEdits& edits) {
    std::vector<bool> isAreaKnown(edits.areaLights.size(), false);
    std::vector<bool> isPunctualKnown(edits.punctualLights.size(), false);
    LightReader reader(source_, graph_, lights_);
    for (const int node : graph_.sceneNodes()) {
        const std::size_t areaCount = lights_.areaLights.size();
        const std::size_t punctualCount = lights_.punctualLights.size();
        reader.addNode(node);
        bool hasLost = false;
        if (lights_.areaLights.size() > areaCount &&
            !takeMatch(lights_.areaLights.back(), edits.areaLights, isAreaKnown)) {
            takeLight(node, kOurExtension);
            takeLight(node, kExtExtension);
            hasLost = true;
        }
        if (lights_.punctualLights.size() > punctualCount &&
            !takeMatch(lights_.punctualLights.back(), edits.punctualLights, isPunctualKnown)) {
            takeLight(node, kPunctualExtension);
            hasLost = true;
        }
        if (hasLost && isBare(node)) freed_.push_back(node);
    }
    std::vector<NewLight> added;
    for (std::size_t i = 0; i < edits.areaLights.size(); ++i) {
        if (isAreaKnown[i]) continue;
        NewLight light{writeAreaLight(edits.areaLights[i]), true};
        const auto* flat = std::get_if<PolygonLight>(&edits.areaLights[i].shape);
        if (flat != nullptr && flat->texture) {
            light.written.light["texture"] = pictures_.write(*flat->texture);
        }
        added.push_back(std::move(light));
    }
    for (std::size_t i = 0; i < edits.punctualLights.size(); ++i) {
        if (!isPunctualKnown[i]) {
            added.push_back({writePunctualLight(edits.punctualLights[i]), false});
        }
    }
    if (edits.areaLights.empty() && edits.punctualLights.empty()) {
        PunctualLight dark;
        dark.name = "no light";
        dark.intensity = glm::vec3(0.0f);
        added.push_back({writePunctualLight(dark), false});
    }
    return added;
}

void NodeWriter::takeLight(int node, const char* extension) {
    OrderedJson& json = root_["nodes"][static_cast<std::size_t>(node)];
    if (!json.contains("extensions")) return;
    json["extensions"].erase(extension);
    eraseEmpty(json, "extensions");
}

std::vector<int> NodeWriter::countUses(const char* extension) const {
    std::vector<int> counts;
    const OrderedJson::json_pointer list(std::string("/extensions/") + extension + "/lights");
    if (!root_.contains(list)) return counts;
    counts.resize(root_[list].size());
    for (const OrderedJson& node : root_.value("nodes", OrderedJson::array())) {
        const OrderedJson::json_pointer light(std::string("/extensions/") + extension + "/light");
        if (node.contains(light)) ++counts.at(node[light].get<std::size_t>());
    }
    return counts;
}

void NodeWriter::dropUnusedLights(const char* extension, const std::vector<int>& countsBefore) {
    // Animations may point at lights by their index, which then has to stay.
    const OrderedJson used = root_.value("extensionsUsed", OrderedJson::array());
    if (std::ranges::find(used, "KHR_animation_pointer") != used.end()) return;
    const std::vector<int> counts = countUses(extension);
    std::vector<std::size_t> indexOf(counts.size());
    OrderedJson kept = OrderedJson::array();
    for (std::size_t i = 0; i < counts.size(); ++i) {
        indexOf[i] = kept.size();
        if (counts[i] > 0 || countsBefore[i] == 0) {
            kept.push_back(root_["extensions"][extension]["lights"][i]);
        }
    }
    if (kept.size() == counts.size()) return;
    root_["extensions"][extension]["lights"] = std::move(kept);
    for (OrderedJson& node : root_["nodes"]) {
        const OrderedJson::json_pointer light(std::string("/extensions/") + extension + "/light");
        if (node.contains(light)) node[light] = indexOf[node[light].get<std::size_t>()];
    }
}

int NodeWriter::addDefinition(const char* extension, OrderedJson light) {
    OrderedJson& lights = root_["extensions"][extension]["lights"];
    lights.push_back(std::move(light));
    return static_cast<int>(lights.size()) - 1;
}

void NodeWriter::addLight(const NewLight& light) {
    const WrittenLight& written = light.written;
    const std::string name = written.light.value("name", "");
    OrderedJson node = OrderedJson::object();
    if (!name.empty()) node["name"] = name;
    const glm::dvec3& t = written.translation;
    if (t != glm::dvec3(0.0)) node["translation"] = {t.x, t.y, t.z};
    const glm::dquat& q = written.rotation;
    if (q != glm::dquat(1.0, 0.0, 0.0, 0.0)) node["rotation"] = {q.x, q.y, q.z, q.w};
    const auto refer = [&](const char* extension, const OrderedJson& definition) {
        node["extensions"][extension]["light"] = addDefinition(extension, definition);
    };
    refer(light.isArea ? kOurExtension : kPunctualExtension, written.light);
    if (written.extLight) refer(kExtExtension, *written.extLight);
    const auto index = static_cast<std::size_t>(freeNode(name));
    root_["nodes"][index] = std::move(node);
}

OrderedJson& NodeWriter::shownRoots() {
    // Without scenes all roots are shown; they become one, so that something can come first.
    if (!root_.contains("scenes") || root_["scenes"].empty()) {
        std::vector<bool> isChild(source_.model().nodes.size(), false);
        for (const tinygltf::Node& node : source_.model().nodes) {
            for (const int child : node.children) isChild[static_cast<std::size_t>(child)] = true;
        }
        OrderedJson roots = OrderedJson::array();
        for (std::size_t i = 0; i < isChild.size(); ++i) {
            if (!isChild[i]) roots.push_back(i);
        }
        root_["scenes"] = OrderedJson::array({{{"nodes", roots}}});
        root_["scene"] = 0;
    }
    const auto shown = static_cast<std::size_t>(std::max(source_.model().defaultScene, 0));
    OrderedJson& roots = root_["scenes"][shown]["nodes"];
    if (roots.is_null()) roots = OrderedJson::array();
    return roots;
}

bool NodeWriter::isBare(int node) const {
    const OrderedJson& json = root_["nodes"][static_cast<std::size_t>(node)];
    for (const auto& [name, value] : json.items()) {
        constexpr std::array kOwn{"name", "translation", "rotation", "scale", "matrix"};
        if (std::ranges::find(kOwn, name) == kOwn.end()) return false;
    }
    const tinygltf::Model& model = source_.model();
    // A root of this scene alone.
    int uses = 0;
    for (const tinygltf::Scene& scene : model.scenes) {
        uses += static_cast<int>(std::ranges::count(scene.nodes, node));
    }
    if (uses > 1) return false;
    for (const tinygltf::Node& parent : model.nodes) {
        if (std::ranges::find(parent.children, node) != parent.children.end()) return false;
    }
    for (const tinygltf::Skin& skin : model.skins) {
        if (skin.skeleton == node) return false;
        if (std::ranges::find(skin.joints, node) != skin.joints.end()) return false;
    }
    // By the JSON, since channels are none of what the reader keeps.
    for (const OrderedJson& animation : root_.value("animations", OrderedJson::array())) {
        for (const OrderedJson& channel : animation.value("channels", OrderedJson::array())) {
            const OrderedJson::json_pointer target("/target/node");
            if (channel.contains(target) && channel[target] == node) return false;
        }
    }
    return true;
}

int NodeWriter::freeNode(const std::string& name) {
    OrderedJson& nodes = root_["nodes"];
    if (!freed_.empty()) {
        const auto sameName = std::ranges::find_if(freed_, [&](int node) {
            return nodes[static_cast<std::size_t>(node)].value("name", "") == name;
        });
        const auto taken = sameName != freed_.end() ? sameName : freed_.begin();
        const int node = *taken;
        freed_.erase(taken);
        return node;
    }
    const std::size_t node = nodes.size();
    shownRoots().push_back(node);
    root_["nodes"].push_back(OrderedJson::object());
    return static_cast<int>(node);
}

void NodeWriter::dropTrailingNodes() {
    // Others keep their index: nothing can know all that refers to nodes.
    while (!freed_.empty()) {
        const auto last = std::ranges::max_element(freed_);
        if (*last != static_cast<int>(root_["nodes"].size()) - 1) return;
        OrderedJson& roots = shownRoots();
        roots.erase(std::remove(roots.begin(), roots.end(), OrderedJson(*last)), roots.end());
        root_["nodes"].erase(root_["nodes"].size() - 1);
        freed_.erase(last);
    }
}

void NodeWriter::listExtension(const char* extension) {
    const OrderedJson::json_pointer list(std::string("/extensions/") + extension + "/lights");
    const bool isUsed = root_.contains(list) && !root_[list].empty();
    if (!isUsed && root_.contains("extensions")) {
        root_["extensions"].erase(extension);
        eraseEmpty(root_, "extensions");
    }
    for (const char* key : {"extensionsUsed", "extensionsRequired"}) {
        const bool isListed =
            root_.contains(key) && std::ranges::find(root_[key], extension) != root_[key].end();
        if (isUsed && !isListed && key == std::string("extensionsUsed")) {
            root_[key].push_back(extension);
        }
        if (isUsed || !isListed) continue;
        OrderedJson& names = root_[key];
        names.erase(std::remove(names.begin(), names.end(), OrderedJson(extension)), names.end());
        eraseEmpty(root_, key);
    }
}

void NodeWriter::writeCamera(const Camera& camera) {
    if (!lights_.cameras.empty() && isSame(lights_.cameras.front(), camera)) return;
    const std::string name = camera.name.empty() ? "view" : camera.name;
    OrderedJson node{{"name", name}};
    // In double: the reader makes the axes orthonormal, which those of single precision are not.
    const glm::dmat3 axes = findExactAxes(glm::mat3(camera.worldFromCamera));
    OrderedJson matrix = OrderedJson::array();
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 3; ++row) {
            matrix.push_back(column < 3 ? OrderedJson(axes[column][row])
                                        : shortestNumber(camera.worldFromCamera[3][row]));
        }
        matrix.push_back(column < 3 ? 0 : 1);
    }
    node["matrix"] = std::move(matrix);
    node["extras"][kSavedView] = true;

    // What is marked and comes first is from an earlier save.
    const OrderedJson::json_pointer mark(std::string("/extras/") + kSavedView);
    if (!shownRoots().empty()) {
        const auto first = shownRoots().front().get<std::size_t>();
        const OrderedJson earlier = root_["nodes"][first];
        if (earlier.contains(mark) && earlier.contains("camera")) {
            node["camera"] = earlier["camera"];
            root_["cameras"][earlier["camera"].get<std::size_t>()] = cameraJson(camera, name);
            root_["nodes"][first] = std::move(node);
            return;
        }
    }
    root_["cameras"].push_back(cameraJson(camera, name));
    node["camera"] = root_["cameras"].size() - 1;
    root_["nodes"].push_back(std::move(node));
    const std::size_t index = root_["nodes"].size() - 1;
    OrderedJson& roots = shownRoots();
    roots.insert(roots.begin(), index);
}

}  // namespace polylume::scene
