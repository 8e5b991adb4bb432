// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "light_editor.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/log.hpp"
#include "core/text.hpp"
#include "light_editor_history.hpp"
#include "light_editor_list.hpp"
#include "light_editor_shapes.hpp"
#include "light_gizmo.hpp"
#include "light_panel.hpp"
#include "light_picking.hpp"

namespace polylume::viewer {
namespace {

/// How near to a light's mark or edge a click picks it, in pixels of a plain display.
constexpr double kPickReach = 14.0;

/// Beyond as many lights they are not marked or looked for before a click.
constexpr std::size_t kMostMarks = 500;

}  // namespace

struct LightEditor::Impl {
    LightPanel panel;
    LightGizmo gizmo;
    LightHistory history;
    std::shared_ptr<const scene::Scene> surfaces;
    std::optional<LightId> selected;
    /// Axes that the selected light leaves open, from when it was of another shape.
    glm::dmat3 hint{1.0};
    std::optional<AnyLight> dragStart;  ///< The light before the drag of a handle.
    bool isKnown = false;      ///< Whether the history begins with the lights that are there.
    bool isChanging = false;   ///< Lights differ from the history's present.
    int fieldFrame = -2;       ///< ImGui's frame in which a field was last held.
    glm::dmat3 dragAxes{1.0};  ///< Of the box that a handle was dragged to.

    /// A panel that is hidden meanwhile holds nothing.
    bool isFieldActive() const { return ImGui::GetFrameCount() - fieldFrame <= 1; }

    const scene::Scene& surfacesOf(const scene::Scene& scene) const {
        return surfaces ? *surfaces : scene;
    }

    LightsState stateOf(const scene::Scene& scene) const {
        return {scene.areaLights, scene.punctualLights, selected};
    }

    /// The scene may have been read since.
    void meet(const scene::Scene& scene) {
        if (!isKnown) history.reset(stateOf(scene));
        isKnown = true;
        if (selected && !exists(scene, *selected)) select(std::nullopt);
    }

    void select(std::optional<LightId> light) {
        if (selected == light) return;
        selected = light;
        log(LogLevel::debug, concat("selected: ", light ? describe(*light) : "none"));
        hint = glm::dmat3(1.0);
        dragStart.reset();
        gizmo.clear();
        panel.reset();
    }

    /// A step that can be undone ends when nothing is held any more.
    void commitWhenDone(const scene::Scene& scene) {
        if (!isChanging || gizmo.isDragging() || isFieldActive()) return;
        history.commit(stateOf(scene));
        isChanging = false;
        std::string what;
        if (selected) {
            const LightBox box = boxOf(get(scene, *selected), hint);
            what =
                concat(", ", describe(*selected), " at (", box.center.x, ", ", box.center.y, ", ",
                       box.center.z, ") of (", box.half.x, ", ", box.half.y, ", ", box.half.z, ")");
        }
        log(LogLevel::debug, concat("lights changed: ", countOf(scene), " lights", what));
    }

    void put(scene::Scene& scene, AnyLight light) {
        const LightKind kind = kindOf(light);
        const glm::dmat3 axes = boxOf(get(scene, *selected), hint).axes;
        const LightId moved = replace(scene, *selected, std::move(light));
        if (moved != *selected) select(moved);
        // Axes that the new kind leaves open, or that follow the light.
        hint = hasDirection(kind) ? boxOf(get(scene, moved), axes).axes : axes;
        isChanging = true;
    }

    bool take(scene::Scene& scene, const LightsState& state) {
        scene.areaLights = state.areaLights;
        scene.punctualLights = state.punctualLights;
        isChanging = false;
        const std::optional<LightId> before = state.selected;
        select(before && exists(scene, *before) ? before : std::nullopt);
        return true;
    }

    bool undo(scene::Scene& scene) {
        return history.canUndo() && !isChanging && take(scene, history.undo());
    }

    bool redo(scene::Scene& scene) {
        return history.canRedo() && !isChanging && take(scene, history.redo());
    }

    bool remove(scene::Scene& scene) {
        if (!selected) return false;
        erase(scene, *selected);
        // The next one, so that many can be deleted one after the other.
        std::optional<LightId> next = selected;
        if (!exists(scene, *next)) --next->index;
        select(std::nullopt);
        if (exists(scene, *next)) select(next);
        isChanging = true;
        return true;
    }

    bool duplicate(scene::Scene& scene) {
        if (!selected) return false;
        AnyLight light = get(scene, *selected);
        const glm::dmat3 axes = hint;
        // Beside the first, to be seen.
        const LightBox from = boxOf(light, hint);
        LightBox to = from;
        const double reach = std::max(from.half.x, 0.1);
        to.center += 0.5 * reach * from.axes[0];
        light = moved(light, from, to);
        if (!nameOf(light).empty()) setName(light, nameOf(light) + " copy");
        select(append(scene, std::move(light)));
        hint = axes;
        isChanging = true;
        return true;
    }

    /// Above the middle of the scene, facing down, as bright as those that are there.
    bool add(scene::Scene& scene, LightKind kind) {
        const scene::Bounds bounds = surfacesOf(scene).bounds();
        const double radius = bounds.isEmpty() ? 1.0 : std::max(0.01f, bounds.radius());
        glm::dvec3 center = bounds.isEmpty() ? glm::dvec3(0.0) : glm::dvec3(bounds.center());
        center.y += 0.75 * radius;
        scene::LightFrame frame{glm::vec3(center), glm::mat3(1.0f)};
        // X stays, -Z is down.
        frame.worldFromLight =
            glm::mat3(glm::vec3(1, 0, 0), glm::vec3(0, 0, -1), glm::vec3(0, 1, 0));
        const float side = static_cast<float>(0.5 * radius);
        glm::vec3 radiance(1000.0f);
        for (const scene::AreaLight& light : scene.areaLights) {
            radiance =
                glm::max(radiance, glm::vec3(std::max({emissionOf(light).r, emissionOf(light).g,
                                                       emissionOf(light).b})));
        }
        const AnyLight square =
            scene::AreaLight{"", scene::makeRectangle(frame, {side, side}, radiance), ""};
        const glm::dmat3 axes(frame.worldFromLight);
        AnyLight light = converted(square, kind, axes);
        setName(light, std::string(nameOf(kind)) + " " + std::to_string(countOf(scene) + 1));
        select(append(scene, std::move(light)));
        hint = axes;
        isChanging = true;
        return true;
    }

    void drawMarks(ImDrawList& list, const scene::Scene& scene, const ViewTransform& view) const {
        if (countOf(scene) > kMostMarks) return;
        for (std::size_t i = 0; i < scene.punctualLights.size(); ++i) {
            const LightId id{LightId::Kind::punctual, static_cast<int>(i)};
            if (selected != id) drawLightMark(list, view, get(scene, id), LightMark::plain);
        }
        const ImGuiIO& io = ImGui::GetIO();
        const glm::dvec2 mouse(io.MousePos.x, io.MousePos.y);
        const bool isFree = !io.WantCaptureMouse && !gizmo.wantsMouse() && !io.MouseDown[0] &&
                            !io.MouseDown[1] && !io.MouseDown[2];
        if (!isFree || !view.contains(mouse)) return;
        const auto hovered = pickLight(scene, view, mouse, kPickReach * interfaceScale());
        if (hovered && hovered != selected) {
            drawLightMark(list, view, get(scene, *hovered), LightMark::hovered);
        }
    }
};

LightEditor::LightEditor() : impl_(std::make_unique<Impl>()) {}
LightEditor::~LightEditor() = default;
LightEditor::LightEditor(LightEditor&&) noexcept = default;
LightEditor& LightEditor::operator=(LightEditor&&) noexcept = default;

void LightEditor::reset(bool keepSelection) {
    impl_->isKnown = impl_->isChanging = false;
    impl_->gizmo.clear();
    impl_->dragStart.reset();
    if (!keepSelection) impl_->select(std::nullopt);
}

void LightEditor::setSurfaces(std::shared_ptr<const scene::Scene> surfaces) {
    impl_->surfaces = std::move(surfaces);
}

bool LightEditor::handleKeys(scene::Scene& scene) {
    impl_->meet(scene);
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput) return false;
    // Letters and digits are ASCII among GLFW's key codes.
    const auto isPressed = [](int key) { return ImGui::IsKeyPressed(key, false); };
    const auto isRepeated = [](int key) { return ImGui::IsKeyPressed(key, true); };
    if (io.KeyCtrl) {
        bool hasChanged = false;
        if (isRepeated('Z')) hasChanged = io.KeyShift ? impl_->redo(scene) : impl_->undo(scene);
        if (isRepeated('Y')) hasChanged = impl_->redo(scene);
        if (isPressed('D')) hasChanged = impl_->duplicate(scene);
        if (hasChanged) impl_->commitWhenDone(scene);
        return hasChanged;
    }
    if (isPressed('1')) impl_->gizmo.mode = GizmoMode::move;
    if (isPressed('2')) impl_->gizmo.mode = GizmoMode::turn;
    if (isPressed('3')) impl_->gizmo.mode = GizmoMode::resize;
    if (isPressed('4')) impl_->gizmo.mode = GizmoMode::none;
    if (isPressed('X')) impl_->gizmo.usesWorldAxes = !impl_->gizmo.usesWorldAxes;
    const auto isMapped = [&](ImGuiKey_ key) {
        const int code = io.KeyMap[key];
        return code >= 0 && isPressed(code);
    };
    if (isMapped(ImGuiKey_Escape)) {
        if (impl_->gizmo.cancel() && impl_->dragStart) {
            replace(scene, *impl_->selected, *std::exchange(impl_->dragStart, std::nullopt));
            impl_->isChanging = false;
            return true;
        }
        impl_->select(std::nullopt);
    }
    if (isMapped(ImGuiKey_Delete) && impl_->remove(scene)) {
        impl_->commitWhenDone(scene);
        return true;
    }
    return false;
}

bool LightEditor::drawPanel(scene::Scene& scene) {
    impl_->meet(scene);
    bool hasChanged = false;
    ImGui::PushID("light editor");
    const PanelRequest request = impl_->panel.drawList(
        scene, impl_->selected, impl_->history.canUndo(), impl_->history.canRedo());
    if (request.select) impl_->select(request.select);
    if (request.add) hasChanged |= impl_->add(scene, *request.add);
    if (request.duplicate) hasChanged |= impl_->duplicate(scene);
    if (request.remove) hasChanged |= impl_->remove(scene);
    if (request.undo) hasChanged |= impl_->undo(scene);
    if (request.redo) hasChanged |= impl_->redo(scene);
    if (impl_->selected) {
        impl_->panel.drawModes(impl_->gizmo);
        // A group is active where one of its fields is.
        ImGui::BeginGroup();
        const auto changed = impl_->panel.drawFields(get(scene, *impl_->selected), impl_->hint,
                                                     impl_->surfacesOf(scene), scene);
        ImGui::EndGroup();
        if (ImGui::IsItemActive()) impl_->fieldFrame = ImGui::GetFrameCount();
        if (changed) {
            impl_->put(scene, *changed);
            hasChanged = true;
        }
    } else {
        ImGui::TextDisabled("Click a light in the list or the picture");
    }
    ImGui::PopID();
    impl_->commitWhenDone(scene);
    return hasChanged;
}

bool LightEditor::drawGizmo(scene::Scene& scene, const ViewTransform& view) {
    impl_->meet(scene);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const glm::dvec2 end = view.origin + view.size;
    list.PushClipRect({static_cast<float>(view.origin.x), static_cast<float>(view.origin.y)},
                      {static_cast<float>(end.x), static_cast<float>(end.y)}, true);
    impl_->drawMarks(list, scene, view);
    bool hasChanged = false;
    if (impl_->selected) {
        const AnyLight light = get(scene, *impl_->selected);
        drawLightMark(list, view, light, LightMark::selected);
        const LightBox box = boxOf(light, impl_->hint);
        const auto to = impl_->gizmo.update(list, view, kindOf(light), box);
        if (impl_->gizmo.isDragging() && !impl_->dragStart) impl_->dragStart = light;
        if (!impl_->gizmo.isDragging() && impl_->dragStart) {
            impl_->hint = boxOf(light, impl_->dragAxes).axes;
            impl_->dragStart.reset();
        }
        if (to && impl_->dragStart) {
            // Each time from where it began, so that rounding does not add up.
            const LightBox from = boxOf(*impl_->dragStart, impl_->hint);
            impl_->dragAxes = to->axes;
            const bool isElsewhere =
                to->center != box.center || to->axes != box.axes || to->half != box.half;
            if (isElsewhere) {
                replace(scene, *impl_->selected, moved(*impl_->dragStart, from, *to));
                impl_->isChanging = hasChanged = true;
            }
        }
    } else {
        impl_->gizmo.clear();
    }
    list.PopClipRect();
    impl_->commitWhenDone(scene);
    return hasChanged;
}

bool LightEditor::pick(const scene::Scene& scene, const ViewTransform& view,
                       const glm::dvec2& mouse) {
    const std::optional<LightId> before = impl_->selected;
    impl_->select(pickLight(scene, view, mouse, kPickReach * interfaceScale()));
    return impl_->selected != before;
}

bool LightEditor::wantsMouse() const {
    return impl_->gizmo.wantsMouse();
}

bool LightEditor::isDragging() const {
    return impl_->gizmo.isDragging() || impl_->isFieldActive();
}

std::optional<LightId> LightEditor::selected() const {
    return impl_->selected;
}

void LightEditor::select(std::optional<LightId> light) {
    impl_->select(light);
}

std::optional<scene::Bounds> LightEditor::selectedBounds(const scene::Scene& scene) const {
    if (!impl_->selected || !exists(scene, *impl_->selected)) return std::nullopt;
    const LightBox box = boxOf(get(scene, *impl_->selected), impl_->hint);
    // A light without extent is looked at from where a small one would be.
    const glm::dvec3 half =
        glm::max(box.half, glm::dvec3(box.half == glm::dvec3(0.0) ? 0.25 : 0.0));
    scene::Bounds bounds;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 side(corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0,
                              corner & 4 ? 1.0 : -1.0);
        bounds.include(glm::vec3(box.center + box.axes * (side * half)));
    }
    return bounds;
}

bool LightEditor::hasUnsavedChanges() const {
    return impl_->isKnown && (impl_->isChanging || !impl_->history.isSaved());
}

void LightEditor::markSaved() {
    impl_->history.markSaved();
}

}  // namespace polylume::viewer
