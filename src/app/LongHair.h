// Long hair for programs that have it: to be called before the first App is made.
#pragma once

namespace fur::app {

// From then on apps grow hair, and models are read with theirs. Without it a model that has hair is an error, larger-program, and
// other programs are asked.
void growLongHair();

}  // namespace fur::app
