// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "context/context_way.hpp"

#include "context/egl_context.hpp"
#include "context/egl_library.hpp"
#include "context/osmesa_context.hpp"
#include "polylume/error.hpp"

namespace polylume::context {
namespace {

ContextWay closedWay(std::string name, std::string reason) {
    return {std::move(name), [reason = std::move(reason)]() -> std::unique_ptr<ThreadContext> {
                throw ContextError(reason);
            }};
}

void appendEglWays(std::vector<ContextWay>& ways) {
    std::vector<EglLibrary::Place> places;
    try {
        places = EglLibrary::get().places();
    } catch (const Error& error) {
        ways.push_back(closedWay("EGL", error.what()));
        return;
    }
    if (places.empty()) {
        ways.push_back(closedWay("EGL",
                                 "this libEGL has neither a device nor the surfaceless platform; "
                                 "does it lack a driver?"));
    }
    for (EglLibrary::Place& place : places) {
        ways.push_back({place.name, [place] { return std::make_unique<EglContext>(place); }});
    }
}

}  // namespace

std::vector<ContextWay> contextWays(Backend backend) {
    std::vector<ContextWay> ways;
    if (backend != Backend::osmesa) appendEglWays(ways);
    if (backend != Backend::egl) {
        ways.push_back({OsmesaContext::kName, [] { return std::make_unique<OsmesaContext>(); }});
    }
    return ways;
}

std::string installHint(Backend backend) {
    constexpr const char* kEglPackages = "libegl1 libegl-mesa0 libgl1-mesa-dri";
    constexpr const char* kOsmesaPackages = "libosmesa6";
    std::string hint = "Install a driver, on Debian by: apt-get install ";
    if (backend != Backend::osmesa) hint += kEglPackages;
    if (backend == Backend::automatic) hint += ", or ";
    if (backend != Backend::egl) hint += kOsmesaPackages;
    return hint;
}

}  // namespace polylume::context
