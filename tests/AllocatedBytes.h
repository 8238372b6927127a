// What a reader takes of memory, counted: a file of a few bytes must not ask for gigabytes, and none for what it does
// not use.
#pragma once

#include <cstddef>

namespace fur {

// All bytes that this program has asked operator new for so far, given back or not.
std::size_t allocatedBytes();

}  // namespace fur
