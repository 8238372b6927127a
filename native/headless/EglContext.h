// An OpenGL ES 3.0 context without a window (EGL surfaceless).
#pragma once

#include "core/Result.h"

namespace fur::native {

class EglContext {
 public:
  // Made current on this thread until destroyed.
  static Result<EglContext> create();
  EglContext(EglContext&& other) noexcept;
  EglContext& operator=(EglContext&&) = delete;
  ~EglContext();

 private:
  EglContext(void* display, void* context) : display_(display), context_(context) {}
  void* display_ = nullptr;
  void* context_ = nullptr;
};

}  // namespace fur::native
