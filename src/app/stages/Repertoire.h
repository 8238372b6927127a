// What a model can do by itself: the animations and joints of its rig that have the names of Actions.inc and of an animal's head.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "app/tools/Actions.h"
#include "scene/Rig.h"

namespace fur::app {

struct Repertoire {
  struct Clip {
    int animation = -1;  // of the rig; -1: it has none
    float duration = 0;  // s
    float peak = 0;      // s, where it is furthest from how the model rests
    bool there() const { return animation >= 0; }
  };
  std::array<Clip, kActionCount> actions{};
  std::array<Clip, kGestureCount> gestures{};
  int neck = -1, head = -1;  // nodes of the rig
  std::array<int, 2> eyes{-1, -1};
  // Of each vertex of the rig's mesh, whether the head holds it or what hangs on that, and on which side. Empty unless it behaves.
  enum class Part : std::uint8_t { Body, HeadLeft, HeadRight };
  std::vector<Part> parts;

  const Clip& of(Action action) const { return actions[static_cast<std::size_t>(action)]; }
  const Clip& of(Gesture gesture) const { return gestures[static_cast<std::size_t>(gesture)]; }
  // It stands, breathes and has a head. Whatever else a file has is played as it says (setting `animation`).
  bool behaves() const { return of(Action::Stand).there() && of(Gesture::Breathe).there() && head >= 0; }
  // Of its actions, a line each.
  std::string names() const;
};

Repertoire repertoireOf(const scene::Rig& rig);

}  // namespace fur::app
