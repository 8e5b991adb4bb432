// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/gltf_schema.hpp"

#include <climits>

namespace polylume::scene {
namespace {

using Kind = JsonKind;

constexpr double kAboveZero = DBL_MIN;

JsonProperty required(JsonProperty property) {
    property.required = true;
    return property;
}
JsonProperty text(const char* name) {
    return {.name = name, .kind = Kind::text};
}
JsonProperty boolean(const char* name) {
    return {.name = name, .kind = Kind::boolean};
}
JsonProperty number(const char* name, double minimum = -FLT_MAX, double maximum = FLT_MAX) {
    return {.name = name, .kind = Kind::number, .minimum = minimum, .maximum = maximum};
}
JsonProperty integer(const char* name, double maximum = INT_MAX) {
    return {.name = name, .kind = Kind::integer, .maximum = maximum};
}
JsonProperty numbers(const char* name, std::size_t length) {
    return {.name = name, .kind = Kind::numbers, .length = length};
}
JsonProperty contours(const char* name, std::size_t length) {
    return {.name = name, .kind = Kind::contours, .length = length};
}
JsonProperty index(const char* name, const char* target) {
    return {.name = name, .kind = Kind::index, .target = target};
}
JsonProperty indices(const char* name, const char* target) {
    return {.name = name, .kind = Kind::indices, .target = target};
}
JsonProperty object(const char* name, const JsonSchema& properties) {
    return {.name = name, .kind = Kind::object, .properties = &properties};
}
JsonProperty objects(const char* name, const JsonSchema& properties) {
    return {.name = name, .kind = Kind::objects, .properties = &properties};
}

JsonProperty closed(JsonProperty property) {
    property.closed = true;
    return property;
}

// Extensions that are there but carry nothing that we read.
const JsonSchema kEmpty;

const JsonSchema kAsset{required(text("version")), text("minVersion")};

const JsonSchema kBuffer{text("uri"), required(integer("byteLength", FLT_MAX)), text("name")};

const JsonSchema kBufferView{required(index("buffer", "/buffers")), integer("byteOffset", FLT_MAX),
                             required(integer("byteLength", FLT_MAX)), integer("byteStride", 252),
                             text("name")};

const JsonSchema kSparseIndices{required(index("bufferView", "/bufferViews")),
                                integer("byteOffset"), required(integer("componentType"))};
const JsonSchema kSparseValues{required(index("bufferView", "/bufferViews")),
                               integer("byteOffset")};
const JsonSchema kSparse{required(integer("count")), required(object("indices", kSparseIndices)),
                         required(object("values", kSparseValues))};
const JsonSchema kAccessor{index("bufferView", "/bufferViews"), integer("byteOffset", FLT_MAX),
                           required(integer("componentType")),  boolean("normalized"),
                           required(integer("count")),          required(text("type")),
                           object("sparse", kSparse),           text("name")};

const JsonSchema kPrimitive{
    required({.name = "attributes", .kind = Kind::indexMap, .target = "/accessors"}),
    index("indices", "/accessors"),
    index("material", "/materials"),
    integer("mode", 6),
    {.name = "targets", .kind = Kind::indexMaps, .target = "/accessors"}};
const JsonSchema kMesh{required(objects("primitives", kPrimitive)), numbers("weights", 0),
                       text("name")};

const JsonSchema kSkin{index("inverseBindMatrices", "/accessors"),
                       required(indices("joints", "/nodes")), index("skeleton", "/nodes"),
                       text("name")};

const JsonSchema kPerspective{number("aspectRatio", kAboveZero),
                              required(number("yfov", kAboveZero, 3.14159)),
                              number("zfar", kAboveZero), required(number("znear", kAboveZero))};
const JsonSchema kOrthographic{required(number("xmag")), required(number("ymag")),
                               required(number("zfar", kAboveZero)), required(number("znear"))};
const JsonSchema kCamera{required(text("type")), object("perspective", kPerspective),
                         object("orthographic", kOrthographic), text("name")};

const JsonSchema kNodeAreaLight{required(index("light", "/extensions/EXT_lights_area/lights"))};
const JsonSchema kNodePunctualLight{
    required(index("light", "/extensions/KHR_lights_punctual/lights"))};
const JsonSchema kNodePolylumeLight{
    required(index("light", "/extensions/POLYLUME_lights_area/lights"))};
const JsonSchema kNodeExtensions{object("EXT_lights_area", kNodeAreaLight),
                                 closed(object("POLYLUME_lights_area", kNodePolylumeLight)),
                                 object("KHR_lights_punctual", kNodePunctualLight)};
const JsonSchema kNode{index("camera", "/cameras"),
                       indices("children", "/nodes"),
                       index("skin", "/skins"),
                       numbers("matrix", 16),
                       index("mesh", "/meshes"),
                       numbers("rotation", 4),
                       numbers("scale", 3),
                       numbers("translation", 3),
                       numbers("weights", 0),
                       text("name"),
                       object("extensions", kNodeExtensions)};

const JsonSchema kScene{indices("nodes", "/nodes"), text("name")};

const JsonSchema kImage{text("uri"), text("mimeType"), index("bufferView", "/bufferViews"),
                        text("name")};
const JsonSchema kSampler{integer("magFilter"), integer("minFilter"), integer("wrapS"),
                          integer("wrapT")};
const JsonSchema kTexture{index("sampler", "/samplers"), index("source", "/images"), text("name")};

const JsonSchema kTextureTransform{numbers("offset", 2), number("rotation"), numbers("scale", 2),
                                   integer("texCoord")};
const JsonSchema kTextureExtensions{object("KHR_texture_transform", kTextureTransform)};
const JsonSchema kTextureInfo{required(index("index", "/textures")), integer("texCoord"),
                              number("scale"), number("strength"),
                              object("extensions", kTextureExtensions)};

const JsonSchema kEmissiveStrength{number("emissiveStrength", 0.0)};
const JsonSchema kSpecular{number("specularFactor"), object("specularTexture", kTextureInfo),
                           numbers("specularColorFactor", 3),
                           object("specularColorTexture", kTextureInfo)};
const JsonSchema kSheen{numbers("sheenColorFactor", 3), object("sheenColorTexture", kTextureInfo),
                        number("sheenRoughnessFactor"),
                        object("sheenRoughnessTexture", kTextureInfo)};
const JsonSchema kIor{number("ior")};
const JsonSchema kMaterialExtensions{
    object("KHR_materials_emissive_strength", kEmissiveStrength),
    object("KHR_materials_specular", kSpecular), object("KHR_materials_ior", kIor),
    object("KHR_materials_sheen", kSheen), object("KHR_materials_unlit", kEmpty)};
const JsonSchema kMetallicRoughness{numbers("baseColorFactor", 4),
                                    object("baseColorTexture", kTextureInfo),
                                    number("metallicFactor"), number("roughnessFactor"),
                                    object("metallicRoughnessTexture", kTextureInfo)};
const JsonSchema kMaterial{text("name"),
                           object("pbrMetallicRoughness", kMetallicRoughness),
                           object("normalTexture", kTextureInfo),
                           object("occlusionTexture", kTextureInfo),
                           object("emissiveTexture", kTextureInfo),
                           numbers("emissiveFactor", 3),
                           text("alphaMode"),
                           number("alphaCutoff"),
                           boolean("doubleSided"),
                           object("extensions", kMaterialExtensions)};

const JsonSchema kAreaRect{number("aspect", kAboveZero)};
const JsonSchema kAreaLight{text("name"),
                            numbers("color", 3),
                            number("intensity", 0.0),
                            text("type"),
                            number("size", kAboveZero),
                            object("rect", kAreaRect),
                            {.name = "shape", .kind = Kind::presence},
                            {.name = "luminance", .kind = Kind::presence},
                            {.name = "width", .kind = Kind::presence},
                            {.name = "height", .kind = Kind::presence},
                            {.name = "radius", .kind = Kind::presence}};
const JsonSchema kAreaLights{required(objects("lights", kAreaLight))};

const JsonSchema kPolylumeRectangle{number("width", kAboveZero), number("height", kAboveZero)};
const JsonSchema kPolylumePolygon{required(contours("contours", 3)), contours("texCoords", 2)};
const JsonSchema kPolylumeSphere{number("radius", kAboveZero)};
const JsonSchema kPolylumeTube{number("length", 0.0), number("radius", kAboveZero)};
const JsonSchema kPolylumeTexture{index("index", "/textures"), text("uri")};
const JsonSchema kPolylumeLight{
    text("name"),
    {.name = "color", .kind = Kind::numbers, .length = 3, .minimum = 0.0},
    number("intensity", 0.0),
    required(text("type")),
    boolean("twoSided"),
    boolean("shownBySurface"),
    closed(object("texture", kPolylumeTexture)),
    closed(object("rect", kPolylumeRectangle)),
    closed(object("polygon", kPolylumePolygon)),
    closed(object("ellipse", kPolylumeRectangle)),
    closed(object("sphere", kPolylumeSphere)),
    closed(object("tube", kPolylumeTube))};
const JsonSchema kPolylumeLights{required(closed(objects("lights", kPolylumeLight)))};

const JsonSchema kSpot{number("innerConeAngle"), number("outerConeAngle")};
const JsonSchema kPunctualLight{
    text("name"),           numbers("color", 3),         number("intensity", 0.0),
    required(text("type")), number("range", kAboveZero), object("spot", kSpot)};
const JsonSchema kPunctualLights{required(objects("lights", kPunctualLight))};
const JsonSchema kRootExtensions{object("EXT_lights_area", kAreaLights),
                                 closed(object("POLYLUME_lights_area", kPolylumeLights)),
                                 object("KHR_lights_punctual", kPunctualLights)};

const JsonSchema kRoot{required(object("asset", kAsset)),
                       {.name = "extensionsUsed", .kind = Kind::texts},
                       {.name = "extensionsRequired", .kind = Kind::texts},
                       index("scene", "/scenes"),
                       objects("accessors", kAccessor),
                       objects("buffers", kBuffer),
                       objects("bufferViews", kBufferView),
                       objects("cameras", kCamera),
                       objects("images", kImage),
                       objects("materials", kMaterial),
                       objects("meshes", kMesh),
                       objects("nodes", kNode),
                       objects("samplers", kSampler),
                       objects("scenes", kScene),
                       objects("skins", kSkin),
                       objects("textures", kTexture),
                       object("extensions", kRootExtensions)};

}  // namespace

const JsonSchema& gltfSchema() {
    return kRoot;
}

}  // namespace polylume::scene
