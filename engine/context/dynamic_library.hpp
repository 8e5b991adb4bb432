// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <initializer_list>
#include <string>

namespace polylume::context {

/// A shared library opened at run time, its symbols kept from other libraries. Never closed:
/// drivers leave threads and exit handlers behind, which must find their code.
class DynamicLibrary {
  public:
    /// Opens the first of `names` that opens. Throws Error with the reason of the first otherwise.
    explicit DynamicLibrary(std::initializer_list<const char*> names);

    /// Sets `function` to the symbol `name`. Throws Error when the library has none.
    template <typename Function>
    void fetch(const char* name, Function& function) const {
        function = reinterpret_cast<Function>(symbol(name));
    }

  private:
    void* symbol(const char* name) const;

    void* handle_ = nullptr;
    std::string name_;
};

}  // namespace polylume::context
