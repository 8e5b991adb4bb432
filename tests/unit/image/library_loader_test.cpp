// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "image/library_loader.hpp"

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "image/image_io.hpp"
#include "polylume/error.hpp"

namespace polylume {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// Whether this program has a library mapped whose path holds `name`.
bool isLoaded(const std::string& name) {
    std::ifstream maps("/proc/self/maps");
    const std::string text{std::istreambuf_iterator<char>(maps), std::istreambuf_iterator<char>()};
    return text.find(name) != std::string::npos;
}

TEST(LibraryLoaderTest, looksBesideTheProgramFirst) {
    const auto candidates = imageLibraryCandidates();
    ASSERT_GE(candidates.size(), 3u);
    const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path();
    EXPECT_EQ(candidates[0], folder / "libpolylume_image_io.so");
    EXPECT_EQ(candidates[1], folder.parent_path() / "lib/polylume/libpolylume_image_io.so");
    EXPECT_EQ(candidates[2], "libpolylume_image_io.so");
}

TEST(LibraryLoaderTest, listsEachPlaceWhereNothingWas) {
    const fs::path candidates[] = {"/nonexistent/a.so", "/nonexistent/b.so"};
    try {
        openImageLibrary(candidates);
        FAIL() << "opened a library that is not there";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr("/nonexistent/a.so"),
                                        HasSubstr("/nonexistent/b.so"), HasSubstr("install")));
    }
}

TEST(LibraryLoaderTest, refusesALibraryThatIsNotOurs) {
    const fs::path candidates[] = {"libm.so.6"};
    try {
        openImageLibrary(candidates);
        FAIL() << "took the wrong library";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr("libm.so.6"), HasSubstr("version")));
    }
}

TEST(LibraryLoaderTest, refusesAnotherVersion) {
    loadImageLibrary();
    void* library = nullptr;
    for (const fs::path& candidate : imageLibraryCandidates()) {
        if (library == nullptr) library = ::dlopen(candidate.c_str(), RTLD_NOW | RTLD_NOLOAD);
    }
    ASSERT_NE(library, nullptr);
    const auto entry = reinterpret_cast<ImageLibraryEntry>(::dlsym(library, kImageLibrarySymbol));
    ASSERT_NE(entry, nullptr);
    EXPECT_NE(entry(kImageLibraryVersion), nullptr);
    EXPECT_EQ(entry(kImageLibraryVersion + 1), nullptr);
    ::dlclose(library);
}

TEST(LibraryLoaderTest, loadsOpenImageIoAtTheFirstUseOnly) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    // In a child, where no other test has used it.
    EXPECT_EXIT(
        {
            if (isLoaded("libOpenImageIO")) std::exit(1);
            loadImageLibrary();
            std::exit(isLoaded("libOpenImageIO") ? 0 : 2);
        },
        ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace polylume
