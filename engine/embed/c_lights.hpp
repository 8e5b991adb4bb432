// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "polylume/light.hpp"
#include "polylume/polylume.h"

namespace polylume::embed {

/// The lights of a handle of the C API as C++ has them. They keep their storage from update to
/// update, each light its own, so that one that keeps its kind is copied without allocation.
class CLights {
  public:
    /// A copy of `lights`. Throws Error that names the field where a pointer that is needed is
    /// null, an enumeration's value unknown or an image's size none; other values are not checked.
    static CLights copyOf(const polylume_light_set& lights);

    const LightSet& set() const { return set_; }

    /// Copies `count` lights to the places from `first`. Throws Error as copyOf() and where there
    /// are no such places; which of them are overwritten then is open, and set() no longer what it
    /// was, but the next update is as good as if that one had not been. The result is valid until
    /// the next call.
    std::span<const PolygonLight> updatePolygons(std::size_t first,
                                                 const polylume_polygon_light* lights,
                                                 std::size_t count);
    std::span<const EllipseLight> updateEllipses(std::size_t first,
                                                 const polylume_ellipse_light* lights,
                                                 std::size_t count);
    std::span<const SphereLight> updateSpheres(std::size_t first,
                                               const polylume_sphere_light* lights,
                                               std::size_t count);
    std::span<const TubeLight> updateTubes(std::size_t first, const polylume_tube_light* lights,
                                           std::size_t count);
    std::span<const PunctualLight> updatePunctuals(std::size_t first,
                                                   const polylume_punctual_light* lights,
                                                   std::size_t count);

    /// To be called when the lights of an updatePolygons() are in use: takes over their images.
    void keepImages(std::size_t first, std::size_t count);

  private:
    LightSet set_;
    /// Of the polygons as they are in use, which an update that failed does not touch.
    std::vector<std::shared_ptr<const LightImage>> images_;
};

}  // namespace polylume::embed
