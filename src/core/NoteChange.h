// For what is made of something that has a revision: whether it has to be made anew.
#pragma once

#include <utility>

namespace fur {

// Sets `last` to `now`; whether it was another value.
template <class T>
bool noteChange(T& last, T now) {
  const bool changed = last != now;
  last = std::move(now);
  return changed;
}

}  // namespace fur
