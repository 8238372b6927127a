#include "app/editor/EditorGroom.h"

#include "groom/GroomFilters.h"

namespace fur::app {

namespace {

// Fur is thinned by a type that is bald; 0: all others grow something.
int baldType(const settings::Settings& settings) {
  const int types[] = {settings.type4, settings.type3, settings.type2};
  for (int i = 0; i < 3; ++i)
    if (types[i] == 0) return 4 - i;
  return 0;
}

void shape(groom::Groom& groom, const groom::GroomSurface& ground, const groom::Brush& brush, groom::ShapeChannel channel, bool erases) {
  erases ? groom::takeShape(groom, ground, brush, channel) : groom::addShape(groom, ground, brush, channel);
}

void dab(Tool tool, groom::Groom& groom, const groom::GroomSurface& ground, const groom::Brush& brush, const settings::Settings& settings) {
  const bool erases = settings.brushErases;
  switch (tool) {
    case Tool::Paint: erases ? groom::unpaint(groom, ground, brush) : groom::paint(groom, ground, brush, settings.paintColor); break;
    case Tool::Mask: erases ? groom::unprotect(groom, ground, brush) : groom::protect(groom, ground, brush); break;
    case Tool::Cut: groom::cutTo(groom, ground, brush, settings.cutLength); break;
    case Tool::Thin:
      if (const int type = baldType(settings)) erases ? groom::takeType(groom, ground, brush, type) : groom::paintType(groom, ground, brush, type);
      break;
    case Tool::Curl: shape(groom, ground, brush, groom::ShapeChannel::Curl, erases); break;
    case Tool::Frizz: shape(groom, ground, brush, groom::ShapeChannel::Frizz, erases); break;
    case Tool::Locks: shape(groom, ground, brush, groom::ShapeChannel::Locks, erases); break;
    default: break;
  }
}

}  // namespace

const GroomStage::EditorBrushes kEditorGroom{dab, groom::paintUnderMask};

}  // namespace fur::app
