// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "host_state.hpp"

#include <array>
#include <sstream>

#include "core/text.hpp"
#include "gl/objects.hpp"

namespace polylume::test {
namespace {

#define POLYLUME_NAMED(name) \
    Named {                  \
#name, name          \
    }

struct Named {
    const char* name;
    GLenum value;
};

constexpr Named kCapabilities[] = {
    POLYLUME_NAMED(GL_COLOR_LOGIC_OP),
    POLYLUME_NAMED(GL_CULL_FACE),
    POLYLUME_NAMED(GL_DEBUG_OUTPUT),
    POLYLUME_NAMED(GL_DEBUG_OUTPUT_SYNCHRONOUS),
    POLYLUME_NAMED(GL_DEPTH_CLAMP),
    POLYLUME_NAMED(GL_DEPTH_TEST),
    POLYLUME_NAMED(GL_DITHER),
    POLYLUME_NAMED(GL_FRAMEBUFFER_SRGB),
    POLYLUME_NAMED(GL_LINE_SMOOTH),
    POLYLUME_NAMED(GL_MULTISAMPLE),
    POLYLUME_NAMED(GL_POLYGON_OFFSET_FILL),
    POLYLUME_NAMED(GL_POLYGON_OFFSET_LINE),
    POLYLUME_NAMED(GL_POLYGON_OFFSET_POINT),
    POLYLUME_NAMED(GL_POLYGON_SMOOTH),
    POLYLUME_NAMED(GL_PRIMITIVE_RESTART),
    POLYLUME_NAMED(GL_PRIMITIVE_RESTART_FIXED_INDEX),
    POLYLUME_NAMED(GL_PROGRAM_POINT_SIZE),
    POLYLUME_NAMED(GL_RASTERIZER_DISCARD),
    POLYLUME_NAMED(GL_SAMPLE_ALPHA_TO_COVERAGE),
    POLYLUME_NAMED(GL_SAMPLE_ALPHA_TO_ONE),
    POLYLUME_NAMED(GL_SAMPLE_COVERAGE),
    POLYLUME_NAMED(GL_SAMPLE_MASK),
    POLYLUME_NAMED(GL_SAMPLE_SHADING),
    POLYLUME_NAMED(GL_STENCIL_TEST),
    POLYLUME_NAMED(GL_TEXTURE_CUBE_MAP_SEAMLESS),
    POLYLUME_NAMED(GL_CLIP_DISTANCE0),
    POLYLUME_NAMED(GL_CLIP_DISTANCE1),
    POLYLUME_NAMED(GL_CLIP_DISTANCE2),
    POLYLUME_NAMED(GL_CLIP_DISTANCE3),
    POLYLUME_NAMED(GL_CLIP_DISTANCE4),
    POLYLUME_NAMED(GL_CLIP_DISTANCE5),
    POLYLUME_NAMED(GL_CLIP_DISTANCE6),
    POLYLUME_NAMED(GL_CLIP_DISTANCE7),
};

struct Values {
    const char* name;
    GLenum value;
    int count = 1;
};

#define POLYLUME_VALUES(name, count) \
    Values {                         \
#name, name, count           \
    }

constexpr Values kFloats[] = {
    POLYLUME_VALUES(GL_BLEND_COLOR, 4),          POLYLUME_VALUES(GL_COLOR_CLEAR_VALUE, 4),
    POLYLUME_VALUES(GL_DEPTH_CLEAR_VALUE, 1),    POLYLUME_VALUES(GL_DEPTH_RANGE, 2),
    POLYLUME_VALUES(GL_LINE_WIDTH, 1),           POLYLUME_VALUES(GL_MIN_SAMPLE_SHADING_VALUE, 1),
    POLYLUME_VALUES(GL_POINT_SIZE, 1),           POLYLUME_VALUES(GL_POLYGON_OFFSET_FACTOR, 1),
    POLYLUME_VALUES(GL_POLYGON_OFFSET_UNITS, 1), POLYLUME_VALUES(GL_SAMPLE_COVERAGE_VALUE, 1),
};

constexpr Values kIntegers[] = {
    POLYLUME_VALUES(GL_ACTIVE_TEXTURE, 1),
    POLYLUME_VALUES(GL_ARRAY_BUFFER_BINDING, 1),
    POLYLUME_VALUES(GL_ATOMIC_COUNTER_BUFFER_BINDING, 1),
    POLYLUME_VALUES(GL_CLIP_DEPTH_MODE, 1),
    POLYLUME_VALUES(GL_CLIP_ORIGIN, 1),
    POLYLUME_VALUES(GL_COPY_READ_BUFFER_BINDING, 1),
    POLYLUME_VALUES(GL_COPY_WRITE_BUFFER_BINDING, 1),
    POLYLUME_VALUES(GL_CULL_FACE_MODE, 1),
    POLYLUME_VALUES(GL_CURRENT_PROGRAM, 1),
    POLYLUME_VALUES(GL_DEPTH_FUNC, 1),
    POLYLUME_VALUES(GL_DEPTH_WRITEMASK, 1),
    POLYLUME_VALUES(GL_DISPATCH_INDIRECT_BUFFER_BINDING, 1),
    POLYLUME_VALUES(GL_DRAW_BUFFER, 1),
    POLYLUME_VALUES(GL_DRAW_FRAMEBUFFER_BINDING, 1),
    POLYLUME_VALUES(GL_DRAW_INDIRECT_BUFFER_BINDING, 1),
    POLYLUME_VALUES(GL_ELEMENT_ARRAY_BUFFER_BINDING, 1),
    POLYLUME_VALUES(GL_FRAGMENT_SHADER_DERIVATIVE_HINT, 1),
    POLYLUME_VALUES(GL_FRONT_FACE, 1),
    POLYLUME_VALUES(GL_LOGIC_OP_MODE, 1),
    POLYLUME_VALUES(GL_PACK_ALIGNMENT, 1),
    POLYLUME_VALUES(GL_PACK_ROW_LENGTH, 1),
    POLYLUME_VALUES(GL_PACK_SKIP_ROWS, 1),
    POLYLUME_VALUES(GL_PATCH_VERTICES, 1),
    POLYLUME_VALUES(GL_PIXEL_PACK_BUFFER_BINDING, 1),
    POLYLUME_VALUES(GL_PIXEL_UNPACK_BUFFER_BINDING, 1),
    POLYLUME_VALUES(GL_POLYGON_MODE, 1),
    POLYLUME_VALUES(GL_PRIMITIVE_RESTART_INDEX, 1),
    POLYLUME_VALUES(GL_PROGRAM_PIPELINE_BINDING, 1),
    POLYLUME_VALUES(GL_PROVOKING_VERTEX, 1),
    POLYLUME_VALUES(GL_QUERY_BUFFER_BINDING, 1),
    POLYLUME_VALUES(GL_READ_BUFFER, 1),
    POLYLUME_VALUES(GL_READ_FRAMEBUFFER_BINDING, 1),
    POLYLUME_VALUES(GL_RENDERBUFFER_BINDING, 1),
    POLYLUME_VALUES(GL_SAMPLE_COVERAGE_INVERT, 1),
    POLYLUME_VALUES(GL_SHADER_STORAGE_BUFFER_BINDING, 1),
    POLYLUME_VALUES(GL_STENCIL_BACK_FAIL, 1),
    POLYLUME_VALUES(GL_STENCIL_BACK_FUNC, 1),
    POLYLUME_VALUES(GL_STENCIL_BACK_WRITEMASK, 1),
    POLYLUME_VALUES(GL_STENCIL_CLEAR_VALUE, 1),
    POLYLUME_VALUES(GL_STENCIL_FAIL, 1),
    POLYLUME_VALUES(GL_STENCIL_FUNC, 1),
    POLYLUME_VALUES(GL_STENCIL_REF, 1),
    POLYLUME_VALUES(GL_STENCIL_VALUE_MASK, 1),
    POLYLUME_VALUES(GL_STENCIL_WRITEMASK, 1),
    POLYLUME_VALUES(GL_TEXTURE_BUFFER_BINDING, 1),
    POLYLUME_VALUES(GL_TRANSFORM_FEEDBACK_ACTIVE, 1),
    POLYLUME_VALUES(GL_TRANSFORM_FEEDBACK_BINDING, 1),
    POLYLUME_VALUES(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, 1),
    POLYLUME_VALUES(GL_TRANSFORM_FEEDBACK_PAUSED, 1),
    POLYLUME_VALUES(GL_UNIFORM_BUFFER_BINDING, 1),
    POLYLUME_VALUES(GL_UNPACK_ALIGNMENT, 1),
    POLYLUME_VALUES(GL_UNPACK_IMAGE_HEIGHT, 1),
    POLYLUME_VALUES(GL_UNPACK_LSB_FIRST, 1),
    POLYLUME_VALUES(GL_UNPACK_ROW_LENGTH, 1),
    POLYLUME_VALUES(GL_UNPACK_SKIP_IMAGES, 1),
    POLYLUME_VALUES(GL_UNPACK_SKIP_PIXELS, 1),
    POLYLUME_VALUES(GL_UNPACK_SKIP_ROWS, 1),
    POLYLUME_VALUES(GL_UNPACK_SWAP_BYTES, 1),
    POLYLUME_VALUES(GL_VERTEX_ARRAY_BINDING, 1),
};

/// Read for each of the first draw buffers.
constexpr Values kPerDrawBuffer[] = {
    POLYLUME_VALUES(GL_BLEND_DST_ALPHA, 1),      POLYLUME_VALUES(GL_BLEND_DST_RGB, 1),
    POLYLUME_VALUES(GL_BLEND_EQUATION_ALPHA, 1), POLYLUME_VALUES(GL_BLEND_EQUATION_RGB, 1),
    POLYLUME_VALUES(GL_BLEND_SRC_ALPHA, 1),      POLYLUME_VALUES(GL_BLEND_SRC_RGB, 1),
};

/// Read for each texture unit.
constexpr Named kPerUnit[] = {
    POLYLUME_NAMED(GL_SAMPLER_BINDING),
    POLYLUME_NAMED(GL_TEXTURE_BINDING_1D),
    POLYLUME_NAMED(GL_TEXTURE_BINDING_1D_ARRAY),
    POLYLUME_NAMED(GL_TEXTURE_BINDING_2D),
    POLYLUME_NAMED(GL_TEXTURE_BINDING_2D_ARRAY),
    POLYLUME_NAMED(GL_TEXTURE_BINDING_2D_MULTISAMPLE),
    POLYLUME_NAMED(GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY),
    POLYLUME_NAMED(GL_TEXTURE_BINDING_3D),
    POLYLUME_NAMED(GL_TEXTURE_BINDING_BUFFER),
    POLYLUME_NAMED(GL_TEXTURE_BINDING_CUBE_MAP),
    POLYLUME_NAMED(GL_TEXTURE_BINDING_CUBE_MAP_ARRAY),
    POLYLUME_NAMED(GL_TEXTURE_BINDING_RECTANGLE),
};

/// A kind of indexed buffer bindings.
struct Indexed {
    const char* name;
    GLenum target, binding, start, size, count;
};

constexpr Indexed kIndexed[] = {
    {"uniform buffer", GL_UNIFORM_BUFFER, GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START,
     GL_UNIFORM_BUFFER_SIZE, GL_MAX_UNIFORM_BUFFER_BINDINGS},
    {"storage buffer", GL_SHADER_STORAGE_BUFFER, GL_SHADER_STORAGE_BUFFER_BINDING,
     GL_SHADER_STORAGE_BUFFER_START, GL_SHADER_STORAGE_BUFFER_SIZE,
     GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS},
    {"atomic counter buffer", GL_ATOMIC_COUNTER_BUFFER, GL_ATOMIC_COUNTER_BUFFER_BINDING,
     GL_ATOMIC_COUNTER_BUFFER_START, GL_ATOMIC_COUNTER_BUFFER_SIZE,
     GL_MAX_ATOMIC_COUNTER_BUFFER_BINDINGS},
    {"transform feedback buffer", GL_TRANSFORM_FEEDBACK_BUFFER,
     GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, GL_TRANSFORM_FEEDBACK_BUFFER_START,
     GL_TRANSFORM_FEEDBACK_BUFFER_SIZE, GL_MAX_TRANSFORM_FEEDBACK_BUFFERS},
};

constexpr Named kPerImageUnit[] = {
    POLYLUME_NAMED(GL_IMAGE_BINDING_ACCESS), POLYLUME_NAMED(GL_IMAGE_BINDING_FORMAT),
    POLYLUME_NAMED(GL_IMAGE_BINDING_LAYER),  POLYLUME_NAMED(GL_IMAGE_BINDING_LAYERED),
    POLYLUME_NAMED(GL_IMAGE_BINDING_LEVEL),  POLYLUME_NAMED(GL_IMAGE_BINDING_NAME),
};

template <typename Value>
std::string joined(const Value* values, int count) {
    std::ostringstream text;
    for (int i = 0; i < count; ++i) text << (i > 0 ? " " : "") << +values[i];
    return text.str();
}

GLint integer(const gl::Functions& gl, GLenum name) {
    GLint value = 0;
    gl.GetIntegerv(name, &value);
    return value;
}

void readSimple(const gl::Functions& gl, StateTable& table) {
    for (const Named& capability : kCapabilities) {
        table[capability.name] = gl.IsEnabled(capability.value) == GL_TRUE ? "on" : "off";
    }
    for (const Values& values : kFloats) {
        std::array<GLfloat, 4> read{};
        gl.GetFloatv(values.value, read.data());
        table[values.name] = joined(read.data(), values.count);
    }
    for (const Values& values : kIntegers) {
        std::array<GLint, 4> read{};
        gl.GetIntegerv(values.value, read.data());
        table[values.name] = joined(read.data(), values.count);
    }
}

void readPerDrawBuffer(const gl::Functions& gl, StateTable& table) {
    for (GLuint i = 0; i < static_cast<GLuint>(integer(gl, GL_MAX_DRAW_BUFFERS)); ++i) {
        std::array<GLboolean, 4> mask{};
        gl.GetBooleani_v(GL_COLOR_WRITEMASK, i, mask.data());
        table[concat("GL_COLOR_WRITEMASK ", i)] = joined(mask.data(), 4);
        table[concat("GL_BLEND ", i)] = gl.IsEnabledi(GL_BLEND, i) == GL_TRUE ? "on" : "off";
        for (const Values& values : kPerDrawBuffer) {
            GLint value = 0;
            gl.GetIntegeri_v(values.value, i, &value);
            table[concat(values.name, " ", i)] = std::to_string(value);
        }
    }
}

void readPerViewport(const gl::Functions& gl, StateTable& table) {
    for (GLuint i = 0; i < static_cast<GLuint>(integer(gl, GL_MAX_VIEWPORTS)); ++i) {
        std::array<GLfloat, 4> viewport{};
        gl.GetFloati_v(GL_VIEWPORT, i, viewport.data());
        table[concat("GL_VIEWPORT ", i)] = joined(viewport.data(), 4);
        std::array<GLint, 4> box{};
        gl.GetIntegeri_v(GL_SCISSOR_BOX, i, box.data());
        table[concat("GL_SCISSOR_BOX ", i)] = joined(box.data(), 4);
        std::array<GLdouble, 2> range{};
        gl.GetDoublei_v(GL_DEPTH_RANGE, i, range.data());
        table[concat("GL_DEPTH_RANGE ", i)] = joined(range.data(), 2);
        table[concat("GL_SCISSOR_TEST ", i)] =
            gl.IsEnabledi(GL_SCISSOR_TEST, i) == GL_TRUE ? "on" : "off";
    }
}

void readUnits(const gl::Functions& gl, StateTable& table) {
    const GLint active = integer(gl, GL_ACTIVE_TEXTURE);
    const GLint count = integer(gl, GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
    for (GLint unit = 0; unit < count; ++unit) {
        gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        for (const Named& binding : kPerUnit) {
            table[concat(binding.name, " ", unit)] = std::to_string(integer(gl, binding.value));
        }
    }
    gl.ActiveTexture(static_cast<GLenum>(active));
    for (GLuint unit = 0; unit < static_cast<GLuint>(integer(gl, GL_MAX_IMAGE_UNITS)); ++unit) {
        for (const Named& value : kPerImageUnit) {
            GLint read = 0;
            gl.GetIntegeri_v(value.value, unit, &read);
            table[concat(value.name, " ", unit)] = std::to_string(read);
        }
    }
}

void readBuffers(const gl::Functions& gl, StateTable& table) {
    for (const Indexed& kind : kIndexed) {
        for (GLuint i = 0; i < static_cast<GLuint>(integer(gl, kind.count)); ++i) {
            GLint name = 0;
            GLint64 start = 0, size = 0;
            gl.GetIntegeri_v(kind.binding, i, &name);
            gl.GetInteger64i_v(kind.start, i, &start);
            gl.GetInteger64i_v(kind.size, i, &size);
            table[concat(kind.name, " ", i)] = concat(name, " from ", start, " of ", size);
        }
    }
}

void readQueries(const gl::Functions& gl, StateTable& table) {
    for (const Named& target : {POLYLUME_NAMED(GL_TIME_ELAPSED), POLYLUME_NAMED(GL_SAMPLES_PASSED),
                                POLYLUME_NAMED(GL_PRIMITIVES_GENERATED)}) {
        GLint name = 0;
        gl.GetQueryiv(target.value, GL_CURRENT_QUERY, &name);
        table[concat("query ", target.name)] = std::to_string(name);
    }
    for (GLuint i = 0; i < static_cast<GLuint>(integer(gl, GL_MAX_SAMPLE_MASK_WORDS)); ++i) {
        GLint mask = 0;
        gl.GetIntegeri_v(GL_SAMPLE_MASK_VALUE, i, &mask);
        table[concat("GL_SAMPLE_MASK_VALUE ", i)] = std::to_string(mask);
    }
}

}  // namespace

StateTable readState(const gl::Functions& gl) {
    StateTable table;
    readSimple(gl, table);
    readPerDrawBuffer(gl, table);
    readPerViewport(gl, table);
    readUnits(gl, table);
    readBuffers(gl, table);
    readQueries(gl, table);
    return table;
}

std::vector<std::string> differences(const StateTable& before, const StateTable& after) {
    std::vector<std::string> found;
    for (const auto& [name, value] : before) {
        const auto other = after.find(name);
        if (other == after.end() || other->second != value) {
            found.push_back(concat(name, ": ", value, " became ",
                                   other == after.end() ? "nothing" : other->second));
        }
    }
    return found;
}

}  // namespace polylume::test
