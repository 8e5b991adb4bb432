// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>

#include <cstdlib>
#include <map>
#include <new>
#include <string_view>

#include "embed_fixture.hpp"
#include "gl/functions.hpp"

namespace {

/// Heap allocations of this thread since the count began.
thread_local bool isCounting = false;
thread_local long heapCount = 0;

void* allocate(std::size_t size) {
    if (isCounting) ++heapCount;
    if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
    throw std::bad_alloc();
}

}  // namespace

// All allocations in C++, of the whole program.
void* operator new(std::size_t size) {
    return allocate(size);
}
void* operator new[](std::size_t size) {
    return allocate(size);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    if (isCounting) ++heapCount;
    return std::malloc(size == 0 ? 1 : size);
}
void* operator new[](std::size_t size, const std::nothrow_t& tag) noexcept {
    return operator new(size, tag);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace polylume {
namespace {

using test::HostPicture;
using test::makeEveryLight;

long objectCalls = 0;

/// Stands before an OpenGL function that makes an object or gives it memory, and counts its calls.
template <int id, typename Function>
struct Counted;
template <int id, typename Result, typename... Arguments>
struct Counted<id, Result (*)(Arguments...)> {
    static inline Result (*original)(Arguments...) = nullptr;
    static Result call(Arguments... arguments) {
        ++objectCalls;
        return original(arguments...);
    }
};

using Function = void (*)();
using Wrap = Function (*)(Function);

template <int id, typename Pointer>
Function wrap(Function original) {
    Counted<id, Pointer>::original = reinterpret_cast<Pointer>(original);
    return reinterpret_cast<Function>(&Counted<id, Pointer>::call);
}

#define POLYLUME_COUNTED(Name) \
    { "gl" #Name, &wrap<__COUNTER__, decltype(gl::Functions().Name)> }

const std::map<std::string_view, Wrap> kCounted = {
    POLYLUME_COUNTED(BufferData),
    POLYLUME_COUNTED(BufferStorage),
    POLYLUME_COUNTED(CompileShader),
    POLYLUME_COUNTED(CreateBuffers),
    POLYLUME_COUNTED(CreateFramebuffers),
    POLYLUME_COUNTED(CreateProgram),
    POLYLUME_COUNTED(CreateProgramPipelines),
    POLYLUME_COUNTED(CreateQueries),
    POLYLUME_COUNTED(CreateRenderbuffers),
    POLYLUME_COUNTED(CreateSamplers),
    POLYLUME_COUNTED(CreateShader),
    POLYLUME_COUNTED(CreateShaderProgramv),
    POLYLUME_COUNTED(CreateTextures),
    POLYLUME_COUNTED(CreateTransformFeedbacks),
    POLYLUME_COUNTED(CreateVertexArrays),
    POLYLUME_COUNTED(GenBuffers),
    POLYLUME_COUNTED(GenFramebuffers),
    POLYLUME_COUNTED(GenProgramPipelines),
    POLYLUME_COUNTED(GenQueries),
    POLYLUME_COUNTED(GenRenderbuffers),
    POLYLUME_COUNTED(GenSamplers),
    POLYLUME_COUNTED(GenTextures),
    POLYLUME_COUNTED(GenTransformFeedbacks),
    POLYLUME_COUNTED(GenVertexArrays),
    POLYLUME_COUNTED(GenerateMipmap),
    POLYLUME_COUNTED(GenerateTextureMipmap),
    POLYLUME_COUNTED(LinkProgram),
    POLYLUME_COUNTED(NamedBufferData),
    POLYLUME_COUNTED(NamedBufferStorage),
    POLYLUME_COUNTED(NamedRenderbufferStorage),
    POLYLUME_COUNTED(NamedRenderbufferStorageMultisample),
    POLYLUME_COUNTED(RenderbufferStorage),
    POLYLUME_COUNTED(RenderbufferStorageMultisample),
    POLYLUME_COUNTED(TexImage1D),
    POLYLUME_COUNTED(TexImage2D),
    POLYLUME_COUNTED(TexImage2DMultisample),
    POLYLUME_COUNTED(TexImage3D),
    POLYLUME_COUNTED(TexImage3DMultisample),
    POLYLUME_COUNTED(TexStorage1D),
    POLYLUME_COUNTED(TexStorage2D),
    POLYLUME_COUNTED(TexStorage2DMultisample),
    POLYLUME_COUNTED(TexStorage3D),
    POLYLUME_COUNTED(TexStorage3DMultisample),
    POLYLUME_COUNTED(TextureStorage1D),
    POLYLUME_COUNTED(TextureStorage2D),
    POLYLUME_COUNTED(TextureStorage2DMultisample),
    POLYLUME_COUNTED(TextureStorage3D),
    POLYLUME_COUNTED(TextureStorage3DMultisample),
};

/// Whether a function makes an object or gives it memory, by its name.
bool isAllocating(std::string_view name) {
    if (name.starts_with("glClear") || name.starts_with("glInvalidate") ||
        name == "glShaderStorageBlockBinding") {
        return false;
    }
    return name.starts_with("glCreate") || name.starts_with("glGen") ||
           name.find("Storage") != name.npos || name.find("BufferData") != name.npos;
}

class SteadyFrameTest : public test::EmbedTest {
  protected:
    /// As a host's, through the counters. All functions that allocate are among them.
    GetProcAddress countingGetProcAddress() {
        return [this, find = test::getProcAddressOf(GetParam())](const char* name) -> Function {
            const auto counted = kCounted.find(name);
            const Function found = find(name);
            if (counted != kCounted.end() && found != nullptr) return counted->second(found);
            if (isAllocating(name)) uncounted_.emplace_back(name);
            return found;
        };
    }

    void expectSteady(const AreaLightingOptions& options);
    void expectSteadyLists(const AreaLightingOptions& options);

    std::vector<std::string> uncounted_;
};

/// What a host does from frame to frame, with inputs made before.
struct Frames {
    AreaLighting& lighting;
    std::vector<LightSet> lights;  ///< None: they stay.
    std::vector<LightingFrame> frames;
    GLuint film;

    void run(int count) {
        for (int i = 0; i < count; ++i) {
            update(i);
            lighting.updateLightTexture(i % 2 == 0 ? 1 : 4, film);
            lighting.setLobes(i % 3 == 0 ? Lobes::specular : Lobes::all);
            lighting.draw(frames[static_cast<std::size_t>(i) % frames.size()]);
            lighting.gpuTimeSeconds();
        }
    }

  private:
    void update(int i) {
        if (lights.empty()) return;
        const LightSet& set = lights[static_cast<std::size_t>(i) % lights.size()];
        lighting.updatePolygons(0, set.polygons);
        lighting.updatePolygons(2, std::span(set.polygons).subspan(2, 3));
        lighting.updateEllipses(0, set.ellipses);
        lighting.updateSpheres(0, set.spheres);
        lighting.updateTubes(0, set.tubes);
        lighting.updatePunctuals(0, set.punctuals);
    }
};

void SteadyFrameTest::expectSteady(const AreaLightingOptions& options) {
    const HostPicture picture(gl());
    const HostPicture small(gl(), {24, 16});
    if (!options.surfaceGlsl.empty()) test::bindForSnippet(gl(), picture);
    AreaLighting lighting(countingGetProcAddress(), options);
    EXPECT_THAT(uncounted_, testing::IsEmpty());
    lighting.setLights(makeEveryLight());
    const gl::Texture target = test::makeTarget(gl(), picture.size(), glm::vec4(0.0f));
    const gl::Texture other = test::makeTarget(gl(), picture.size(), glm::vec4(0.0f));
    const gl::Texture film = test::makeTarget(gl(), {32, 16}, glm::vec4(0.5f));
    Frames frames{lighting, {}, {}, film.name()};
    for (int i = 0; i < 5; ++i) {
        frames.lights.push_back(makeEveryLight(0.1f * static_cast<float>(i)));
        LightingFrame frame = (i == 3 ? small : picture).frame(i % 2 == 0 ? target : other);
        frame.composition = i % 3 == 0 ? Composition::add : Composition::replace;
        frame.camera.worldFromView[3][0] += 0.01 * i;
        frames.frames.push_back(frame);
    }
    frames.run(10);

    objectCalls = 0;
    heapCount = 0;
    isCounting = true;
    frames.run(100);
    isCounting = false;
    EXPECT_EQ(objectCalls, 0);
    EXPECT_EQ(heapCount, 0);

    // What is not steady is counted.
    isCounting = true;
    LightSet bent = makeEveryLight();
    bent.polygons[0].contours[0][0].x -= 1.0f;
    lighting.updatePolygons(0, bent.polygons);
    isCounting = false;
    EXPECT_GT(objectCalls, 0);
    EXPECT_GT(heapCount, 0);
}

/// Lists make no objects while the sizes stay below the largest, and use the heap for lights that
/// have changed alone.
void SteadyFrameTest::expectSteadyLists(const AreaLightingOptions& options) {
    const HostPicture picture(gl());
    const HostPicture small(gl(), {24, 16});
    const HostPicture large(gl(), {70, 50});
    if (!options.surfaceGlsl.empty()) test::bindForSnippet(gl(), picture);
    AreaLighting lighting(countingGetProcAddress(), options);
    lighting.setLightThreshold(test::kLightThreshold);
    lighting.setLights(test::makeManyLights());
    const gl::Texture target = test::makeTarget(gl(), large.size(), glm::vec4(0.0f));
    const gl::Texture film = test::makeTarget(gl(), {32, 16}, glm::vec4(0.5f));
    Frames frames{lighting, {}, {}, film.name()};
    for (int i = 0; i < 4; ++i) {
        LightingFrame frame = (i == 3 ? small : picture).frame(target);
        frame.composition = i % 3 == 0 ? Composition::add : Composition::replace;
        frame.camera.worldFromView[3][0] += 0.01 * i;
        frames.frames.push_back(frame);
    }
    frames.run(12);
    const auto count = [&](int frameCount) {
        objectCalls = 0;
        heapCount = 0;
        isCounting = true;
        frames.run(frameCount);
        isCounting = false;
    };
    count(50);
    EXPECT_EQ(objectCalls, 0);
    EXPECT_EQ(heapCount, 0);

    for (int i = 0; i < 3; ++i) {
        frames.lights.push_back(test::makeManyLights(0.1f * static_cast<float>(i)));
    }
    count(12);
    EXPECT_EQ(objectCalls, 0);
    EXPECT_GT(heapCount, 0);

    // More tiles than ever.
    frames.lights.clear();
    frames.frames = {large.frame(target)};
    if (!options.surfaceGlsl.empty()) test::bindForSnippet(gl(), large);
    count(1);
    EXPECT_GT(objectCalls, 0);
    count(2);
    EXPECT_EQ(objectCalls, 0);
    EXPECT_EQ(heapCount, 0);
}

TEST_P(SteadyFrameTest, withListsMakesNoObjects) {
    expectSteadyLists({});
}

TEST_P(SteadyFrameTest, ofTheComputeStageWithListsMakesNoObjects) {
    expectSteadyLists({.stage = LightingStage::compute});
}

TEST_P(SteadyFrameTest, withASnippetAndListsMakesNoObjects) {
    expectSteadyLists({.surfaceGlsl = test::kSameSurfaceGlsl});
}

TEST_P(SteadyFrameTest, ofTheFragmentStageAllocatesNothing) {
    expectSteady({});
}

TEST_P(SteadyFrameTest, ofTheComputeStageAllocatesNothing) {
    expectSteady({.stage = LightingStage::compute});
}

TEST_P(SteadyFrameTest, withASnippetAllocatesNothing) {
    expectSteady({.surfaceGlsl = test::kSameSurfaceGlsl});
}

POLYLUME_ON_EVERY_BACKEND(SteadyFrameTest);

}  // namespace
}  // namespace polylume
