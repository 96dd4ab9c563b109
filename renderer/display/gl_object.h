#pragma once
#include <glad/gl.h>

#include <utility>

namespace brewster {

/// The name of a GL object, owned: moved, never copied, deleted with its owner, which must go before its context does.
/// A default one is empty, so that members can exist before their context.
template <class Kind>
class GlObject {
  public:
    GlObject() = default;
    static GlObject create() {
        GlObject object;
        Kind::create(object.id_);
        return object;
    }
    ~GlObject() {
        if (id_ != 0) Kind::destroy(id_);
    }
    GlObject(GlObject&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }

    GLuint id() const { return id_; }

  private:
    GLuint id_ = 0;
};

struct BufferKind {
    static void create(GLuint& id) { glGenBuffers(1, &id); }
    static void destroy(GLuint id) { glDeleteBuffers(1, &id); }
};
struct TextureKind {
    static void create(GLuint& id) { glGenTextures(1, &id); }
    static void destroy(GLuint id) { glDeleteTextures(1, &id); }
};
struct FramebufferKind {
    static void create(GLuint& id) { glGenFramebuffers(1, &id); }
    static void destroy(GLuint id) { glDeleteFramebuffers(1, &id); }
};
struct RenderbufferKind {
    static void create(GLuint& id) { glGenRenderbuffers(1, &id); }
    static void destroy(GLuint id) { glDeleteRenderbuffers(1, &id); }
};
struct VertexArrayKind {
    static void create(GLuint& id) { glGenVertexArrays(1, &id); }
    static void destroy(GLuint id) { glDeleteVertexArrays(1, &id); }
};
struct ProgramKind {
    static void create(GLuint& id) { id = glCreateProgram(); }
    static void destroy(GLuint id) { glDeleteProgram(id); }
};

using Buffer = GlObject<BufferKind>;
using Texture = GlObject<TextureKind>;
using Framebuffer = GlObject<FramebufferKind>;
using Renderbuffer = GlObject<RenderbufferKind>;
using VertexArray = GlObject<VertexArrayKind>;
using ProgramObject = GlObject<ProgramKind>;

}  // namespace brewster
