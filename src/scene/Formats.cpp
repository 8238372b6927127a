#include "scene/Formats.h"

#include <vector>

namespace fur::scene {

namespace {

struct Row {
  FileKind kind;
  std::string_view endings, savedAs;
};
constexpr Row kRows[] = {
#define FUR_MODEL_FORMAT(id, endings, mime, savedAs, reader) {FileKind::Model, endings, savedAs},
#define FUR_FORMAT(id, kind, endings, mime, savedAs) {FileKind::kind, endings, savedAs},
#include "scene/Formats.inc"
#undef FUR_MODEL_FORMAT
#undef FUR_FORMAT
};

const Row& rowOf(Format format) { return kRows[static_cast<std::size_t>(format)]; }

std::vector<std::string_view> split(std::string_view endings) {
  std::vector<std::string_view> out;
  while (!endings.empty()) {
    const std::size_t end = endings.find(' ');
    out.push_back(endings.substr(0, end));
    endings = end == std::string_view::npos ? std::string_view() : endings.substr(end + 1);
  }
  return out;
}

char small(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool isEnding(std::string_view given, std::string_view ending) {
  if (given.size() != ending.size()) return false;
  for (std::size_t i = 0; i < given.size(); ++i)
    if (small(given[i]) != ending[i]) return false;
  return true;
}

}  // namespace

FileKind kindOf(Format format) { return rowOf(format).kind; }

std::string_view endingOf(Format format) { return split(rowOf(format).endings).front(); }

std::optional<Format> formatNamed(std::string_view fileName) {
  const std::size_t dot = fileName.rfind('.');
  if (dot == std::string_view::npos) return std::nullopt;
  for (std::size_t i = 0; i < kFormatCount; ++i)
    for (const std::string_view ending : split(kRows[i].endings))
      if (isEnding(fileName.substr(dot), ending)) return static_cast<Format>(i);
  return std::nullopt;
}

bool isNamedAs(FileKind kind, std::string_view fileName) {
  const auto format = formatNamed(fileName);
  return format && kindOf(*format) == kind;
}

std::string endingsOf(FileKind kind, std::string_view joint) {
  std::vector<std::string_view> all;
  for (const Row& row : kRows)
    for (const std::string_view ending : split(row.endings))
      if (row.kind == kind) all.push_back(ending);
  std::string out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0) out += i + 1 == all.size() ? joint : ", ";
    out += all[i];
  }
  return out;
}

std::string saveLabel(Format format) {
  return std::string("Save ").append(rowOf(format).savedAs).append(" (").append(endingOf(format)).append(")");
}

}  // namespace fur::scene
