#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

namespace regarment {

/// A pair of shaders/NAME.vert and shaders/NAME.frag, compiled and linked. Their text is part of
/// the binary. Belongs to the context current when it was made; use it in that thread only.
class Shader {
 public:
  /// Throws InvalidInput when no pair of that name is built in; Error (1) with file, line and the
  /// compiler's words when it does not compile or link.
  explicit Shader(std::string_view name);
  /// The same from text; `name` is used in messages.
  Shader(std::string_view name, std::string_view vertex_text, std::string_view fragment_text);
  ~Shader();
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;

  void use() const;
  /// Sets a uniform. Throws InvalidInput naming a uniform the pair does not have.
  void set(const char* uniform, const Eigen::Matrix4f& value) const;
  void set(const char* uniform, const Eigen::Matrix3f& value) const;
  void set(const char* uniform, const Eigen::Vector2f& value) const;
  void set(const char* uniform, float value) const;

 private:
  int location(const char* uniform) const;
  std::string name_;
  unsigned program_ = 0;  // OpenGL name, owned
};

/// The text of shaders/NAME as built in. Throws InvalidInput when there is none.
std::string_view shader_text(std::string_view file_name);

}  // namespace regarment
