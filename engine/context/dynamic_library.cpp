// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "context/dynamic_library.hpp"

#include <dlfcn.h>

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::context {

DynamicLibrary::DynamicLibrary(std::initializer_list<const char*> names) {
    std::string reason;
    for (const char* name : names) {
        handle_ = ::dlopen(name, RTLD_NOW | RTLD_LOCAL);
        if (handle_ != nullptr) {
            name_ = name;
            return;
        }
        if (reason.empty()) reason = ::dlerror();
    }
    throw Error(reason);
}

void* DynamicLibrary::symbol(const char* name) const {
    void* found = ::dlsym(handle_, name);
    if (found == nullptr) throw Error(concat(name_, " has no ", name));
    return found;
}

}  // namespace polylume::context
