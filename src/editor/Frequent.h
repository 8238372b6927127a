// Which settings stand in the section "Frequently used": those of the table, until a person adds or removes some.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "settings/Settings.h"

namespace fur::editor {

class Frequent {
 public:
  Frequent() { reset(); }
  bool has(const settings::Field& field) const { return names_.contains(field.name); }
  void toggle(const settings::Field& field);
  void reset();
  bool isStandard() const;
  bool empty() const { return names_.empty(); }

  // For the next time: "frequent curl,density"; "" for those of the table. Reading finds that anywhere in a text, leaves out
  // what is no field, and without it takes those of the table.
  std::string text() const;
  void read(std::string_view text);

 private:
  std::set<std::string, std::less<>> names_;
};

}  // namespace fur::editor
