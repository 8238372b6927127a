// Looks up tables whose rows have a `name`, in the order of an enum.
#pragma once

#include <iterator>
#include <optional>
#include <string_view>

namespace fur::app {

// None: no row has that name.
template <class Id, class Rows>
std::optional<Id> rowNamed(const Rows& rows, std::string_view name) {
  for (std::size_t i = 0; i < std::size(rows); ++i)
    if (name == rows[i].name) return static_cast<Id>(i);
  return std::nullopt;
}

}  // namespace fur::app
