// The brushes that only programs with an editor have, for GroomStage::setEditorBrushes().
#pragma once

#include "app/stages/GroomStage.h"

namespace fur::app {

extern const GroomStage::EditorBrushes kEditorGroom;

}  // namespace fur::app
