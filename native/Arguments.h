// The command line of the native programs: a model, and options with a value each; what they say of it, and their exit status.
#pragma once

#include <algorithm>
#include <cstdio>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "core/Result.h"
#include "scene/Formats.h"

namespace fur::native {

inline bool asksForHelp(int count, char** values) {
  for (int i = 1; i < count; ++i)
    if (const std::string_view word = values[i]; word == "--help" || word == "-h") return true;
  return false;
}
// With the endings of scene/Formats.inc for {models} and {coats}.
inline int showHelp(std::string usage) {
  const std::pair<std::string_view, std::string> words[] = {{"{models}", scene::endingsOf(scene::FileKind::Model, " or ")},
                                                            {"{coats}", scene::endingsOf(scene::FileKind::Coat, " or ")}};
  for (const auto& [word, endings] : words)
    for (std::size_t at; (at = usage.find(word)) != std::string::npos;) usage.replace(at, word.size(), endings);
  std::fputs(usage.c_str(), stdout);
  return 0;
}
// Of arguments that cannot be read.
inline int refuse(const std::string& wrong) {
  std::fprintf(stderr, "%s\n--help lists the options\n", wrong.c_str());
  return 2;
}
inline int fail(const Error& error) {
  std::fprintf(stderr, "%s\n", error.message.c_str());
  return 1;
}

// Reads `values` into `options`, whose `model` is the last word that is no option; `readOption(name, value, options)`
// takes the rest, as `--name value` and `--name=value`, and says what is wrong with it; `flags` have no value. "" when nothing is.
template <class Options, class ReadOption>
std::string readArguments(int count, char** values, Options& options, ReadOption readOption,
                          std::initializer_list<std::string_view> flags = {}) {
  for (int i = 1; i < count; ++i) {
    const std::string word = values[i];
    if (word.empty() || word[0] != '-') {
      options.model = word;
      continue;
    }
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const bool joined = equals != std::string::npos, flag = std::find(flags.begin(), flags.end(), name) != flags.end();
    if (flag && joined) return name + ": it takes no value";
    if (!flag && !joined && i + 1 == count) return name + ": a value is missing";
    const std::string value = flag ? "" : joined ? word.substr(equals + 1) : values[++i];
    if (const std::string wrong = readOption(name, value, options); !wrong.empty()) return wrong;
  }
  return "";
}

}  // namespace fur::native
