// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "image/jpeg_decoder.hpp"

// Before jpeglib.h, which does not include what it uses.
#include <cstddef>
#include <cstdio>
//
#include <jpeglib.h>

#include <array>
#include <csetjmp>

#include "core/text.hpp"
#include "image/image_limits.hpp"
#include "polylume/error.hpp"

namespace polylume {
namespace {

/// libjpeg's handler of errors, first, and what it needs.
struct ErrorHandler {
    jpeg_error_mgr base{};
    std::jmp_buf leave{};
    std::array<char, JMSG_LENGTH_MAX> message{};
};

[[noreturn]] void fail(j_common_ptr decoder) {
    auto* handler = reinterpret_cast<ErrorHandler*>(decoder->err);
    decoder->err->format_message(decoder, handler->message.data());
    std::longjmp(handler->leave, 1);
}

/// Of damage that is passed over, as browsers do.
void ignore(j_common_ptr /*decoder*/) {}

/// As Adobe stores it, inverted: 255 is no ink. In place, three bytes for four.
void convertCmykToRgb(std::vector<std::uint8_t>& pixels) {
    std::uint8_t* target = pixels.data();
    for (std::size_t i = 0; i < pixels.size(); i += 4) {
        const int black = pixels[i + 3];
        for (std::size_t c = 0; c < 3; ++c) {
            *target++ = static_cast<std::uint8_t>((pixels[i + c] * black + 127) / 255);
        }
    }
    pixels.resize(pixels.size() / 4 * 3);
}

class JpegDecoder {
  public:
    explicit JpegDecoder(std::string_view name) : name_(name) {
        decoder_.err = jpeg_std_error(&handler_.base);
        handler_.base.error_exit = &fail;
        handler_.base.output_message = &ignore;
        attempt([&] { jpeg_create_decompress(&decoder_); });
    }
    ~JpegDecoder() { jpeg_destroy_decompress(&decoder_); }
    JpegDecoder(const JpegDecoder&) = delete;
    JpegDecoder& operator=(const JpegDecoder&) = delete;

    PixelImage decode(std::span<const std::byte> encoded) {
        attempt([&] {
            jpeg_mem_src(&decoder_, reinterpret_cast<const unsigned char*>(encoded.data()),
                         encoded.size());
            jpeg_read_header(&decoder_, TRUE);
            jpeg_calc_output_dimensions(&decoder_);
        });
        PixelImage image;
        image.channelCount = decoder_.output_components;
        checkPixelCount(decoder_.output_width, decoder_.output_height, image.channelCount, name_);
        if (image.channelCount > 4) {
            throw Error(concat("can't decode ", name_, ": expected 1 to 4 channels, found ",
                               image.channelCount));
        }
        image.width = static_cast<int>(decoder_.output_width);
        image.height = static_cast<int>(decoder_.output_height);
        const std::size_t rowBytes =
            static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channelCount);
        image.pixels.resize(rowBytes * static_cast<std::size_t>(image.height));
        attempt([&] {
            jpeg_start_decompress(&decoder_);
            while (decoder_.output_scanline < decoder_.output_height) {
                JSAMPROW row = image.pixels.data() + decoder_.output_scanline * rowBytes;
                jpeg_read_scanlines(&decoder_, &row, 1);
            }
        });
        if (image.channelCount == 4) {
            convertCmykToRgb(image.pixels);
            image.channelCount = 3;
        }
        return image;
    }

  private:
    /// Calls `work`, which calls libjpeg. Throws where libjpeg gave up, by a longjmp out of it:
    /// whatever lives in `work` has no destructor.
    template <typename Work>
    void attempt(const Work& work) {
        if (setjmp(handler_.leave) != 0) {
            throw Error(concat("can't decode ", name_, ": ", handler_.message.data()));
        }
        work();
    }

    std::string_view name_;
    ErrorHandler handler_;
    jpeg_decompress_struct decoder_{};
};

}  // namespace

PixelImage decodeJpeg(std::span<const std::byte> encoded, std::string_view name) {
    return JpegDecoder(name).decode(encoded);
}

}  // namespace polylume
