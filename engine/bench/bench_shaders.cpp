// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "bench/bench_shaders.hpp"

#include "core/embedded_file.hpp"

namespace polylume {

std::span<const EmbeddedFile> benchGlslFiles();  // Generated (cmake/EmbedFiles.cmake).

namespace bench {

gl::ShaderLibrary makeShaderLibrary() {
    gl::ShaderLibrary library;
    for (const EmbeddedFile& file : benchGlslFiles()) {
        const std::string path = "bench/" + std::string(file.path);
        library.setFile(path, std::string(file.bytes.begin(), file.bytes.end()), path);
    }
    return library;
}

}  // namespace bench
}  // namespace polylume
