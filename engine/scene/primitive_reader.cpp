// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/primitive_reader.hpp"

#include <cmath>
#include <numeric>

#include "core/text.hpp"
#include "polylume/error.hpp"
#include "scene/triangle_list.hpp"

namespace polylume::scene {
namespace {

/// Beyond this, squares of lengths leave single precision.
constexpr float kLargestPosition = 1e15f;

class Reader {
  public:
    Reader(const GltfDocument& document, const tinygltf::Primitive& source,
           const std::string& where)
        : document_(document), source_(source), where_(where), accessors_(document) {}

    bool read(Primitive& primitive) {
        Mesh& mesh = primitive.mesh;
        const auto position = source_.attributes.find("POSITION");
        if (position == source_.attributes.end()) {
            document_.warn(concat(where_, " has no POSITION and is not drawn"));
            return false;
        }
        mesh.positions = vectors<glm::vec3>(source_.attributes, "POSITION", "");
        checkPositions(mesh.positions);
        vertexCount_ = mesh.positions.size();
        if (!readIndices(mesh)) return false;
        mesh.normals = vectors<glm::vec3>(source_.attributes, "NORMAL", "");
        // glTF 2.0, section 3.7.2.1: without normals the file's tangents are to be ignored.
        if (!mesh.normals.empty()) {
            mesh.tangents = vectors<glm::vec4>(source_.attributes, "TANGENT", "");
        }
        mesh.texCoords[0] = vectors<glm::vec2>(source_.attributes, "TEXCOORD_0", "");
        mesh.texCoords[1] = vectors<glm::vec2>(source_.attributes, "TEXCOORD_1", "");
        mesh.colors = readColors();
        readJoints(primitive.jointSets);
        readTargets(primitive.targets);
        return true;
    }

  private:
    using Attributes = std::map<std::string, int>;

    std::string use(const std::string& prefix, const std::string& name) const {
        return where_ + prefix + "." + name;
    }

    void checkCount(std::size_t count, const std::string& attribute) const {
        if (vertexCount_ == 0 || count == vertexCount_) return;
        throw Error(concat("expected ", vertexCount_, " elements as POSITION has, found ", count,
                           " (", document_.place(attribute), ")"));
    }

    /// Empty where there is no such attribute. Values that are not finite become 0, but for
    /// positions.
    template <typename Vector>
    std::vector<Vector> vectors(const Attributes& attributes, const std::string& name,
                                const std::string& prefix) const {
        const auto found = attributes.find(name);
        if (found == attributes.end()) return {};
        const std::string here = use(prefix, name);
        std::vector<Vector> values = accessors_.readVectors<Vector>(found->second, here);
        checkCount(values.size(), here);
        if (name != "POSITION") makeFinite(values, here);
        return values;
    }

    template <typename Vector>
    void makeFinite(std::vector<Vector>& values, const std::string& here) const {
        for (Vector& value : values) {
            for (int c = 0; c < Vector::length(); ++c) {
                if (std::abs(value[c]) <= kLargestPosition) continue;
                value[c] = 0.0f;
                document_.warn(concat(here, " has values that are not finite; taken as 0"));
            }
        }
    }

    void checkPositions(const std::vector<glm::vec3>& positions) const {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const glm::vec3 size = glm::abs(positions[i]);
            if (size.x <= kLargestPosition && size.y <= kLargestPosition &&
                size.z <= kLargestPosition) {
                continue;
            }
            throw Error(concat("expected finite positions of at most 1e15, found (", positions[i].x,
                               ", ", positions[i].y, ", ", positions[i].z, ") at vertex ", i, " (",
                               document_.place(where_, ".POSITION"), ")"));
        }
    }

    bool readIndices(Mesh& mesh) const {
        std::vector<std::uint32_t> indices;
        if (source_.indices >= 0) {
            indices = accessors_.readIntegers(source_.indices, 1, use("", "indices"));
        } else {
            indices.resize(vertexCount_);
            std::iota(indices.begin(), indices.end(), 0u);
        }
        for (std::size_t i = 0; i < indices.size(); ++i) {
            if (indices[i] < vertexCount_) continue;
            throw Error(concat("expected indices below ", vertexCount_, ", found ", indices[i],
                               " at place ", i, " (", document_.place(where_, ".indices"), ")"));
        }
        auto triangles = triangleList(std::move(indices), source_.mode);
        if (!triangles) document_.warn("points and lines are not drawn");
        if (!triangles || triangles->empty()) return false;
        mesh.indices = std::move(*triangles);
        return true;
    }

    std::vector<glm::vec4> readColors() const {
        const auto found = source_.attributes.find("COLOR_0");
        if (found == source_.attributes.end()) return {};
        if (accessors_.componentCount(found->second) == 4) {
            return vectors<glm::vec4>(source_.attributes, "COLOR_0", "");
        }
        std::vector<glm::vec4> colors;
        for (const glm::vec3& color : vectors<glm::vec3>(source_.attributes, "COLOR_0", "")) {
            colors.emplace_back(color, 1.0f);
        }
        return colors;
    }

    void readJoints(std::vector<JointSet>& sets) const {
        for (const char* set : {"0", "1"}) {
            const std::string jointName = concat("JOINTS_", set);
            const auto joints = source_.attributes.find(jointName);
            if (joints == source_.attributes.end()) return;
            JointSet& added = sets.emplace_back();
            added.weights = vectors<glm::vec4>(source_.attributes, concat("WEIGHTS_", set), "");
            if (added.weights.empty()) {
                throw Error(concat("expected WEIGHTS_", set, " beside ", jointName,
                                   ", found none (", document_.place(where_), ")"));
            }
            const auto values = accessors_.readIntegers(joints->second, 4, use("", jointName));
            checkCount(values.size() / 4, use("", jointName));
            added.joints.resize(values.size() / 4);
            for (std::size_t i = 0; i < values.size(); ++i) {
                added.joints[i / 4][static_cast<int>(i % 4)] = values[i];
            }
        }
    }

    void readTargets(std::vector<MorphTarget>& targets) const {
        for (std::size_t i = 0; i < source_.targets.size(); ++i) {
            const std::string prefix = concat(".targets[", i, "]");
            MorphTarget& target = targets.emplace_back();
            target.positions = vectors<glm::vec3>(source_.targets[i], "POSITION", prefix);
            checkPositions(target.positions);
            target.normals = vectors<glm::vec3>(source_.targets[i], "NORMAL", prefix);
            target.tangents = vectors<glm::vec3>(source_.targets[i], "TANGENT", prefix);
        }
    }

    const GltfDocument& document_;
    const tinygltf::Primitive& source_;
    const std::string& where_;
    AccessorReader accessors_;
    std::size_t vertexCount_ = 0;
};

}  // namespace

bool readPrimitive(const GltfDocument& document, const tinygltf::Primitive& source,
                   const std::string& where, Primitive& primitive) {
    return Reader(document, source, where).read(primitive);
}

}  // namespace polylume::scene
