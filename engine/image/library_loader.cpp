// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "image/library_loader.hpp"

#include <dlfcn.h>

#include <string>
#include <system_error>

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume {
namespace {

namespace fs = std::filesystem;

const ImageLibrary& fetchTable(void* library, const fs::path& path) {
    const auto entry = reinterpret_cast<ImageLibraryEntry>(::dlsym(library, kImageLibrarySymbol));
    const ImageLibrary* table = entry != nullptr ? entry(kImageLibraryVersion) : nullptr;
    if (table == nullptr) {
        throw Error(concat("expected version ", kImageLibraryVersion,
                           " of Polylume's image library, found another one (", path.string(),
                           "); build or install it together with the program"));
    }
    return *table;
}

}  // namespace

std::vector<fs::path> imageLibraryCandidates() {
    const fs::path name = POLYLUME_IMAGE_LIBRARY_NAME;
    std::vector<fs::path> candidates;
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (!error) {
        const fs::path folder = program.parent_path();
        candidates.push_back(folder / name);
        candidates.push_back(folder.parent_path() / "lib" / "polylume" / name);
    }
    candidates.push_back(name);
    candidates.push_back(fs::path(POLYLUME_IMAGE_LIBRARY_DIR) / name);
    return candidates;
}

const ImageLibrary& openImageLibrary(std::span<const fs::path> candidates) {
    std::string reasons;
    for (const fs::path& candidate : candidates) {
        // Local: OpenImageIO's 260 libraries must not lend their symbols to the OpenGL drivers.
        // Lazy: few of their 150,000 symbols are ever called, and to bind them all takes 10 ms.
        void* library = ::dlopen(candidate.c_str(), RTLD_LAZY | RTLD_LOCAL);
        if (library != nullptr) return fetchTable(library, candidate);
        reasons += concat("\n  ", ::dlerror());
    }
    throw Error(
        concat("can't open Polylume's image library, which reads and writes OpenEXR; "
               "build it or install it beside the program, and OpenImageIO with it "
               "(Debian: libopenimageio2.4). Tried:",
               reasons));
}

}  // namespace polylume
