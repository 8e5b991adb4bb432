// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/json_checker.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::scene {
namespace {

using nlohmann::json;

/// `value` as it is quoted in a message: short, and valid UTF-8 whatever it was.
std::string describe(const json& value) {
    if (value.is_object()) return "an object";
    if (value.is_array()) return concat("an array of ", value.size());
    std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
    if (text.size() > 60) text = text.substr(0, 60) + "...";
    return text;
}

/// Where a message points to: the file and the path from the document's root.
class Place {
  public:
    explicit Place(const std::string& fileName) : fileName_(fileName) {}

    Place property(const std::string& name) const {
        Place place = *this;
        // Extension names are unmistakable, so "extensions." would only be noise.
        if (name != "extensions") place.path_ += place.path_.empty() ? name : "." + name;
        return place;
    }
    Place element(std::size_t index) const {
        Place place = *this;
        place.path_ += concat("[", index, "]");
        return place;
    }
    /// With a name that the user knows the object by.
    Place named(const std::string& name) const {
        Place place = *this;
        place.path_ += concat(" \"", name.substr(0, 60), "\"");
        return place;
    }
    std::string text() const {
        return path_.empty() ? concat("(", fileName_, ")")
                             : concat("(", fileName_, ": ", path_, ")");
    }

  private:
    const std::string& fileName_;
    std::string path_;
};

class Checker {
  public:
    explicit Checker(const json& root) : root_(root) {}

    json object(const json& value, const JsonSchema& schema, const Place& place,
                bool closed = false) const {
        if (!value.is_object()) {
            throw Error(concat("expected an object, found ", describe(value), " ", place.text()));
        }
        if (closed) checkClosed(value, schema, place);
        json checked = json::object();
        for (const JsonProperty& property : schema) {
            const auto found = value.find(property.name);
            if (found == value.end()) {
                if (!property.required) continue;
                throw Error(
                    concat("expected \"", property.name, "\", which is missing ", place.text()));
            }
            checked[property.name] = this->property(*found, property, place);
        }
        // tinygltf drops empty objects of extensions from their arrays, which would shift the
        // others.
        if (checked.empty()) checked["empty"] = true;
        return checked;
    }

  private:
    static void checkClosed(const json& value, const JsonSchema& schema, const Place& place) {
        for (const auto& [name, element] : value.items()) {
            if (name == "extensions" || name == "extras") continue;
            const auto isIt = [&name = name](const JsonProperty& known) {
                return name == known.name;
            };
            if (std::ranges::any_of(schema, isIt)) continue;
            std::string known;
            for (const JsonProperty& property : schema) {
                known += concat(known.empty() ? "" : ", ", "\"", property.name, "\"");
            }
            throw Error(
                concat("expected only ", known, ", found ", describe(name), " ", place.text()));
        }
    }

    [[noreturn]] static void fail(const JsonProperty& property, const std::string& expected,
                                  const json& found, const Place& place) {
        throw Error(concat("expected \"", property.name, "\" to be ", expected, ", found ",
                           describe(found), " ", place.text()));
    }

    json property(const json& value, const JsonProperty& property, const Place& place) const {
        switch (property.kind) {
            case JsonKind::text:
                if (!value.is_string()) fail(property, "a string", value, place);
                return value;
            case JsonKind::boolean:
                if (!value.is_boolean()) fail(property, "true or false", value, place);
                return value;
            case JsonKind::number:
                return number(value, property, place);
            case JsonKind::integer:
                return integer(value, property, place);
            case JsonKind::index:
                return index(value, property, place);
            case JsonKind::indexMap:
                return indexMap(value, property, place);
            case JsonKind::object:
                return object(value, *property.properties, place.property(property.name),
                              property.closed);
            case JsonKind::contours:
                return contours(value, property, place);
            case JsonKind::presence:
                return true;
            case JsonKind::texts:
            case JsonKind::numbers:
            case JsonKind::indices:
            case JsonKind::indexMaps:
            case JsonKind::objects:
                return array(value, property, place);
        }
        return {};
    }

    static json number(const json& value, const JsonProperty& property, const Place& place) {
        if (!value.is_number()) fail(property, "a number", value, place);
        const double number = value.get<double>();
        // Everything ends as float; what does not fit would become infinite.
        if (!(std::abs(number) <= FLT_MAX)) {
            fail(property, "a number that fits single precision", value, place);
        }
        if (number < property.minimum || number > property.maximum) {
            fail(property, range(property), value, place);
        }
        return number;
    }

    static std::string range(const JsonProperty& property) {
        if (property.maximum == FLT_MAX && property.minimum > 0.0) return "above 0";
        if (property.maximum == FLT_MAX) return concat("at least ", property.minimum);
        return concat("from ", property.minimum, " to ", property.maximum);
    }

    static json integer(const json& value, const JsonProperty& property, const Place& place) {
        // Some writers say 3.0 where they mean 3.
        const double number = value.is_number() ? value.get<double>() : -1.0;
        constexpr double kLargestExact = 9007199254740992.0;  // 2^53
        const double maximum = std::min(property.maximum, kLargestExact);
        if (!(number >= std::max(0.0, property.minimum) && number <= maximum) ||
            number != std::floor(number)) {
            const std::string expected =
                maximum == kLargestExact
                    ? concat("a whole number, ", std::max(0.0, property.minimum), " or more")
                    : concat("a whole number up to ", maximum);
            fail(property, expected, value, place);
        }
        return static_cast<std::int64_t>(number);
    }

    json index(const json& value, const JsonProperty& property, const Place& place) const {
        if (!value.is_number()) fail(property, "an index", value, place);
        const json::json_pointer target(property.target);
        const json* array = root_.contains(target) ? &root_.at(target) : nullptr;
        const std::size_t count = array && array->is_array() ? array->size() : 0;
        const double number = value.get<double>();
        if (number != std::floor(number)) fail(property, "a whole number", value, place);
        if (number < 0.0) fail(property, "0 or more", value, place);
        if (!(number < static_cast<double>(count))) {
            const std::string limit =
                count > 0 ? concat("below ", count)
                          : concat("left out, since there is no \"", target.back(), "\"");
            throw Error(concat("expected \"", property.name, "\" ", limit, ", found ",
                               describe(value), " ", place.text()));
        }
        return static_cast<std::int64_t>(number);
    }

    json indexMap(const json& value, const JsonProperty& property, const Place& place) const {
        if (!value.is_object()) fail(property, "an object", value, place);
        json checked = json::object();
        for (const auto& [name, element] : value.items()) {
            const JsonProperty entry{
                .name = name.c_str(), .kind = JsonKind::index, .target = property.target};
            checked[name] = index(element, entry, place.property(property.name));
        }
        return checked;
    }

    json array(const json& value, const JsonProperty& property, const Place& place) const {
        if (!value.is_array()) fail(property, "an array", value, place);
        if (property.length != 0 && value.size() != property.length) {
            fail(property, concat("an array of ", property.length), value, place);
        }
        json checked = json::array();
        for (std::size_t i = 0; i < value.size(); ++i) {
            checked.push_back(element(value[i], i, property, place));
        }
        return checked;
    }

    json element(const json& value, std::size_t i, const JsonProperty& property,
                 const Place& place) const {
        const Place here = place.property(property.name).element(i);
        const std::string elementName = concat(property.name, "[", i, "]");
        JsonProperty single = property;
        single.name = elementName.c_str();
        switch (property.kind) {
            case JsonKind::texts:
                if (!value.is_string()) fail(single, "a string", value, place);
                return value;
            case JsonKind::numbers:
                return number(value, single, place);
            case JsonKind::indices:
                return index(value, single, place);
            case JsonKind::indexMaps:
                return indexMap(value, single, place);
            default: {
                const auto name = value.find("name");
                const bool isNamed = property.closed && value.is_object() && name != value.end() &&
                                     name->is_string();
                return object(value, *property.properties,
                              isNamed ? here.named(name->get<std::string>()) : here,
                              property.closed);
            }
        }
    }

    static json contours(const json& value, const JsonProperty& property, const Place& place) {
        if (!value.is_array() || value.empty()) {
            fail(property, "an array of one contour or more", value, place);
        }
        json checked = json::array();
        for (std::size_t c = 0; c < value.size(); ++c) {
            checked.push_back(
                contour(value[c], concat(property.name, "[", c, "]"), property, place));
        }
        return checked;
    }

    static json contour(const json& value, const std::string& name, const JsonProperty& property,
                        const Place& place) {
        JsonProperty single = property;
        single.name = name.c_str();
        if (!value.is_array() || value.size() < 3) {
            fail(single, "an array of three vertices or more", value, place);
        }
        json checked = json::array();
        for (std::size_t i = 0; i < value.size(); ++i) {
            const std::string vertexName = concat(name, "[", i, "]");
            single.name = vertexName.c_str();
            if (!value[i].is_array() || value[i].size() != property.length) {
                fail(single, concat("an array of ", property.length), value[i], place);
            }
            json vertex = json::array();
            for (const json& coordinate : value[i]) {
                vertex.push_back(number(coordinate, single, place));
            }
            checked.push_back(std::move(vertex));
        }
        return checked;
    }

    const json& root_;
};

}  // namespace

json checkJson(const json& root, const JsonSchema& schema, const std::string& fileName) {
    return Checker(root).object(root, schema, Place(fileName));
}

}  // namespace polylume::scene
