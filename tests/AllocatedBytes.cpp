#include "AllocatedBytes.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> allocated{0};

void* counted(std::size_t size) noexcept {
  allocated += size;
  return std::malloc(size ? size : 1);
}

void* countedOrThrow(std::size_t size) {
  void* const memory = counted(size);
#ifdef __cpp_exceptions
  if (!memory) throw std::bad_alloc();
#else
  if (!memory) std::abort();
#endif
  return memory;
}

}  // namespace

std::size_t fur::allocatedBytes() { return allocated; }

// All of them, so that the sanitizers see each pair together.
void* operator new(std::size_t size) { return countedOrThrow(size); }
void* operator new[](std::size_t size) { return countedOrThrow(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return counted(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
