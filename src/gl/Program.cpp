#include <algorithm>

#include "gl/Api.h"
#include "gl/Objects.h"

namespace fur::gl {

namespace {

constexpr unsigned kCompletionStatus = 0x91B1;  // GL_COMPLETION_STATUS_KHR

bool linksTold = false;

std::string infoLog(unsigned id, bool program) {
  int length = 0;
  program ? glGetProgramiv(id, GL_INFO_LOG_LENGTH, &length) : glGetShaderiv(id, GL_INFO_LOG_LENGTH, &length);
  std::string text(static_cast<std::size_t>(std::max(length, 1)), '\0');
  program ? glGetProgramInfoLog(id, length, nullptr, text.data()) : glGetShaderInfoLog(id, length, nullptr, text.data());
  while (!text.empty() && (text.back() == '\0' || text.back() == '\n')) text.pop_back();
  return text;
}

Name compile(unsigned stage, std::string_view defines, std::string_view source) {
  Name name(glCreateShader(stage), [](unsigned id) { glDeleteShader(id); });
  constexpr std::string_view kVersion = "#version 300 es\n";
  const char* const texts[] = {kVersion.data(), defines.data(), source.data()};
  const int lengths[] = {static_cast<int>(kVersion.size()), static_cast<int>(defines.size()), static_cast<int>(source.size())};
  glShaderSource(name.id(), 3, texts, lengths);
  glCompileShader(name.id());
  return name;
}

bool compiled(const Name& shader) {
  int status = 0;
  glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &status);
  return status != 0;
}

}  // namespace

void setLinksTold(bool told) { linksTold = told; }

Result<Program> Program::link(const char* label, std::string_view vertex, std::string_view fragment,
                              std::string_view defines) {
  Program program = begin(label, vertex, fragment, defines);
  if (Status status = program.finish(); !status) return status.error();
  return program;
}

Program Program::begin(const char* label, std::string_view vertex, std::string_view fragment, std::string_view defines) {
  Program program;
  program.label_ = label;
  program.vertex_ = compile(GL_VERTEX_SHADER, defines, vertex);
  program.fragment_ = compile(GL_FRAGMENT_SHADER, defines, fragment);
  program.name_ = Name(glCreateProgram(), [](unsigned id) { glDeleteProgram(id); });
  const unsigned id = program.name_.id();
  glAttachShader(id, program.vertex_.id());
  glAttachShader(id, program.fragment_.id());
  glLinkProgram(id);
  return program;
}

bool Program::linked() const {
  int done = 1;
  if (linksTold) glGetProgramiv(name_.id(), kCompletionStatus, &done);
  return done != 0;
}

// Asks for nothing but the link: each question waits for the driver.
Status Program::finish() {
  const Name vertex = std::move(vertex_), fragment = std::move(fragment_);
  int linked = 0;
  glGetProgramiv(name_.id(), GL_LINK_STATUS, &linked);
  if (linked) return Done{};
  const auto refused = [&](const char* stage, const std::string& log) {
    return Error{ErrorId::WebglUnavailable, std::string(label_) + stage + ": " + log};
  };
  if (!compiled(vertex)) return refused(".vert", infoLog(vertex.id(), false));
  if (!compiled(fragment)) return refused(".frag", infoLog(fragment.id(), false));
  return refused("", infoLog(name_.id(), true));
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

int Program::offsetInBlock(const char* member) const {
  unsigned index = GL_INVALID_INDEX;
  int offset = -1;
  glGetUniformIndices(name_.id(), 1, &member, &index);
  if (index != GL_INVALID_INDEX) glGetActiveUniformsiv(name_.id(), 1, &index, GL_UNIFORM_OFFSET, &offset);
  return offset;
}

void Program::use() const { glUseProgram(name_.id()); }

}  // namespace fur::gl
