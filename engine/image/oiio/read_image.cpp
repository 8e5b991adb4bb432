// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <memory>
#include <string_view>

#include "core/text.hpp"
#include "image/image_limits.hpp"
#include "oiio_calls.hpp"
#include "polylume/error.hpp"

namespace polylume::oiio {
namespace {

ImageMetadata readMetadata(const OIIO::ImageSpec& spec) {
    ImageMetadata metadata;
    for (const OIIO::ParamValue& value : spec.extra_attribs) {
        const std::string name = value.name().string();
        if (value.type() == OIIO::TypeString) {
            metadata[name] = value.get_string();
        } else if (value.type() == OIIO::TypeInt) {
            metadata[name] = value.get_int();
        } else if (value.type() == OIIO::TypeFloat) {
            metadata[name] = value.get_float();
        }
    }
    return metadata;
}

PixelValues valuesOf(const OIIO::ImageInput& file) {
    // An OpenEXR's integers are identities of objects and such, beside or in place of radiance.
    const bool isExr = std::string_view(file.format_name()) == "openexr";
    return isExr || file.spec().format.is_floating_point() ? PixelValues::linear
                                                           : PixelValues::display;
}

/// Throws Error that names `name` when the image has no pixels, too many, or is not a flat picture.
void checkSize(const OIIO::ImageSpec& spec, std::string_view name) {
    if (spec.deep || spec.depth > 1) {
        throw Error(concat("can't read ", name, ": expected a flat picture, found a ",
                           spec.deep ? "deep image" : "volume"));
    }
    checkPixelCount(spec.width, spec.height, spec.nchannels, name);
}

}  // namespace

FloatImage read(const std::filesystem::path& path) {
    OIIO::ImageSpec wanted;
    wanted.attribute("oiio:UnassociatedAlpha", 1);
    const std::unique_ptr<OIIO::ImageInput> file = OIIO::ImageInput::open(path.string(), &wanted);
    const auto fail = [&] {
        throw Error(concat("can't read ", path.string(), ": ", takeMessage(file.get())));
    };
    if (file == nullptr) fail();
    const OIIO::ImageSpec& spec = file->spec();
    checkSize(spec, path.string());

    FloatImage image;
    image.width = spec.width;
    image.height = spec.height;
    image.channelNames = spec.channelnames;
    image.values = valuesOf(*file);
    image.metadata = readMetadata(spec);
    image.pixels.resize(static_cast<std::size_t>(spec.width) * spec.height * spec.nchannels);
    if (!file->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.pixels.data())) {
        fail();
    }
    image.hasMoreParts = file->seek_subimage(1, 0);
    file->close();
    takeMessage(file.get());
    return image;
}

}  // namespace polylume::oiio
