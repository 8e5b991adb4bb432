// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <array>

#include "host_state.hpp"

namespace polylume::test {
namespace {

constexpr GLuint kUnitCount = 18;
constexpr GLuint kBlockCount = 10;

GLuint makeProgram(const gl::Functions& gl) {
    const GLuint program = gl.CreateProgram();
    const auto attach = [&](GLenum stage, const char* text) {
        const GLuint shader = gl.CreateShader(stage);
        gl.ShaderSource(shader, 1, &text, nullptr);
        gl.CompileShader(shader);
        gl.AttachShader(program, shader);
        gl.DeleteShader(shader);
    };
    attach(GL_VERTEX_SHADER,
           "#version 450 core\nout vec4 kept; void main() { kept = vec4(1); gl_Position = kept; }");
    attach(GL_FRAGMENT_SHADER,
           "#version 450 core\nout vec4 color; void main() { color = vec4(1); }");
    const char* const varying = "kept";
    gl.TransformFeedbackVaryings(program, 1, &varying, GL_INTERLEAVED_ATTRIBS);
    gl.LinkProgram(program);
    return program;
}

GLuint makeBuffer(const gl::Functions& gl) {
    GLuint name = 0;
    gl.CreateBuffers(1, &name);
    gl.NamedBufferStorage(name, 65'536, nullptr, GL_DYNAMIC_STORAGE_BIT);
    return name;
}

/// Of the targets that we bind, and another one.
void bindTextures(const gl::Functions& gl, GLuint unit) {
    const auto make = [&](GLenum target) {
        GLuint name = 0;
        gl.CreateTextures(target, 1, &name);
        return name;
    };
    const GLuint plane = make(GL_TEXTURE_2D);
    gl.TextureStorage2D(plane, 2, GL_RGBA8, 4, 4);
    gl.BindTextureUnit(unit, plane);
    const GLuint array = make(GL_TEXTURE_2D_ARRAY);
    gl.TextureStorage3D(array, 1, GL_RGBA8, 4, 4, 3);
    gl.BindTextureUnit(unit, array);
    const GLuint texels = make(GL_TEXTURE_BUFFER);
    gl.TextureBuffer(texels, GL_R8, makeBuffer(gl));
    gl.BindTextureUnit(unit, texels);
    const GLuint volume = make(GL_TEXTURE_3D);
    gl.TextureStorage3D(volume, 1, GL_RGBA8, 2, 2, 2);
    gl.BindTextureUnit(unit, volume);
    GLuint sampler = 0;
    gl.CreateSamplers(1, &sampler);
    gl.SamplerParameteri(sampler, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    gl.BindSampler(unit, sampler);
}

void bindImages(const gl::Functions& gl) {
    GLuint name = 0;
    gl.CreateTextures(GL_TEXTURE_2D_ARRAY, 1, &name);
    gl.TextureStorage3D(name, 2, GL_RGBA16F, 8, 8, 4);
    gl.BindImageTexture(0, name, 1, GL_FALSE, 2, GL_WRITE_ONLY, GL_RGBA16F);
    gl.BindImageTexture(1, name, 0, GL_TRUE, 0, GL_READ_ONLY, GL_RGBA16F);
}

void bindBuffers(const gl::Functions& gl) {
    for (GLuint i = 0; i < kBlockCount; ++i) {
        // Some in part, some whole, and one none.
        if (i == 4) continue;
        for (const GLenum target : {GL_UNIFORM_BUFFER, GL_SHADER_STORAGE_BUFFER}) {
            if (i % 2 == 0) {
                gl.BindBufferRange(target, i, makeBuffer(gl), 256 * (i + 1), 1024 + 16 * i);
            } else {
                gl.BindBufferBase(target, i, makeBuffer(gl));
            }
        }
    }
    for (const GLenum target :
         {GL_UNIFORM_BUFFER, GL_SHADER_STORAGE_BUFFER, GL_ARRAY_BUFFER, GL_COPY_READ_BUFFER,
          GL_COPY_WRITE_BUFFER, GL_DISPATCH_INDIRECT_BUFFER, GL_DRAW_INDIRECT_BUFFER,
          GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER, GL_QUERY_BUFFER, GL_TEXTURE_BUFFER}) {
        gl.BindBuffer(target, makeBuffer(gl));
    }
}

void setPixelStores(const gl::Functions& gl) {
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 8);
    gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 100);
    gl.PixelStorei(GL_UNPACK_IMAGE_HEIGHT, 50);
    gl.PixelStorei(GL_UNPACK_SKIP_ROWS, 3);
    gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 2);
    gl.PixelStorei(GL_UNPACK_SKIP_IMAGES, 1);
    gl.PixelStorei(GL_UNPACK_SWAP_BYTES, GL_TRUE);
    gl.PixelStorei(GL_UNPACK_LSB_FIRST, GL_TRUE);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 2);
    gl.PixelStorei(GL_PACK_ROW_LENGTH, 64);
    gl.PixelStorei(GL_PACK_SKIP_ROWS, 5);
}

void bindFramebuffers(const gl::Functions& gl) {
    for (const GLenum target : {GL_DRAW_FRAMEBUFFER, GL_READ_FRAMEBUFFER}) {
        GLuint name = 0, texture = 0;
        gl.CreateFramebuffers(1, &name);
        gl.CreateTextures(GL_TEXTURE_2D, 1, &texture);
        gl.TextureStorage2D(texture, 1, GL_RGBA8, 16, 16);
        gl.NamedFramebufferTexture(name, GL_COLOR_ATTACHMENT1, texture, 0);
        gl.NamedFramebufferDrawBuffer(name, GL_COLOR_ATTACHMENT1);
        gl.NamedFramebufferReadBuffer(name, GL_COLOR_ATTACHMENT1);
        gl.BindFramebuffer(target, name);
    }
    GLuint renderbuffer = 0;
    gl.CreateRenderbuffers(1, &renderbuffer);
    gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
}

void setRasterState(const gl::Functions& gl) {
    for (const GLenum capability : {GL_COLOR_LOGIC_OP,
                                    GL_CULL_FACE,
                                    GL_DEPTH_CLAMP,
                                    GL_DEPTH_TEST,
                                    GL_FRAMEBUFFER_SRGB,
                                    GL_LINE_SMOOTH,
                                    GL_POLYGON_OFFSET_FILL,
                                    GL_POLYGON_OFFSET_LINE,
                                    GL_POLYGON_SMOOTH,
                                    GL_PRIMITIVE_RESTART,
                                    GL_PROGRAM_POINT_SIZE,
                                    GL_RASTERIZER_DISCARD,
                                    GL_SAMPLE_ALPHA_TO_COVERAGE,
                                    GL_SAMPLE_ALPHA_TO_ONE,
                                    GL_SAMPLE_COVERAGE,
                                    GL_SAMPLE_MASK,
                                    GL_SAMPLE_SHADING,
                                    GL_STENCIL_TEST,
                                    GL_TEXTURE_CUBE_MAP_SEAMLESS,
                                    GL_CLIP_DISTANCE0,
                                    GL_CLIP_DISTANCE3,
                                    GL_CLIP_DISTANCE7}) {
        gl.Enable(capability);
    }
    gl.Disable(GL_DITHER);
    gl.Disable(GL_MULTISAMPLE);
    gl.LogicOp(GL_INVERT);
    gl.CullFace(GL_FRONT_AND_BACK);
    gl.FrontFace(GL_CW);
    gl.DepthFunc(GL_NEVER);
    gl.DepthMask(GL_FALSE);
    gl.StencilFuncSeparate(GL_FRONT, GL_NEVER, 3, 0x55);
    gl.StencilFuncSeparate(GL_BACK, GL_LESS, 4, 0x33);
    gl.StencilMask(0x0F);
    gl.SampleMaski(0, 0);
    gl.SampleCoverage(0.25f, GL_TRUE);
    gl.MinSampleShading(0.5f);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    gl.PolygonOffset(2.0f, 3.0f);
    gl.PointSize(3.0f);
    gl.PatchParameteri(GL_PATCH_VERTICES, 5);
    gl.ProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
    gl.PrimitiveRestartIndex(2);
    gl.ClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    gl.BlendColor(0.1f, 0.2f, 0.3f, 0.4f);
    gl.ClearColor(0.5f, 0.6f, 0.7f, 0.8f);
    gl.ClearDepth(0.25);
    gl.ClearStencil(9);
    gl.Hint(GL_FRAGMENT_SHADER_DERIVATIVE_HINT, GL_NICEST);
}

void setIndexedState(const gl::Functions& gl) {
    for (GLuint i = 0; i < 8; ++i) {
        gl.Enablei(GL_BLEND, i);
        gl.BlendFuncSeparatei(i, GL_DST_COLOR, GL_ZERO, GL_CONSTANT_COLOR, GL_SRC_ALPHA_SATURATE);
        gl.BlendEquationSeparatei(i, GL_MAX, GL_FUNC_REVERSE_SUBTRACT);
        const bool odd = i % 2 == 1;
        gl.ColorMaski(i, odd, !odd, GL_FALSE, GL_TRUE);
    }
    for (GLuint i = 0; i < 4; ++i) {
        const auto shift = static_cast<float>(i);
        gl.ViewportIndexedf(i, 1.5f + shift, 2.25f, 3.0f, 4.0f);
        gl.ScissorIndexed(i, 1, 2, static_cast<GLsizei>(i), 1);
        gl.Enablei(GL_SCISSOR_TEST, i);
        gl.DepthRangeIndexed(i, 0.9, 0.1);
    }
}

/// Transform feedback goes on, a query is active.
void beginStretches(const gl::Functions& gl) {
    GLuint query = 0;
    gl.CreateQueries(GL_SAMPLES_PASSED, 1, &query);
    gl.BeginQuery(GL_SAMPLES_PASSED, query);
    GLuint feedback = 0;
    gl.CreateTransformFeedbacks(1, &feedback);
    gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedback);
    gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, makeBuffer(gl));
    gl.BeginTransformFeedback(GL_POINTS);
}

}  // namespace

void setOddState(const gl::Functions& gl) {
    for (GLuint unit = 0; unit < kUnitCount; ++unit) bindTextures(gl, unit);
    gl.ActiveTexture(GL_TEXTURE0 + 5);
    bindImages(gl);
    bindFramebuffers(gl);
    setRasterState(gl);
    setIndexedState(gl);
    GLuint vertexArray = 0, pipeline = 0;
    gl.CreateVertexArrays(1, &vertexArray);
    gl.BindVertexArray(vertexArray);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, makeBuffer(gl));
    gl.CreateProgramPipelines(1, &pipeline);
    gl.BindProgramPipeline(pipeline);
    gl.UseProgram(makeProgram(gl));
    beginStretches(gl);
    bindBuffers(gl);
    setPixelStores(gl);
}

std::vector<StateChange> stateChanges() {
    using Gl = const gl::Functions&;
    return {
        {"program", [](Gl gl) { gl.PauseTransformFeedback(), gl.UseProgram(0); }},
        {"transform feedback", [](Gl gl) { gl.PauseTransformFeedback(); }},
        {"pipeline", [](Gl gl) { gl.PauseTransformFeedback(), gl.BindProgramPipeline(0); }},
        {"vertex array", [](Gl gl) { gl.BindVertexArray(0); }},
        {"draw framebuffer", [](Gl gl) { gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0); }},
        {"read framebuffer", [](Gl gl) { gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0); }},
        {"viewport", [](Gl gl) { gl.ViewportIndexedf(0, 0, 0, 8, 8); }},
        {"viewport's fraction", [](Gl gl) { gl.ViewportIndexedf(0, 1.0f, 2.0f, 3.0f, 4.0f); }},
        {"other viewport", [](Gl gl) { gl.Viewport(0, 0, 3, 3); }},
        {"scissor test", [](Gl gl) { gl.Disablei(GL_SCISSOR_TEST, 0); }},
        {"other scissor test", [](Gl gl) { gl.Disablei(GL_SCISSOR_TEST, 2); }},
        {"depth range", [](Gl gl) { gl.DepthRange(0.0, 1.0); }},
        {"blending", [](Gl gl) { gl.Disablei(GL_BLEND, 0); }},
        {"other blending", [](Gl gl) { gl.Disablei(GL_BLEND, 3); }},
        {"blend function", [](Gl gl) { gl.BlendFunci(0, GL_ONE, GL_ONE); }},
        {"blend equation", [](Gl gl) { gl.BlendEquationi(0, GL_FUNC_ADD); }},
        {"colour mask", [](Gl gl) { gl.ColorMaski(0, 1, 1, 1, 1); }},
        {"other colour mask", [](Gl gl) { gl.ColorMaski(5, 0, 0, 0, 0); }},
        {"depth test", [](Gl gl) { gl.Disable(GL_DEPTH_TEST); }},
        {"depth function", [](Gl gl) { gl.DepthFunc(GL_LESS); }},
        {"depth mask", [](Gl gl) { gl.DepthMask(GL_TRUE); }},
        {"culling", [](Gl gl) { gl.Disable(GL_CULL_FACE); }},
        {"stencil test", [](Gl gl) { gl.Disable(GL_STENCIL_TEST); }},
        {"logic operation", [](Gl gl) { gl.Disable(GL_COLOR_LOGIC_OP); }},
        {"rasterizer discard", [](Gl gl) { gl.Disable(GL_RASTERIZER_DISCARD); }},
        {"sample mask", [](Gl gl) { gl.Disable(GL_SAMPLE_MASK); }},
        {"alpha to coverage", [](Gl gl) { gl.Disable(GL_SAMPLE_ALPHA_TO_COVERAGE); }},
        {"sample shading", [](Gl gl) { gl.Disable(GL_SAMPLE_SHADING); }},
        {"clip distance", [](Gl gl) { gl.Disable(GL_CLIP_DISTANCE3); }},
        {"clip control", [](Gl gl) { gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE); }},
        {"polygon mode", [](Gl gl) { gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL); }},
        {"polygon smoothing", [](Gl gl) { gl.Disable(GL_POLYGON_SMOOTH); }},
        {"sRGB", [](Gl gl) { gl.Disable(GL_FRAMEBUFFER_SRGB); }},
        {"active texture", [](Gl gl) { gl.ActiveTexture(GL_TEXTURE0); }},
        {"texture of one target",
         [](Gl gl) { gl.ActiveTexture(GL_TEXTURE10), gl.BindTexture(GL_TEXTURE_3D, 0); }},
        {"textures of a unit", [](Gl gl) { gl.BindTextureUnit(11, 0); }},
        {"texels of a unit of the lists",
         [](Gl gl) { gl.ActiveTexture(GL_TEXTURE15), gl.BindTexture(GL_TEXTURE_BUFFER, 0); }},
        {"sampler", [](Gl gl) { gl.BindSampler(9, 0); }},
        {"image unit", [](Gl gl) { gl.BindImageTexture(0, 0, 0, 0, 0, GL_READ_ONLY, GL_R8); }},
        {"uniform buffer", [](Gl gl) { gl.BindBuffersBase(GL_UNIFORM_BUFFER, 3, 1, nullptr); }},
        {"uniform buffer of the lists",
         [](Gl gl) {
             const GLuint buffer = makeBuffer(gl);
             gl.BindBuffersBase(GL_UNIFORM_BUFFER, 4, 1, &buffer);
         }},
        {"storage buffer",
         [](Gl gl) { gl.BindBuffersBase(GL_SHADER_STORAGE_BUFFER, 7, 1, nullptr); }},
        {"range of a buffer",
         [](Gl gl) {
             GLint name = 0;
             gl.GetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, 0, &name);
             const auto buffer = static_cast<GLuint>(name);
             gl.BindBuffersBase(GL_UNIFORM_BUFFER, 0, 1, &buffer);
         }},
        {"generic buffer binding", [](Gl gl) { gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, 0); }},
        {"unpack buffer", [](Gl gl) { gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0); }},
        {"query buffer", [](Gl gl) { gl.BindBuffer(GL_QUERY_BUFFER, 0); }},
        {"unpack state", [](Gl gl) { gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1); }},
        {"skipped rows", [](Gl gl) { gl.PixelStorei(GL_UNPACK_SKIP_ROWS, 0); }},
        {"active query", [](Gl gl) { gl.EndQuery(GL_SAMPLES_PASSED); }},
    };
}

}  // namespace polylume::test
