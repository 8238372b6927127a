#include <algorithm>

#include "gl/Api.h"
#include "gl/Objects.h"

namespace fur::gl {

namespace {

std::string infoLog(unsigned id, bool program) {
  int length = 0;
  program ? glGetProgramiv(id, GL_INFO_LOG_LENGTH, &length) : glGetShaderiv(id, GL_INFO_LOG_LENGTH, &length);
  std::string text(static_cast<std::size_t>(std::max(length, 1)), '\0');
  program ? glGetProgramInfoLog(id, length, nullptr, text.data()) : glGetShaderInfoLog(id, length, nullptr, text.data());
  while (!text.empty() && (text.back() == '\0' || text.back() == '\n')) text.pop_back();
  return text;
}

Result<Name> compile(const char* label, GLenum stage, const std::string& source) {
  Name name(glCreateShader(stage), [](unsigned id) { glDeleteShader(id); });
  const char* text = source.c_str();
  glShaderSource(name.id(), 1, &text, nullptr);
  glCompileShader(name.id());
  int compiled = 0;
  glGetShaderiv(name.id(), GL_COMPILE_STATUS, &compiled);
  if (compiled) return name;
  return Error{ErrorId::WebglUnavailable, std::string(label) + (stage == GL_VERTEX_SHADER ? ".vert: " : ".frag: ") +
                                              infoLog(name.id(), false)};
}

}  // namespace

Result<Program> Program::link(const char* label, std::string_view vertex, std::string_view fragment,
                              std::string_view defines) {
  const std::string head = "#version 300 es\n" + std::string(defines);
  auto vertexShader = compile(label, GL_VERTEX_SHADER, head + std::string(vertex));
  if (!vertexShader) return vertexShader.error();
  auto fragmentShader = compile(label, GL_FRAGMENT_SHADER, head + std::string(fragment));
  if (!fragmentShader) return fragmentShader.error();
  Program program;
  program.name_ = Name(glCreateProgram(), [](unsigned id) { glDeleteProgram(id); });
  const unsigned id = program.name_.id();
  glAttachShader(id, vertexShader->id());
  glAttachShader(id, fragmentShader->id());
  glLinkProgram(id);
  int linked = 0;
  glGetProgramiv(id, GL_LINK_STATUS, &linked);
  if (!linked) return Error{ErrorId::WebglUnavailable, std::string(label) + ": " + infoLog(id, true)};
  return program;
}

void Program::bindBlock(const char* name, unsigned binding) const {
  const unsigned index = glGetUniformBlockIndex(name_.id(), name);
  if (index != GL_INVALID_INDEX) glUniformBlockBinding(name_.id(), index, binding);
}

void Program::bindSampler(const char* name, int unit) const {
  const int location = glGetUniformLocation(name_.id(), name);
  if (location < 0) return;
  glUseProgram(name_.id());
  glUniform1i(location, unit);
}

int Program::blockSize(const char* name) const {
  const unsigned index = glGetUniformBlockIndex(name_.id(), name);
  int size = 0;
  if (index != GL_INVALID_INDEX) glGetActiveUniformBlockiv(name_.id(), index, GL_UNIFORM_BLOCK_DATA_SIZE, &size);
  return size;
}

void Program::use() const { glUseProgram(name_.id()); }

}  // namespace fur::gl
