#include "app/tools/Actions.h"

#include "app/tools/RowNamed.h"

namespace fur::app {

namespace {

constexpr ActionTraits kActions[] = {
#define FUR_ACTION(id, name, manner, least, most, fade, looks, chance, ...) {name, Manner::manner, least, most, fade, looks, chance},
#define FUR_GESTURE(...)
#include "app/tools/Actions.inc"
#undef FUR_ACTION
#undef FUR_GESTURE
};

constexpr const char* kGestures[] = {
#define FUR_ACTION(...)
#define FUR_GESTURE(id, name, ...) name,
#include "app/tools/Actions.inc"
#undef FUR_ACTION
#undef FUR_GESTURE
};

}  // namespace

const ActionTraits& traitsOf(Action action) { return kActions[static_cast<std::size_t>(action)]; }
const char* nameOf(Gesture gesture) { return kGestures[static_cast<std::size_t>(gesture)]; }
std::optional<Action> actionNamed(std::string_view name) { return rowNamed<Action>(kActions, name); }

}  // namespace fur::app
