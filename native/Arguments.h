// The command line of the programs without a window: a model, and options with a value each.
#pragma once

#include <string>

namespace fur::native {

// Reads `values` into `options`, whose `model` is the last word that is no option; `readOption(name, value, options)`
// takes the rest and says what is wrong with it. "" when nothing is.
template <class Options, class ReadOption>
std::string readArguments(int count, char** values, Options& options, ReadOption readOption) {
  for (int i = 1; i < count; ++i) {
    const std::string word = values[i];
    if (word.empty() || word[0] != '-') {
      options.model = word;
      continue;
    }
    if (i + 1 == count) return word + ": a value is missing";
    if (const std::string wrong = readOption(word, values[++i], options); !wrong.empty()) return wrong;
  }
  return "";
}

}  // namespace fur::native
