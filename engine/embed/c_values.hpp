// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <cstring>

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::embed {

/// `pointer`, an argument or a field named `name`, unless it is null, which throws Error.
template <typename Type>
Type* required(Type* pointer, const char* name) {
    if (pointer == nullptr) throw Error(concat("expected \"", name, "\" not to be NULL"));
    return pointer;
}

/// The one of `values` that an enumeration of the C API, a field or argument named `name`, counts.
/// Throws Error where there is none.
template <typename Type, std::size_t count, typename Enum>
Type enumValue(const Type (&values)[count], const Enum& value, const char* name) {
    // Any integer may come from C, and C++ lets nobody read one through the enumeration that lacks
    // it.
    static_assert(sizeof(Enum) == sizeof(int));
    int number = 0;
    std::memcpy(&number, &value, sizeof(number));
    if (number < 0 || static_cast<std::size_t>(number) >= count) {
        throw Error(concat("expected \"", name, "\" to be from 0 to ", count - 1, ", found ",
                           number, ": see polylume.h for its values"));
    }
    return values[number];
}

}  // namespace polylume::embed
