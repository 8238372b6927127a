// What the panel shows of an App, but for pictures and what only its host knows.
#pragma once

#include "app/App.h"
#include "editor/EditorModel.h"

namespace fur::app {

editor::EditorModel describe(const App& app);

}  // namespace fur::app
