#pragma once

// OpenGL for the .cpp files of this library only. OSMesa exports every function by name, so there
// is no loader.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <utility>

namespace regarment {

/// Owns one OpenGL object. `Functions` offers `static GLuint make()` and `static void
/// free(GLuint)`. Movable; destroy it in the thread of its context.
template <typename Functions>
class GlObject {
 public:
  GlObject() : name_(Functions::make()) {}
  ~GlObject() {
    if (name_ != 0) Functions::free(name_);
  }
  GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  GLuint name() const { return name_; }

 private:
  GLuint name_;
};

struct BufferFunctions {
  static GLuint make() {
    GLuint name = 0;
    glGenBuffers(1, &name);
    return name;
  }
  static void free(GLuint name) { glDeleteBuffers(1, &name); }
};
struct VertexArrayFunctions {
  static GLuint make() {
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    return name;
  }
  static void free(GLuint name) { glDeleteVertexArrays(1, &name); }
};
struct FramebufferFunctions {
  static GLuint make() {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    return name;
  }
  static void free(GLuint name) { glDeleteFramebuffers(1, &name); }
};
struct RenderbufferFunctions {
  static GLuint make() {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    return name;
  }
  static void free(GLuint name) { glDeleteRenderbuffers(1, &name); }
};

using GlBuffer = GlObject<BufferFunctions>;
using GlVertexArray = GlObject<VertexArrayFunctions>;
using GlFramebuffer = GlObject<FramebufferFunctions>;
using GlRenderbuffer = GlObject<RenderbufferFunctions>;

}  // namespace regarment
