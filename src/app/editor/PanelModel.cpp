#include "app/editor/PanelModel.h"

#include <algorithm>

namespace fur::app {

namespace {

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0, end; at < text.size(); at = end + 1) {
    end = text.find('\n', at);
    lines.push_back(text.substr(at, end - at));
  }
  return lines;
}

}  // namespace

editor::EditorModel describe(const App& app) {
  const App::Stats stats = app.stats();
  editor::EditorModel model;
  model.settings = app.settings();
  model.tool = app.tool();
  model.modelName = app.modelName();
  model.animations = linesOf(app.animations());
  model.actions = linesOf(app.actions());
  model.action = app.action();
  model.meanWetness = app.meanWetness();
  const wet::Accounts water = app.water().accounts();
  model.water = {water.painted + water.rained, water.held + water.hair, water.film, water.drops, water.dripped, water.evaporated + water.removed};
  model.canUndo = app.canUndo();
  model.canRedo = app.canRedo();
  model.lostBySaving = app.lostBySaving();
  model.vertices = stats.vertices;
  model.triangles = stats.triangles;
  model.strands = stats.strands;
  model.layers = stats.layers;
  model.finEdges = stats.finEdges;
  model.cpuBytes = stats.cpuBytes;
  model.gpuBytes = stats.gpuBytes;
  model.coat.progress = app.coatProgress();
  model.coat.revision = app.coatRevision();
  model.coat.coverage = app.coverageByHeight();
  for (int type = 0; type < settings::kFurTypes; ++type) {
    const auto index = static_cast<std::size_t>(type);
    model.typeGiven[index] = app.coatGiven(type);
    model.typePictured[index] = !app.typePicture(model.settings.typePictures[index]).bytes.empty();
  }
  model.skinPictured = !app.typePicture(model.settings.typePictures[settings::kSkin]).bytes.empty();
  model.groom.mapSize = app.groomMap().size();
  model.groom.whiskers = static_cast<int>(app.whiskerCount());
  model.groom.plain = !app.groomed();
  model.groom.painted = !app.groom().paint.isPlain();
  model.groom.masked = !app.groom().mask.isPlain();
  if (app.materialCount() > 1)
    for (int i = 0; i < app.materialCount(); ++i) model.materials.push_back({app.materialName(i), app.isFurry(i)});
  model.hair.selected = app.selectedScalp();
  model.hair.bodies = app.hairstyle().bodies;
  model.hair.selectedBody = app.selectedBody();
  model.hair.bones = app.hasBones();
  for (std::size_t i = 0; i < app.hairstyle().scalps.size(); ++i) {
    const hair::Scalp& scalp = app.hairstyle().scalps[i];
    const auto flagged = [&](hair::GuideFlag flag) {
      return static_cast<std::size_t>(std::count_if(scalp.guides.flags.begin(), scalp.guides.flags.end(), [=](std::uint8_t flags) { return (flags & flag) != 0; }));
    };
    model.hair.scalps.push_back({scalp.name, scalp.guides.count(), app.wispCount(i), flagged(hair::kStatic), flagged(hair::kHidden), scalp.values});
  }
  return model;
}

}  // namespace fur::app
