#include "renderer/gl/gl.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

namespace deixis::renderer::gl {
namespace {

std::string_view errorName(GLenum error) {
    switch (error) {
        case GL_INVALID_ENUM:
            return "GL_INVALID_ENUM";
        case GL_INVALID_VALUE:
            return "GL_INVALID_VALUE";
        case GL_INVALID_OPERATION:
            return "GL_INVALID_OPERATION";
        case GL_INVALID_FRAMEBUFFER_OPERATION:
            return "GL_INVALID_FRAMEBUFFER_OPERATION";
        case GL_OUT_OF_MEMORY:
            return "GL_OUT_OF_MEMORY";
        case GL_CONTEXT_LOST:
            return "GL_CONTEXT_LOST";
        default:
            return "an unknown GL error";
    }
}

Shader compile(std::string_view name, GLenum stage, Parts parts) {
    std::vector<const GLchar*> texts{"#version 450 core\n"};
    std::vector<GLint> lengths{-1};
    for (const std::string_view part : parts) {
        texts.push_back(part.data());
        lengths.push_back(static_cast<GLint>(part.size()));
    }
    Shader shader(glCreateShader(stage));
    glShaderSource(shader.name(), static_cast<GLsizei>(texts.size()), texts.data(), lengths.data());
    glCompileShader(shader.name());
    GLint good = GL_FALSE;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &good);
    if (good == GL_TRUE) return shader;
    std::array<GLchar, 4096> log{};
    glGetShaderInfoLog(shader.name(), static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw std::runtime_error(fmt::format("glCompileShader({}) failed: {}", name, log.data()));
}

Program link(std::string_view name, std::initializer_list<GLuint> shaders) {
    Program program(glCreateProgram());
    for (const GLuint shader : shaders) glAttachShader(program.name(), shader);
    glLinkProgram(program.name());
    for (const GLuint shader : shaders) glDetachShader(program.name(), shader);
    GLint good = GL_FALSE;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &good);
    if (good == GL_TRUE) return program;
    std::array<GLchar, 4096> log{};
    glGetProgramInfoLog(program.name(), static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw std::runtime_error(fmt::format("glLinkProgram({}) failed: {}", name, log.data()));
}

#ifndef NDEBUG
// An exception must not cross the driver's frames, so the first message waits here for checkErrors.
thread_local std::string reported_error;

void GLAPIENTRY onMessage(GLenum, GLenum type, GLuint, GLenum, GLsizei length, const GLchar* message,
                          const void*) {
    if (type != GL_DEBUG_TYPE_ERROR || !reported_error.empty()) return;
    reported_error =
        length < 0 ? std::string(message) : std::string(message, static_cast<std::size_t>(length));
}
#endif

}  // namespace

Buffer dynamicBuffer(GLsizeiptr bytes) {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    glNamedBufferStorage(name, bytes, nullptr, GL_DYNAMIC_STORAGE_BIT);
    return Buffer(name);
}

VertexArray vertexArray() {
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    return VertexArray(name);
}

Framebuffer framebuffer() {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    return Framebuffer(name);
}

Texture texture2d(GLenum format, int width, int height, int levels) {
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &name);
    glTextureStorage2D(name, levels, format, width, height);
    glTextureParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return Texture(name);
}

Texture sampledLayers(GLenum format, int width, int height, int layers, int samples) {
    GLuint name = 0;
    if (samples > 1) {
        glCreateTextures(GL_TEXTURE_2D_MULTISAMPLE_ARRAY, 1, &name);
        glTextureStorage3DMultisample(name, samples, format, width, height, layers, GL_TRUE);
    } else {
        glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &name);
        glTextureStorage3D(name, 1, format, width, height, layers);
    }
    return Texture(name);
}

Renderbuffer renderbuffer(GLenum format, int width, int height, int samples) {
    GLuint name = 0;
    glCreateRenderbuffers(1, &name);
    glNamedRenderbufferStorageMultisample(name, samples > 1 ? samples : 0, format, width, height);
    return Renderbuffer(name);
}

void beginPicture(const Framebuffer& framebuffer, int width, int height) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    glViewport(0, 0, width, height);
    glEnable(GL_FRAMEBUFFER_SRGB);
    const std::array<GLfloat, 4> black{0.0F, 0.0F, 0.0F, 1.0F};
    const GLfloat farthest = 1.0F;
    glClearNamedFramebufferfv(framebuffer.name(), GL_COLOR, 0, black.data());
    glClearNamedFramebufferfv(framebuffer.name(), GL_DEPTH, 0, &farthest);
}

void bindForeign(GLuint framebuffer, int width, int height) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, width, height);
}

void copyPicture(const Framebuffer& from, GLuint to, int width, int height) {
    bindForeign(to, width, height);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glBlitNamedFramebuffer(from.name(), to, 0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                           GL_NEAREST);
}

void requireComplete(const Framebuffer& framebuffer, std::string_view what) {
    const GLenum status = glCheckNamedFramebufferStatus(framebuffer.name(), GL_DRAW_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw std::runtime_error(fmt::format("glCheckNamedFramebufferStatus({}): {:#x}", what, status));
}

Program drawProgram(std::string_view name, Parts vertex, Parts fragment) {
    const Shader vertex_shader = compile(name, GL_VERTEX_SHADER, vertex);
    const Shader fragment_shader = compile(name, GL_FRAGMENT_SHADER, fragment);
    return link(name, {vertex_shader.name(), fragment_shader.name()});
}

Program computeProgram(std::string_view name, Parts compute) {
    const Shader shader = compile(name, GL_COMPUTE_SHADER, compute);
    return link(name, {shader.name()});
}

GLint uniform(const Program& program, const char* name) {
    const GLint location = glGetUniformLocation(program.name(), name);
    if (location < 0) throw std::runtime_error(fmt::format("glGetUniformLocation(\"{}\"): not there", name));
    return location;
}

void watchErrors() {
#ifndef NDEBUG
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(onMessage, nullptr);
#endif
}

void checkErrors(std::string_view what) {
    std::string details;
#ifndef NDEBUG
    details = std::exchange(reported_error, {});
#endif
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR && details.empty()) return;
    throw std::runtime_error(fmt::format("{}: {} {}", what, errorName(error), details));
}

bool noErrors() {
#ifndef NDEBUG
    reported_error.clear();
#endif
    return glGetError() == GL_NO_ERROR;
}

void resetDrawingState() {
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    for (GLuint unit = 0; unit < 2; ++unit) glBindSampler(unit, 0);
}

}  // namespace deixis::renderer::gl
