#pragma once

#include <memory>
#include <string>

namespace regarment {

/// An off-screen OpenGL 4.5 core context, drawn by the processor: needs no display and no graphics
/// card, and gives the same bytes on every machine.
///
/// One per thread: a context is used by the thread that made it, and by no other. Not copyable.
/// While it lives it is the thread's current context; contexts do not nest.
class Context {
 public:
  /// Throws Error (1) when the machine cannot provide one, saying what is missing; InvalidInput
  /// when the thread has one already.
  Context();
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// The context of the calling thread, made at the first call and kept until the thread ends.
  static Context& of_this_thread();

  /// What draws, for `regarment doctor`: "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5 ...".
  std::string description() const;

  /// Throws Error (1) naming `what` when OpenGL has recorded an error since the last call.
  void check(const std::string& what) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace regarment
