// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "light_panel.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "core/limits.hpp"
#include "core/text.hpp"
#include "image/srgb.hpp"
#include "polylume/error.hpp"
#include "scene/light_image_reader.hpp"

namespace polylume::viewer {
namespace {

// The colour of a light is edited as a screen shows it and stored linear, at full brightness; the
// intensity is the largest channel.

glm::vec3 encoded(const glm::vec3& linear) {
    glm::vec3 code;
    for (int i = 0; i < 3; ++i) code[i] = srgbFromLinear(std::clamp(linear[i], 0.0f, 1.0f));
    return code;
}

glm::vec3 decoded(const glm::vec3& code) {
    glm::vec3 linear;
    for (int i = 0; i < 3; ++i) linear[i] = linearFromSrgb(std::clamp(code[i], 0.0f, 1.0f));
    return linear;
}

float largest(const glm::vec3& v) {
    return std::max({v.r, v.g, v.b});
}

/// "softbox", or "Rectangle 3" for one without a name.
std::string labelOf(const AnyLight& light, int index) {
    if (!nameOf(light).empty()) return nameOf(light);
    return concat(nameOf(kindOf(light)), " ", index + 1);
}

ImVec4 swatchOf(const AnyLight& light) {
    const glm::vec3 emission = emissionOf(light);
    const float most = largest(emission);
    const glm::vec3 code = most > 0.0f ? encoded(emission / most) : glm::vec3(0.0f);
    return {code.r, code.g, code.b, 1.0f};
}

bool button(const char* text, const char* help, bool isEnabled = true) {
    ImGui::BeginDisabled(!isEnabled);
    const bool isPressed = ImGui::Button(text);
    ImGui::EndDisabled();
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
    return isPressed;
}

/// A positive length with a drag of its own order of magnitude.
bool dragLength(const char* label, double& metres, double least) {
    constexpr double kMost = 1e6;
    const float speed = std::max(1e-4f, static_cast<float>(metres) * 0.01f);
    if (!ImGui::DragScalar(label, ImGuiDataType_Double, &metres, speed, &least, &kMost, "%.4g m")) {
        return false;
    }
    metres = std::isfinite(metres) ? std::clamp(metres, least, kMost) : least;
    return true;
}

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

void LightPanel::reset() {
    turnDegrees_.reset();
    color_.reset();
    pictureError_.clear();
}

PanelRequest LightPanel::drawList(const scene::Scene& scene, std::optional<LightId> selected,
                                  bool canUndo, bool canRedo) {
    PanelRequest request;
    if (ImGui::Button("Add")) ImGui::OpenPopup("add light");
    if (ImGui::BeginPopup("add light")) {
        for (const LightKind kind : kLightKinds) {
            if (ImGui::MenuItem(nameOf(kind))) request.add = kind;
            if (kind == LightKind::tube) ImGui::Separator();
        }
        ImGui::EndPopup();
    }
    ImGui::SameLine();
    request.duplicate = button("Copy", "Duplicate the light (Ctrl+D)", selected.has_value());
    ImGui::SameLine();
    request.remove = button("Delete", "Delete the light (Delete)", selected.has_value());
    ImGui::SameLine();
    request.undo = button("Undo", "Ctrl+Z", canUndo);
    ImGui::SameLine();
    request.redo = button("Redo", "Ctrl+Shift+Z", canRedo);

    const int areaCount = static_cast<int>(scene.areaLights.size());
    const int count = areaCount + static_cast<int>(scene.punctualLights.size());
    const float row = ImGui::GetTextLineHeightWithSpacing();
    const float height = row * static_cast<float>(std::clamp(count, 2, 8)) +
                         2.0f * ImGui::GetStyle().WindowPadding.y;
    if (ImGui::BeginChild("lights", {0.0f, height}, true)) {
        if (count == 0) ImGui::TextDisabled("No light: Add makes one");
        // A scene may have thousands.
        ImGuiListClipper clipper;
        clipper.Begin(count);
        while (clipper.Step()) {
            for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
                const bool isArea = i < areaCount;
                const LightId id{isArea ? LightId::Kind::area : LightId::Kind::punctual,
                                 isArea ? i : i - areaCount};
                const AnyLight light =
                    isArea ? AnyLight(scene.areaLights[static_cast<std::size_t>(id.index)])
                           : AnyLight(scene.punctualLights[static_cast<std::size_t>(id.index)]);
                ImGui::PushID(i);
                const float size = ImGui::GetTextLineHeight();
                ImGui::ColorButton("##hue", swatchOf(light),
                                   ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop,
                                   {size, size});
                ImGui::SameLine();
                if (ImGui::Selectable(labelOf(light, id.index).c_str(), selected == id)) {
                    request.select = id;
                }
                ImGui::PopID();
            }
        }
    }
    ImGui::EndChild();
    return request;
}

void LightPanel::drawModes(LightGizmo& gizmo) {
    const auto mode = [&](const char* text, const char* help, GizmoMode value) {
        if (ImGui::RadioButton(text, gizmo.mode == value)) gizmo.mode = value;
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
    };
    // On the same line as far as there is room.
    const auto next = [](const char* text) {
        const ImGuiStyle& style = ImGui::GetStyle();
        const float width =
            ImGui::GetFrameHeight() + style.ItemInnerSpacing.x + ImGui::CalcTextSize(text).x;
        const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
        if (ImGui::GetItemRectMax().x + style.ItemSpacing.x + width <= right) ImGui::SameLine();
    };
    mode("Move", "1", GizmoMode::move);
    next("Turn");
    mode("Turn", "2", GizmoMode::turn);
    next("Resize");
    mode("Resize", "3", GizmoMode::resize);
    next("Off");
    mode("Off", "4: no handles", GizmoMode::none);
    next("World axes");
    ImGui::Checkbox("World axes", &gizmo.usesWorldAxes);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("X: move and turn along the world's axes");
}

std::optional<AnyLight> LightPanel::drawFields(const AnyLight& light, const glm::dmat3& hint,
                                               const scene::Scene& images,
                                               const scene::Scene& lights) {
    AnyLight changed = light;
    bool hasChanged = false;
    std::string name = nameOf(changed);
    if (ImGui::InputTextWithHint("Name", "none", &name)) {
        setName(changed, name);
        hasChanged = true;
    }
    const LightKind kind = kindOf(changed);
    if (ImGui::BeginCombo("Shape", nameOf(kind))) {
        for (const LightKind other : kLightKinds) {
            if (!ImGui::Selectable(nameOf(other), other == kind) || other == kind) continue;
            changed = converted(changed, other, boxOf(changed, hint).axes);
            hasChanged = true;
        }
        ImGui::EndCombo();
    }
    hasChanged |= drawPlace(changed, hint);
    hasChanged |= drawSize(changed, hint);
    hasChanged |= drawEmission(changed);
    if (auto* punctual = std::get_if<scene::PunctualLight>(&changed)) {
        hasChanged |= drawPunctual(*punctual);
    } else {
        hasChanged |= drawSides(changed);
        hasChanged |= drawPicture(changed, hint, images, lights);
    }
    return hasChanged ? std::optional(changed) : std::nullopt;
}

bool LightPanel::drawPlace(AnyLight& light, const glm::dmat3& hint) {
    bool hasChanged = false;
    const LightBox box = boxOf(light, hint);
    glm::vec3 center(box.center);
    if (ImGui::DragFloat3("Place", &center.x, 0.01f, 0.0f, 0.0f, "%.3f") && isFinite(center) &&
        largest(glm::abs(center)) < 1e9f) {
        LightBox to = box;
        to.center = glm::dvec3(center);
        light = moved(light, box, to);
        hasChanged = true;
    }
    if (!hasDirection(kindOf(light))) return hasChanged;
    // What is being edited stays as it was typed, however the axes may be said as well.
    glm::vec3 turn(turnDegrees_.value_or(turnOf(box.axes)));
    for (int i = 0; i < 3; ++i) {
        // Rounding is no turn, and -0.0 is 0.
        if (std::abs(turn[i]) < 5e-5f) turn[i] = 0.0f;
    }
    const bool isTurned = ImGui::DragFloat3("Turn", &turn.x, 0.5f, 0.0f, 0.0f, "%.1f\xC2\xB0");
    const bool isActive = ImGui::IsItemActive();
    if (isTurned && isFinite(turn)) {
        LightBox from = boxOf(light, hint), to = from;
        to.axes = axesOf(glm::dvec3(turn));
        light = moved(light, from, to);
        hasChanged = true;
    }
    turnDegrees_ = isActive ? std::optional(glm::dvec3(turn)) : std::nullopt;
    return hasChanged;
}

bool LightPanel::drawSize(AnyLight& light, const glm::dmat3& hint) {
    const LightKind kind = kindOf(light);
    if (!isArea(kind)) return false;
    const LightBox from = boxOf(light, hint);
    LightBox to = from;
    bool hasChanged = false;
    if (kind == LightKind::sphere) {
        hasChanged = dragLength("Radius", to.half.x, kLeastExtent);
        to.half = glm::dvec3(to.half.x);
    } else if (kind == LightKind::tube) {
        double length = 2.0 * (to.half.x - to.half.y);
        hasChanged = dragLength("Length", length, 0.0);
        hasChanged |= dragLength("Radius", to.half.y, kLeastExtent);
        to.half.z = to.half.y;
        to.half.x = 0.5 * length + to.half.y;
    } else {
        double width = 2.0 * to.half.x, height = 2.0 * to.half.y;
        hasChanged = dragLength("Width", width, 2.0 * kLeastExtent);
        hasChanged |= dragLength("Height", height, 2.0 * kLeastExtent);
        to.half = {0.5 * width, 0.5 * height, 0.0};
    }
    if (hasChanged) light = moved(light, from, to);
    if (kind != LightKind::polygon) return hasChanged;
    auto& area = std::get<scene::AreaLight>(light);
    const auto& contours = std::get<PolygonLight>(area.shape).contours;
    int corners = static_cast<int>(contours.front().size());
    if (contours.size() > 1) {
        const int holes = static_cast<int>(contours.size()) - 1;
        ImGui::TextDisabled("%d corners, %d hole%s", corners, holes, holes == 1 ? "" : "s");
    } else if (ImGui::SliderInt("Corners", &corners, 3, 24, "%d", ImGuiSliderFlags_AlwaysClamp)) {
        area = withCorners(area, corners, boxOf(light, hint));
        hasChanged = true;
    }
    return hasChanged;
}

bool LightPanel::drawEmission(AnyLight& light) {
    const glm::vec3 emission = emissionOf(light);
    float intensity = largest(emission);
    glm::vec3 color = encoded(intensity > 0.0f ? emission / intensity : glm::vec3(1.0f));
    // A dark light, or a colour that is being dragged through black, keeps its hue.
    if (color_) color = *color_;
    bool hasChanged = false;
    const bool isColored = ImGui::ColorEdit3("Colour", &color.r);
    const bool isActive = ImGui::IsItemActive();
    const LightKind kind = kindOf(light);
    const char* const unit = isArea(kind)                     ? "%.5g cd/m\xC2\xB2"
                             : kind == LightKind::directional ? "%.5g lx"
                                                              : "%.5g cd";
    // Of the range that a drag of a pixel goes through; about 2 percent of the value.
    constexpr float kMostIntensity = 1e9f;
    constexpr float kSpeed = 5e-4f * kMostIntensity;
    const float before = intensity;
    const bool isScaled =
        ImGui::DragFloat("Intensity", &intensity, kSpeed, 0.0f, kMostIntensity, unit,
                         ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoRoundToFormat);
    intensity = std::isfinite(intensity) ? std::clamp(intensity, 0.0f, kLargestEmission) : before;
    if (isColored || before == 0.0f) {
        // A swatch says the hue; how dark it is would say the intensity twice.
        const glm::vec3 linear = decoded(color);
        const float most = largest(linear);
        if (most > 0.0f && (isColored || isScaled)) setEmission(light, intensity / most * linear);
    } else if (isScaled) {
        setEmission(light, intensity / before * emission);
    }
    hasChanged = isColored || isScaled;
    const bool keepsColor = isActive || intensity == 0.0f;
    color_ = keepsColor ? std::optional(color) : std::nullopt;
    if (const auto flux = fluxOf(light)) {
        ImGui::TextDisabled(*flux < 1000.0 ? "%.4g lm" : "%.0f lm", *flux);
    }
    return hasChanged;
}

bool LightPanel::drawSides(AnyLight& light) {
    bool twoSided = isTwoSided(light);
    const bool isRound = !isFlat(kindOf(light));
    const bool hasChanged =
        ImGui::Checkbox(isRound ? "Shines inwards, too" : "Both sides shine", &twoSided);
    if (hasChanged) setTwoSided(light, twoSided);
    auto* polygon = std::get_if<PolygonLight>(&std::get<scene::AreaLight>(light).shape);
    if (polygon == nullptr || !polygon->shownBySurface) return hasChanged;
    ImGui::TextDisabled("Shown by an emissive surface");
    return hasChanged;
}

bool LightPanel::drawPicture(AnyLight& light, const glm::dmat3& hint, const scene::Scene& images,
                             const scene::Scene& lights) {
    const LightKind kind = kindOf(light);
    if (kind != LightKind::rectangle && kind != LightKind::polygon) return false;
    auto& area = std::get<scene::AreaLight>(light);
    const std::shared_ptr<const LightImage> shown = pictureOf(light);
    const auto describe = [](const LightImage& image) {
        return concat(image.size.x, " x ", image.size.y);
    };
    bool hasChanged = false;
    const auto show = [&](std::shared_ptr<const LightImage> image) {
        setPicture(area, std::move(image), boxOf(light, hint));
        pictureError_.clear();
        hasChanged = true;
    };
    if (ImGui::BeginCombo("Picture", shown ? describe(*shown).c_str() : "none")) {
        if (ImGui::Selectable("none", !shown) && shown) show(nullptr);
        std::vector<std::shared_ptr<const LightImage>> known;
        for (std::size_t i = 0; i < lights.areaLights.size(); ++i) {
            const auto image = pictureOf(lights.areaLights[i]);
            if (!image || std::ranges::find(known, image) != known.end()) continue;
            known.push_back(image);
            ImGui::PushID(static_cast<int>(i));
            const std::string label = concat(
                "of ", labelOf(lights.areaLights[i], static_cast<int>(i)), ", ", describe(*image));
            if (ImGui::Selectable(label.c_str(), image == shown) && image != shown) show(image);
            ImGui::PopID();
        }
        for (std::size_t i = 0; i < images.images.size(); ++i) {
            const PixelImage& image = images.images[i];
            const std::string label =
                concat("image ", i, " of the scene, ", image.width, " x ", image.height);
            if (ImGui::Selectable(label.c_str())) {
                show(std::make_shared<LightImage>(scene::linearImage(image)));
            }
        }
        ImGui::EndCombo();
    }
    const bool isEntered = ImGui::InputTextWithHint("File", "PNG, JPEG or OpenEXR", &pictureFile_,
                                                    ImGuiInputTextFlags_EnterReturnsTrue);
    if (isEntered && !pictureFile_.empty()) {
        try {
            show(std::make_shared<LightImage>(scene::readLightImage(pictureFile_)));
        } catch (const Error& error) {
            pictureError_ = error.what();
        }
    }
    if (!pictureError_.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1.0f, 0.45f, 0.4f, 1.0f));
        ImGui::TextWrapped("%s", pictureError_.c_str());
        ImGui::PopStyleColor();
    }
    return hasChanged;
}

bool LightPanel::drawPunctual(scene::PunctualLight& light) {
    bool hasChanged = false;
    if (light.type != scene::PunctualLightType::directional) {
        bool isEndless = std::isinf(light.range);
        if (ImGui::Checkbox("Endless range", &isEndless)) {
            light.range = isEndless ? INFINITY : 10.0f;
            hasChanged = true;
        }
        double range = light.range;
        if (!isEndless && dragLength("Range", range, kLeastExtent)) {
            light.range = static_cast<float>(range);
            hasChanged = true;
        }
    }
    if (light.type != scene::PunctualLightType::spot) return hasChanged;
    // Cones are apart by as much as the reader asks for.
    constexpr float kApart = 1e-4f;
    float inner = glm::degrees(light.innerConeAngle);
    float outer = glm::degrees(light.outerConeAngle);
    constexpr ImGuiSliderFlags kClamp = ImGuiSliderFlags_AlwaysClamp;
    if (ImGui::SliderFloat("Outer cone", &outer, 0.1f, 90.0f, "%.1f\xC2\xB0", kClamp)) {
        light.outerConeAngle = glm::radians(outer);
        light.innerConeAngle = std::min(light.innerConeAngle, light.outerConeAngle - kApart);
        hasChanged = true;
    }
    if (ImGui::SliderFloat("Inner cone", &inner, 0.0f, 90.0f, "%.1f\xC2\xB0", kClamp)) {
        light.innerConeAngle = std::clamp(glm::radians(inner), 0.0f, light.outerConeAngle - kApart);
        hasChanged = true;
    }
    return hasChanged;
}

}  // namespace polylume::viewer
