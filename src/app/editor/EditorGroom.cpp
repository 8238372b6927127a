#include "app/editor/EditorGroom.h"

#include "groom/GroomFilters.h"
#include "settings/Presets.h"

namespace fur::app {

namespace {

void shape(groom::Groom& groom, const groom::GroomSurface& skin, const groom::Brush& brush, groom::ShapeChannel channel, bool erases) {
  erases ? groom::takeShape(groom, skin, brush, channel) : groom::addShape(groom, skin, brush, channel);
}

void dab(Tool tool, groom::Groom& groom, const groom::GroomSurface& skin, const groom::Brush& brush, const settings::Settings& settings) {
  const bool erases = settings.brushErases;
  switch (tool) {
    case Tool::Paint: erases ? groom::unpaint(groom, skin, brush) : groom::paint(groom, skin, brush, settings.paintColor); break;
    case Tool::Mask: erases ? groom::unprotect(groom, skin, brush) : groom::protect(groom, skin, brush); break;
    case Tool::Cut: groom::cutTo(groom, skin, brush, settings.cutLength); break;
    case Tool::Thin:
      if (const int type = settings::baldType(settings)) erases ? groom::takeType(groom, skin, brush, type) : groom::paintType(groom, skin, brush, type);
      break;
    case Tool::Curl: shape(groom, skin, brush, groom::ShapeChannel::Curl, erases); break;
    case Tool::Frizz: shape(groom, skin, brush, groom::ShapeChannel::Frizz, erases); break;
    case Tool::Locks: shape(groom, skin, brush, groom::ShapeChannel::Locks, erases); break;
    default: break;
  }
}

}  // namespace

const GroomStage::EditorBrushes kEditorGroom{dab, groom::paintUnderMask};

}  // namespace fur::app
