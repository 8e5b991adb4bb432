// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene_loader.hpp"

#include <cstring>
#include <exception>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "cli/picture.hpp"
#include "core/file.hpp"
#include "scene/emissive_lights.hpp"
#include "scene/gltf_reader.hpp"
#include "scene/merge.hpp"
#include "scene/uri.hpp"

namespace polylume::viewer {
namespace {

namespace fs = std::filesystem;

class ProgressCall : public Progress {
  public:
    explicit ProgressCall(const std::function<void(double)>& call) : call_(call) {}
    void update(double fraction) override { call_(fraction); }

  private:
    const std::function<void(double)>& call_;
};

std::size_t countTriangles(const scene::Scene& scene) {
    std::size_t count = 0;
    for (const scene::Instance& instance : scene.instances) {
        count += scene.meshes[static_cast<std::size_t>(instance.mesh)].indices.size() / 3;
    }
    return count;
}

int indexOf(const scene::Scene& scene, const scene::Camera& camera) {
    return static_cast<int>(&camera - scene.cameras.data());
}

/// The JSON of a .gltf or of a .glb, whose first chunk it is (glTF 2.0, 4.4).
std::string jsonOf(const fs::path& scene) {
    std::string text = readTextFile(scene);
    constexpr std::size_t kHeader = 20;
    if (!text.starts_with("glTF") || text.size() < kHeader) return text;
    std::uint32_t length = 0;
    std::memcpy(&length, text.data() + 12, sizeof(length));
    return text.substr(kHeader, length);
}

}  // namespace

std::vector<fs::path> filesOfScene(const fs::path& scene) {
    std::vector<fs::path> files = {scene};
    try {
        const nlohmann::json json = nlohmann::json::parse(jsonOf(scene));
        for (const char* list : {"buffers", "images"}) {
            if (!json.contains(list)) continue;
            for (const nlohmann::json& entry : json.at(list)) {
                const std::string uri = entry.value("uri", "");
                if (uri.empty() || uri.starts_with("data:")) continue;
                files.push_back(scene::fileOfUri(uri, scene.parent_path(), "scene"));
            }
        }
    } catch (const std::exception&) {
        // The reader says what is wrong with it; to be told of changes the file itself will do.
    }
    return files;
}

SceneDocument loadScene(const SceneRequest& request, glm::ivec2 size,
                        const std::function<void(double)>& progress) {
    SceneDocument document;
    document.request = request;
    document.files = filesOfScene(request.scene);
    ProgressCall call(progress);
    auto surfaces = std::make_shared<scene::Scene>(scene::readGltf(request.scene, call));
    if (request.emissiveLights) scene::addEmissiveLights(*surfaces);
    if (!request.lights.empty()) {
        scene::addLightsFrom(*surfaces, scene::readGltfLights(request.lights));
        document.files.push_back(request.lights);
    }
    cli::PictureRequest picture;
    picture.scene = request.scene;
    picture.camera = request.camera;
    cli::completeScene(*surfaces, picture, size);
    document.camera = indexOf(*surfaces, cli::chooseCamera(*surfaces, picture));
    document.bounds = surfaces->bounds();
    document.triangleCount = countTriangles(*surfaces);
    document.lights.name = surfaces->name;
    document.lights.cameras = surfaces->cameras;
    document.lights.areaLights = std::exchange(surfaces->areaLights, {});
    document.lights.punctualLights = std::exchange(surfaces->punctualLights, {});
    document.surfaces = std::move(surfaces);
    return document;
}

SceneLoader::~SceneLoader() {
    if (thread_.joinable()) thread_.join();
}

void SceneLoader::start(const SceneRequest& request, glm::ivec2 size) {
    request_ = request;
    size_ = size;
    isWantedAgain_ = thread_.joinable();
    if (!isWantedAgain_) launch();
}

void SceneLoader::launch() {
    isWantedAgain_ = false;
    isDone_ = false;
    progress_ = 0.0;
    thread_ = std::thread([this, request = request_, size = size_] {
        Result result;
        result.request = request;
        try {
            const auto progress = [this](double fraction) {
                if (fraction - progress_ < 0.02) return;
                progress_ = fraction;
                wake_();
            };
            result.document = std::make_unique<SceneDocument>(loadScene(request, size, progress));
        } catch (const std::exception& error) {
            result.error = error.what();
        }
        result_ = std::move(result);
        isDone_ = true;
        wake_();
    });
}

std::optional<SceneLoader::Result> SceneLoader::take() {
    if (!isDone_ || !thread_.joinable()) return std::nullopt;
    thread_.join();
    isDone_ = false;
    if (isWantedAgain_) {
        launch();
        return std::nullopt;
    }
    return std::move(result_);
}

}  // namespace polylume::viewer
