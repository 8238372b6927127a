// What an animal does. Actions.inc is the only place that lists it.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace fur::app {

enum class Action {
#define FUR_ACTION(id, ...) id,
#define FUR_GESTURE(...)
#include "app/tools/Actions.inc"
#undef FUR_ACTION
#undef FUR_GESTURE
};
enum class Gesture {
#define FUR_ACTION(...)
#define FUR_GESTURE(id, ...) id,
#include "app/tools/Actions.inc"
#undef FUR_ACTION
#undef FUR_GESTURE
};
inline constexpr std::size_t kActionCount = 0
#define FUR_ACTION(...) +1
#define FUR_GESTURE(...)
#include "app/tools/Actions.inc"
#undef FUR_ACTION
#undef FUR_GESTURE
    ;
inline constexpr std::size_t kGestureCount = 0
#define FUR_ACTION(...)
#define FUR_GESTURE(...) +1
#include "app/tools/Actions.inc"
#undef FUR_ACTION
#undef FUR_GESTURE
    ;

// Rests: what it comes back to. Stays: over and over for a while. Once: to its end.
enum class Manner { Rests, Stays, Once };

struct ActionTraits {
  const char* name;
  Manner manner;
  float least, most;  // s
  float fade;         // s
  float looks, chance;
};
const ActionTraits& traitsOf(Action action);
const char* nameOf(Gesture gesture);
// One that is none of them gives none.
std::optional<Action> actionNamed(std::string_view name);

}  // namespace fur::app
