#include "render/context.h"

#include <array>
#include <cstdlib>
#include <mutex>
#include <string>

#include "base/error.h"
#include "render/gl.h"
#include "render/sanitizers.h"

// After gl.h, which asks for the prototypes.
#include <GL/osmesa.h>

namespace regarment {
namespace {

// llvmpipe hands tiles to threads of its own. Measured with our pictures, drawing in the calling
// thread is faster on two cores, and a service that runs several jobs needs no more threads.
void draw_in_the_calling_thread() {
  static std::once_flag once;
  std::call_once(once, [] { setenv("LP_NUM_THREADS", "0", /*overwrite=*/0); });
}

thread_local bool thread_has_context = false;

}  // namespace

struct Context::State {
  OSMesaContext handle = nullptr;
  std::array<unsigned char, 4> pixel{};  // OSMesa wants a window; we draw into framebuffers
  ~State() {
    if (handle == nullptr) return;
    OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    OSMesaDestroyContext(handle);
    thread_has_context = false;
  }
};

Context::Context() : state_(std::make_unique<State>()) {
  if (thread_has_context) throw InvalidInput("this thread has a drawing context already");
  draw_in_the_calling_thread();
  constexpr std::array<int, 13> kAttributes = {OSMESA_FORMAT,
                                               OSMESA_RGBA,
                                               OSMESA_PROFILE,
                                               OSMESA_CORE_PROFILE,
                                               OSMESA_CONTEXT_MAJOR_VERSION,
                                               4,
                                               OSMESA_CONTEXT_MINOR_VERSION,
                                               5,
                                               OSMESA_DEPTH_BITS,
                                               0,
                                               OSMESA_STENCIL_BITS,
                                               0,
                                               0};
  state_->handle = OSMesaCreateContextAttribs(kAttributes.data(), nullptr);
  if (state_->handle == nullptr) {
    throw Error(1,
                "cannot draw: OSMesa offers no OpenGL 4.5 core context; install libosmesa6 22.3 "
                "or newer with llvmpipe");
  }
  if (OSMesaMakeCurrent(state_->handle, state_->pixel.data(), GL_UNSIGNED_BYTE, 1, 1) != GL_TRUE) {
    throw Error(1, "cannot draw: OSMesa refuses to make its context current");
  }
  thread_has_context = true;
}

Context::~Context() = default;

Context& Context::of_this_thread() {
  thread_local Context context;
  return context;
}

std::string Context::description() const {
  const auto text = [](GLenum name) {
    const GLubyte* value = glGetString(name);
    return value == nullptr ? std::string("unknown")
                            : std::string(reinterpret_cast<const char*>(value));
  };
  return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

void Context::check(const std::string& what) const {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return;
  if (error == GL_OUT_OF_MEMORY) throw TemporaryError("out of memory while drawing: " + what);
  throw Error(1, "OpenGL error " + std::to_string(error) + " while drawing: " + what);
}

}  // namespace regarment
