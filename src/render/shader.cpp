#include "render/shader.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "base/error.h"
#include "render/gl.h"

namespace regarment {
namespace {

std::string compile_log(GLuint shader) {
  GLint length = 0;
  glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(std::size_t(std::max(length, 1)), '\0');
  glGetShaderInfoLog(shader, length, &length, log.data());
  log.resize(std::size_t(std::max(length, 0)));
  return log;
}

std::string link_log(GLuint program) {
  GLint length = 0;
  glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  std::string log(std::size_t(std::max(length, 1)), '\0');
  glGetProgramInfoLog(program, length, &length, log.data());
  log.resize(std::size_t(std::max(length, 0)));
  return log;
}

// Mesa writes "0:LINE(COLUMN): error: words"; people look for "file:LINE: words".
std::string first_message(const std::string& file, const std::string& log) {
  std::string line = log.substr(0, log.find('\n'));
  if (line.rfind("0:", 0) != 0) return file + ": " + line;
  std::size_t end = 2;
  while (end < line.size() && std::isdigit(static_cast<unsigned char>(line[end])) != 0) ++end;
  const std::size_t words = line.find(": ", end);
  const std::string message = words == std::string::npos ? line : line.substr(words + 2);
  return file + ":" + line.substr(2, end - 2) + ": " + message;
}

GLuint compile(GLenum stage, const std::string& file, std::string_view text) {
  const GLuint shader = glCreateShader(stage);
  const char* begin = text.data();
  const auto length = static_cast<GLint>(text.size());
  glShaderSource(shader, 1, &begin, &length);
  glCompileShader(shader);
  GLint good = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good == GL_TRUE) return shader;
  const std::string message = first_message(file, compile_log(shader));
  glDeleteShader(shader);
  throw Error(1, message);
}

}  // namespace

Shader::Shader(std::string_view name)
    : Shader(name, shader_text(std::string(name) + ".vert"),
             shader_text(std::string(name) + ".frag")) {}

Shader::Shader(std::string_view name, std::string_view vertex_text, std::string_view fragment_text)
    : name_(name) {
  const GLuint vertex = compile(GL_VERTEX_SHADER, "shaders/" + name_ + ".vert", vertex_text);
  GLuint fragment = 0;
  try {
    fragment = compile(GL_FRAGMENT_SHADER, "shaders/" + name_ + ".frag", fragment_text);
  } catch (...) {
    glDeleteShader(vertex);
    throw;
  }
  program_ = glCreateProgram();
  glAttachShader(program_, vertex);
  glAttachShader(program_, fragment);
  glLinkProgram(program_);
  glDeleteShader(vertex);
  glDeleteShader(fragment);
  GLint good = GL_FALSE;
  glGetProgramiv(program_, GL_LINK_STATUS, &good);
  if (good == GL_TRUE) return;
  const std::string log = link_log(program_);
  glDeleteProgram(program_);
  throw Error(1,
              "shaders/" + name_ + ".vert and .frag do not fit: " + log.substr(0, log.find('\n')));
}

Shader::~Shader() { glDeleteProgram(program_); }

void Shader::use() const { glUseProgram(program_); }

int Shader::location(const char* uniform) const {
  const GLint found = glGetUniformLocation(program_, uniform);
  if (found < 0) throw InvalidInput("shaders/" + name_ + " has no uniform '" + uniform + "'");
  return found;
}

void Shader::set(const char* uniform, const Eigen::Matrix4f& value) const {
  glProgramUniformMatrix4fv(program_, location(uniform), 1, GL_FALSE, value.data());
}

void Shader::set(const char* uniform, const Eigen::Matrix3f& value) const {
  glProgramUniformMatrix3fv(program_, location(uniform), 1, GL_FALSE, value.data());
}

void Shader::set(const char* uniform, const Eigen::Vector2f& value) const {
  glProgramUniform2fv(program_, location(uniform), 1, value.data());
}

void Shader::set(const char* uniform, float value) const {
  glProgramUniform1f(program_, location(uniform), value);
}

}  // namespace regarment
