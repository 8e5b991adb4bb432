// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cfloat>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

// A small, table-driven check of JSON objects. tinygltf takes what it can and keeps silent about
// the rest; after this check it sees only properties of the right type, range and length, and
// indices that lead somewhere.
namespace polylume::scene {

enum class JsonKind {
    text,
    boolean,
    number,    ///< Within [minimum, maximum].
    integer,   ///< Whole, 0 to `maximum`.
    numbers,   ///< Array of numbers; of `length` where that is not 0.
    index,     ///< Into the array at the JSON pointer `target`.
    indices,   ///< Array of such.
    indexMap,  ///< Object whose every value is such.
    indexMaps,
    texts,
    object,    ///< Of `properties`.
    objects,   ///< Array of such.
    contours,  ///< Array of one or more arrays of three or more vertices of `length` numbers.
    presence   ///< Anything; only that it is there is kept, as true.
};

/// One property of an object and what it has to be.
struct JsonProperty {
    const char* name;
    JsonKind kind;
    bool required = false;
    const char* target = nullptr;
    const std::vector<JsonProperty>* properties = nullptr;
    std::size_t length = 0;
    double minimum = -FLT_MAX;
    double maximum = FLT_MAX;
    bool closed = false;  ///< Objects: a property that `properties` does not name is an error, but
                          ///< for "extensions" and "extras".
};

using JsonSchema = std::vector<JsonProperty>;

/// A copy of `root` that holds only the properties named in `schema`, numbers as floating point and
/// indices as integers. Throws Error that says what was expected, what was found, and where in
/// `fileName`.
nlohmann::json checkJson(const nlohmann::json& root, const JsonSchema& schema,
                         const std::string& fileName);

}  // namespace polylume::scene
