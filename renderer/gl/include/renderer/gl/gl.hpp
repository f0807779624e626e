// OpenGL objects that manage their own lifetime, shader programs, and errors as exceptions. Private to the
// module.
#pragma once

#include <epoxy/gl.h>

#include <initializer_list>
#include <span>
#include <string_view>
#include <utility>

namespace deixis::renderer::gl {

/// Owns one GL name and deletes it; the context it was made in must be current then.
template <typename Kind>
class Handle {
  public:
    Handle() = default;
    explicit Handle(GLuint name) : name_(name) {}
    Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0U)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() {
        if (name_ != 0U) Kind::destroy(name_);
    }
    [[nodiscard]] GLuint name() const { return name_; }

  private:
    GLuint name_ = 0;
};

struct BufferKind {
    static void destroy(GLuint name) { glDeleteBuffers(1, &name); }
};
struct TextureKind {
    static void destroy(GLuint name) { glDeleteTextures(1, &name); }
};
struct RenderbufferKind {
    static void destroy(GLuint name) { glDeleteRenderbuffers(1, &name); }
};
struct FramebufferKind {
    static void destroy(GLuint name) { glDeleteFramebuffers(1, &name); }
};
struct VertexArrayKind {
    static void destroy(GLuint name) { glDeleteVertexArrays(1, &name); }
};
struct ShaderKind {
    static void destroy(GLuint name) { glDeleteShader(name); }
};
struct ProgramKind {
    static void destroy(GLuint name) { glDeleteProgram(name); }
};

using Buffer = Handle<BufferKind>;
using Texture = Handle<TextureKind>;
using Renderbuffer = Handle<RenderbufferKind>;
using Framebuffer = Handle<FramebufferKind>;
using VertexArray = Handle<VertexArrayKind>;
using Shader = Handle<ShaderKind>;
using Program = Handle<ProgramKind>;

/// A buffer with these contents that never change.
template <typename T>
[[nodiscard]] Buffer fixedBuffer(std::span<const T> items) {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    Buffer buffer(name);
    // GL forbids storage of no bytes; an empty mesh still gets a valid buffer.
    const T none{};
    glNamedBufferStorage(name, static_cast<GLsizeiptr>(items.empty() ? sizeof(T) : items.size_bytes()),
                         items.empty() ? &none : items.data(), 0);
    return buffer;
}

[[nodiscard]] Buffer dynamicBuffer(GLsizeiptr bytes);
[[nodiscard]] VertexArray vertexArray();
[[nodiscard]] Framebuffer framebuffer();
[[nodiscard]] Texture texture2d(GLenum format, int width, int height, int levels = 1);
/// Multisampled layers; `samples` 1 gives plain ones.
[[nodiscard]] Texture sampledLayers(GLenum format, int width, int height, int layers, int samples);
/// `samples` 1 gives a plain renderbuffer.
[[nodiscard]] Renderbuffer renderbuffer(GLenum format, int width, int height, int samples);

/// Throws std::runtime_error naming `what` where the framebuffer is incomplete.
void requireComplete(const Framebuffer& framebuffer, std::string_view what);

/// Binds a framebuffer of others (0: the window's) with a viewport of this size. Drivers learn only so that a
/// window has another size by now: what is copied into it unbound stays cut to the size before (Mesa).
void bindForeign(GLuint framebuffer, int width, int height);

/// Copies a finished picture into a framebuffer of others, which stays bound. Bytes go over as they are,
/// whether or not the window says that it is sRGB.
void copyPicture(const Framebuffer& from, GLuint to, int width, int height);

/// Makes the framebuffer current and clears it, black and far; linear colours written are stored as sRGB.
void beginPicture(const Framebuffer& framebuffer, int width, int height);

/// Compiles and links. Each stage is the concatenation of its parts after the #version line; throws
/// std::runtime_error with the driver's log.
using Parts = std::initializer_list<std::string_view>;
[[nodiscard]] Program drawProgram(std::string_view name, Parts vertex, Parts fragment);
[[nodiscard]] Program computeProgram(std::string_view name, Parts compute);

/// Location of a uniform that the program must have; throws std::runtime_error if it has none.
[[nodiscard]] GLint uniform(const Program& program, const char* name);

/// In debug builds: makes the driver report errors to checkErrors.
void watchErrors();
/// Throws std::runtime_error with `what` and the error where a GL call failed since the last check.
void checkErrors(std::string_view what);
/// Whether every GL call since the last check went well.
[[nodiscard]] bool noErrors();

/// Scissor, stencil and depth test, culling and blending off, every channel written, triangles filled:
/// whatever the program drew before for itself.
void resetDrawingState();

}  // namespace deixis::renderer::gl
