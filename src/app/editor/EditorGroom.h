// The brushes that only programs with an editor have, for App::groomWith().
#pragma once

#include "app/App.h"

namespace fur::app {

extern const App::EditorGroom kEditorGroom;

}  // namespace fur::app
