// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glad/egl.h>

#include <string>
#include <string_view>
#include <vector>

#include "context/dynamic_library.hpp"

namespace polylume::context {

/// libEGL.so.1 with the functions that we call.
class EglLibrary {
  public:
    /// A place where EGL can make contexts.
    struct Place {
        std::string name;      ///< "EGL device 0 (hardware)", "EGL surfaceless"
        EGLenum platform = 0;  ///< EGL_PLATFORM_...
        void* nativeDisplay = nullptr;
    };

    /// The library, opened at the first call and kept. Throws Error where there is none.
    static const EglLibrary& get();

    /// The hardware devices, then the software devices, then the surfaceless platform, as far as
    /// this libEGL knows them. May be empty.
    std::vector<Place> places() const;

    /// Opens the display of a place. Never to be closed: a place has one display, which all its
    /// contexts share. Throws ContextError.
    EGLDisplay openDisplay(const Place& place) const;

    /// Whether the display, or the library itself for EGL_NO_DISPLAY, has an extension.
    bool hasExtension(EGLDisplay display, std::string_view name) const;

    /// "action: name of EGL's last error".
    std::string describeFailure(std::string_view action) const;

    PFNEGLBINDAPIPROC bindApi = nullptr;
    PFNEGLCHOOSECONFIGPROC chooseConfig = nullptr;
    PFNEGLCREATECONTEXTPROC createContext = nullptr;
    PFNEGLCREATEPBUFFERSURFACEPROC createPbufferSurface = nullptr;
    PFNEGLDESTROYCONTEXTPROC destroyContext = nullptr;
    PFNEGLDESTROYSURFACEPROC destroySurface = nullptr;
    PFNEGLGETPROCADDRESSPROC getProcAddress = nullptr;
    PFNEGLMAKECURRENTPROC makeCurrent = nullptr;

  private:
    EglLibrary();

    void appendDevices(std::vector<Place>& places) const;

    DynamicLibrary library_;
    PFNEGLGETERRORPROC getError_ = nullptr;
    PFNEGLINITIALIZEPROC initialize_ = nullptr;
    PFNEGLQUERYSTRINGPROC queryString_ = nullptr;
    // Of extensions: null where the library lacks them.
    PFNEGLGETPLATFORMDISPLAYEXTPROC getPlatformDisplay_ = nullptr;
    PFNEGLQUERYDEVICESEXTPROC queryDevices_ = nullptr;
    PFNEGLQUERYDEVICESTRINGEXTPROC queryDeviceString_ = nullptr;
};

}  // namespace polylume::context
