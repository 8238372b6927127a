// The one place that knows where the OpenGL ES 3.0 entry points come from.
#pragma once

#include <GLES3/gl3.h>
