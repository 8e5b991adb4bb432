// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "core/file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void throwSystemError(std::string_view action, const fs::path& path) {
    const int reason = errno;
    throw Error(concat("can't ", action, " ", path.string(), ": ", std::strerror(reason)));
}

template <typename Container>
Container readAll(const fs::path& path) {
    // A folder opens as a file and only fails when read; a pipe may never end.
    if (fs::is_directory(path)) throw Error(concat("can't read ", path.string(), ": is a folder"));
    if (fs::exists(path) && !fs::is_regular_file(path)) {
        throw Error(concat("can't read ", path.string(), ": is a device or a pipe, no file"));
    }
    errno = 0;
    std::ifstream stream(path, std::ios::binary | std::ios::ate);
    if (!stream) throwSystemError("read", path);
    Container content(static_cast<std::size_t>(stream.tellg()), {});
    stream.seekg(0);
    stream.read(reinterpret_cast<char*>(content.data()),
                static_cast<std::streamsize>(content.size()));
    if (!stream) throwSystemError("read", path);
    return content;
}

/// A name beside `path` that no other process uses, created empty. The extension stays, since image
/// writers choose their format by it.
fs::path createTemporaryBeside(const fs::path& path) {
    for (int attempt = 0; attempt < 100; ++attempt) {
        fs::path candidate = path.parent_path();
        candidate /= concat(".", path.stem().string(), "-", ::getpid(), "-", attempt,
                            path.extension().string());
        const int file = ::open(candidate.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
        if (file >= 0) {
            ::close(file);
            return candidate;
        }
        if (errno != EEXIST) break;
    }
    const std::string reason = std::strerror(errno);
    throw Error(
        concat("can't write ", path.string(), ": no file can be made in its folder: ", reason));
}

}  // namespace

std::vector<std::byte> readFile(const fs::path& path) {
    return readAll<std::vector<std::byte>>(path);
}

std::string readTextFile(const fs::path& path) {
    return readAll<std::string>(path);
}

void checkWritable(const fs::path& path) {
    if (fs::is_directory(path)) throw Error(concat("can't write ", path.string(), ": is a folder"));
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (!fs::is_directory(folder)) {
        throw Error(concat("expected a folder to write ", path.string(), " into, found none at ",
                           folder.string(), ": create it"));
    }
    // Only a file that was made tells: some folders take none, whatever their permissions say.
    fs::remove(createTemporaryBeside(path));
}

void writeFileAtomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
    const fs::path temporary = createTemporaryBeside(path);
    try {
        write(temporary);
        std::error_code error;
        fs::rename(temporary, path, error);
        if (error) throw Error(concat("can't write ", path.string(), ": ", error.message()));
    } catch (...) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw;
    }
}

void writeFile(const fs::path& path, std::span<const std::byte> bytes) {
    writeFileAtomically(path, [&](const fs::path& temporary) {
        errno = 0;
        std::ofstream stream(temporary, std::ios::binary);
        stream.write(reinterpret_cast<const char*>(bytes.data()),
                     static_cast<std::streamsize>(bytes.size()));
        stream.close();
        if (!stream) throwSystemError("write", path);
    });
}

}  // namespace polylume
