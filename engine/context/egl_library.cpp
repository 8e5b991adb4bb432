// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "context/egl_library.hpp"

#include <iterator>

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::context {
namespace {

/// Whether the list of names parted by spaces holds `name`.
bool listHolds(const char* list, std::string_view name) {
    if (list == nullptr) return false;
    const std::string padded = concat(' ', list, ' ');
    return padded.find(concat(' ', name, ' ')) != std::string::npos;
}

/// EGL 1.5, section 3.1.
constexpr std::pair<EGLint, const char*> kErrorNames[] = {
    {EGL_SUCCESS, "no EGL error"},
    {EGL_NOT_INITIALIZED, "EGL_NOT_INITIALIZED"},
    {EGL_BAD_ACCESS, "EGL_BAD_ACCESS"},
    {EGL_BAD_ALLOC, "EGL_BAD_ALLOC"},
    {EGL_BAD_ATTRIBUTE, "EGL_BAD_ATTRIBUTE"},
    {EGL_BAD_CONFIG, "EGL_BAD_CONFIG"},
    {EGL_BAD_CONTEXT, "EGL_BAD_CONTEXT"},
    {EGL_BAD_CURRENT_SURFACE, "EGL_BAD_CURRENT_SURFACE"},
    {EGL_BAD_DISPLAY, "EGL_BAD_DISPLAY"},
    {EGL_BAD_MATCH, "EGL_BAD_MATCH"},
    {EGL_BAD_PARAMETER, "EGL_BAD_PARAMETER"},
    {EGL_BAD_SURFACE, "EGL_BAD_SURFACE"},
    {EGL_CONTEXT_LOST, "EGL_CONTEXT_LOST"},
};

}  // namespace

const EglLibrary& EglLibrary::get() {
    // Left alone at the end of the program, like the library itself.
    static const EglLibrary* library = new EglLibrary();
    return *library;
}

EglLibrary::EglLibrary() : library_({"libEGL.so.1"}) {
    library_.fetch("eglBindAPI", bindApi);
    library_.fetch("eglChooseConfig", chooseConfig);
    library_.fetch("eglCreateContext", createContext);
    library_.fetch("eglCreatePbufferSurface", createPbufferSurface);
    library_.fetch("eglDestroyContext", destroyContext);
    library_.fetch("eglDestroySurface", destroySurface);
    library_.fetch("eglGetError", getError_);
    library_.fetch("eglGetProcAddress", getProcAddress);
    library_.fetch("eglInitialize", initialize_);
    library_.fetch("eglMakeCurrent", makeCurrent);
    library_.fetch("eglQueryString", queryString_);

    // eglGetProcAddress may give an address for what is not there, so the extensions decide.
    const auto fetchExtension = [&](const char* name, auto& function) {
        function = reinterpret_cast<std::decay_t<decltype(function)>>(getProcAddress(name));
    };
    if (hasExtension(EGL_NO_DISPLAY, "EGL_EXT_platform_base")) {
        fetchExtension("eglGetPlatformDisplayEXT", getPlatformDisplay_);
    }
    const bool hasDevices = hasExtension(EGL_NO_DISPLAY, "EGL_EXT_device_base");
    if (hasDevices || hasExtension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration")) {
        fetchExtension("eglQueryDevicesEXT", queryDevices_);
    }
    if (hasDevices || hasExtension(EGL_NO_DISPLAY, "EGL_EXT_device_query")) {
        fetchExtension("eglQueryDeviceStringEXT", queryDeviceString_);
    }
}

bool EglLibrary::hasExtension(EGLDisplay display, std::string_view name) const {
    return listHolds(queryString_(display, EGL_EXTENSIONS), name);
}

void EglLibrary::appendDevices(std::vector<Place>& places) const {
    EGLint count = 0;
    if (queryDevices_(0, nullptr, &count) != EGL_TRUE || count <= 0) return;
    std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
    if (queryDevices_(count, devices.data(), &count) != EGL_TRUE) return;

    std::vector<Place> software;
    for (EGLint index = 0; index < count; ++index) {
        EGLDeviceEXT device = devices[static_cast<std::size_t>(index)];
        const bool isSoftware =
            queryDeviceString_ != nullptr &&
            listHolds(queryDeviceString_(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
        const std::string name =
            concat("EGL device ", index, isSoftware ? " (software)" : " (hardware)");
        (isSoftware ? software : places).push_back({name, EGL_PLATFORM_DEVICE_EXT, device});
    }
    places.insert(places.end(), std::make_move_iterator(software.begin()),
                  std::make_move_iterator(software.end()));
}

std::vector<EglLibrary::Place> EglLibrary::places() const {
    std::vector<Place> places;
    if (getPlatformDisplay_ == nullptr) return places;
    if (queryDevices_ != nullptr && hasExtension(EGL_NO_DISPLAY, "EGL_EXT_platform_device")) {
        appendDevices(places);
    }
    if (hasExtension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
        places.push_back({"EGL surfaceless", EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY});
    }
    return places;
}

EGLDisplay EglLibrary::openDisplay(const Place& place) const {
    // A place always gives the same display, and to initialise it once more does nothing.
    EGLDisplay display = getPlatformDisplay_(place.platform, place.nativeDisplay, nullptr);
    if (display == EGL_NO_DISPLAY) throw ContextError(describeFailure("eglGetPlatformDisplayEXT"));
    EGLint major = 0;
    EGLint minor = 0;
    if (initialize_(display, &major, &minor) != EGL_TRUE) {
        throw ContextError(describeFailure("eglInitialize"));
    }
    if (major == 1 && minor < 5 && !hasExtension(display, "EGL_KHR_create_context")) {
        throw ContextError(
            concat("expected EGL 1.5 or EGL_KHR_create_context, found EGL ", major, ".", minor));
    }
    return display;
}

std::string EglLibrary::describeFailure(std::string_view action) const {
    const EGLint error = getError_();
    for (const auto& [value, name] : kErrorNames) {
        if (value == error) return concat(action, ": ", name);
    }
    return concat(action, ": EGL error 0x", std::hex, error);
}

}  // namespace polylume::context
