// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "compare/flip.hpp"
#include "image/image.hpp"

namespace polylume::compare {

/// A picture with what messages call it, as a file's name.
struct NamedPicture {
    std::string name;
    FloatImage image;
};

/// The layer of reference pictures that says how noisy they are; it is part of no comparison that
/// doesn't ask for it.
inline constexpr const char* kStandardErrorLayer = "standardError";

/// Channels that are measured together.
struct Layer {
    std::string name;                   ///< "color", a layer's name, or a single channel's.
    std::vector<std::string> channels;  ///< Their names in the file.
    std::vector<std::size_t> testIndices;
    std::vector<std::size_t> referenceIndices;
};

/// Two pictures that can be compared.
class PicturePair {
  public:
    /// Keeps references to both. `channels` are those to compare, by name; empty: all, without the
    /// layer kStandardErrorLayer. Throws Error where the pictures differ in size, in their channels
    /// or in what their values mean, where a channel that was asked for is missing, and where a
    /// value is not finite.
    PicturePair(const NamedPicture& test, const NamedPicture& reference,
                const std::vector<std::string>& channels);

    const FloatImage& test() const { return test_.image; }
    const FloatImage& reference() const { return reference_.image; }

    /// The colours first, where there are any: R, G, B or the grey Y, outside any layer, or in the
    /// only layer there is. Then each layer of the file, and each other channel alone.
    const std::vector<Layer>& layers() const { return layers_; }
    bool hasColor() const { return hasColor_; }

    /// The colours of each, where there are any: linear where they are radiance, decoded to linear
    /// where they are display values; grey in all three channels.
    ColorImage testColors() const;
    ColorImage referenceColors() const;

  private:
    void makeLayers(const std::vector<std::string>& names);
    void checkFinite(const NamedPicture& picture, std::vector<std::size_t> Layer::*indices) const;

    const NamedPicture& test_;
    const NamedPicture& reference_;
    std::vector<Layer> layers_;
    bool hasColor_ = false;
};

}  // namespace polylume::compare
