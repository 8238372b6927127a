// What the same seed or recording gives is to be the same natively and as wasm. Tests whose name ends in OnEveryPlatform print
// it, and tests/wasm/cpu.test.mjs compares what both programs have printed.
#pragma once

#include <cinttypes>
#include <cstdio>

namespace fur::test {

inline void printOnEveryPlatform(const char* what, std::uint64_t hash) { std::printf("on every platform: %s %016" PRIx64 "\n", what, hash); }

}  // namespace fur::test
