// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <vector>

#include "scene/gltf_document.hpp"
#include "scene/node_graph.hpp"
#include "scene/scene_writer.hpp"
#include "scene/scene_writer_pictures.hpp"

namespace polylume::scene {

/// Puts the lights and the camera of SceneEdits into the nodes of the scene that is shown.
class NodeWriter {
  public:
    /// `root` is the source's JSON, to be changed; all three outlive it.
    NodeWriter(const GltfDocument& source, OrderedJson& root, PictureWriter& pictures);

    void writeLights(const SceneEdits& edits);
    void writeCamera(const Camera& camera);

  private:
    struct NewLight;

    /// Takes the lights away that are not among `edits`; those that are new are what it returns.
    std::vector<NewLight> keepKnownLights(const SceneEdits& edits);
    void takeLight(int node, const char* extension);
    void dropUnusedLights(const char* extension, const std::vector<int>& countsBefore);
    std::vector<int> countUses(const char* extension) const;
    void addLight(const NewLight& light);
    int addDefinition(const char* extension, OrderedJson light);
    /// A root of the shown scene: one that lost its light and holds nothing else, or a new one.
    int freeNode(const std::string& name);
    bool isBare(int node) const;
    void dropTrailingNodes();
    void listExtension(const char* extension);
    OrderedJson& shownRoots();

    const GltfDocument& source_;
    OrderedJson& root_;
    PictureWriter& pictures_;
    NodeGraph graph_;
    Scene lights_;            ///< The lights and cameras of the source.
    std::vector<int> freed_;  ///< Nodes that lost a light and are bare.
};

}  // namespace polylume::scene
