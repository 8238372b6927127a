#include "editor/Frequent.h"

#include <algorithm>

namespace fur::editor {

namespace {
constexpr std::string_view kWord = "frequent ";
}

void Frequent::reset() {
  names_.clear();
  for (const settings::Field& field : settings::fields())
    if (field.has(settings::kFrequent)) names_.insert(field.name);
}

void Frequent::toggle(const settings::Field& field) {
  if (names_.erase(field.name) == 0) names_.insert(field.name);
}

bool Frequent::isStandard() const {
  const auto& all = settings::fields();
  return std::all_of(all.begin(), all.end(), [this](const settings::Field& field) { return has(field) == field.has(settings::kFrequent); });
}

std::string Frequent::text() const {
  if (isStandard()) return "";
  std::string text(kWord);
  for (const std::string& name : names_) text += (text.size() > kWord.size() ? "," : "") + name;
  return text;
}

void Frequent::read(std::string_view text) {
  const std::size_t word = text.find(kWord);
  if (word == std::string_view::npos) return reset();
  names_.clear();
  text.remove_prefix(word + kWord.size());
  text = text.substr(0, text.find(' '));
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(','), text.size());
    if (const settings::Field* field = settings::findField(text.substr(0, end))) names_.insert(field->name);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

}  // namespace fur::editor
