#include "app/editor/EditorHost.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <variant>

#include <imgui.h>
#include <imgui_impl_opengl3.h>
#include <imgui_internal.h>  // the pointer's shape

#include "app/view/OrbitCamera.h"
#include "groom/MapPictures.h"
#include "app/editor/EditorGroom.h"
#include "app/editor/Lettering.h"
#include "app/editor/PanelModel.h"
#include "core/Fnv1a.h"
#include "scene/Formats.h"
#include "settings/FurTypes.h"
#include "settings/Presets.h"

namespace fur::app {

namespace {

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

// "rabbit.fts"; a coat that is no preset's is "coat.fts".
std::string typeSetName(const App& app, int type) {
  const settings::Preset* preset = settings::presetOf(settings::typeCoat(app.settings(), type));
  return std::string(preset ? preset->name : "coat").append(scene::endingOf(scene::Format::Fts));
}

// The model's name without its ending.
std::string stemOf(const App& app) { return app.modelName().substr(0, app.modelName().rfind('.')); }

std::string modelFileName(const App& app, scene::Format format) { return stemOf(app).append(scene::endingOf(format)); }

}  // namespace

const char* PlatformCommand::name() const {
  static constexpr const char* kNames[] = {
#define FUR_PLATFORM_COMMAND(id, ...) #id,
#include "app/editor/PlatformCommands.inc"
#undef FUR_PLATFORM_COMMAND
  };
  return kNames[static_cast<std::size_t>(kind)];
}

struct EditorHost::Context {
  explicit Context(const EditorHost& host) : before(ImGui::GetCurrentContext()) {
    ImGui::SetCurrentContext(host.context_);
  }
  ~Context() { ImGui::SetCurrentContext(before); }
  ImGuiContext* before;
};

EditorHost::EditorHost(App& app, editor::FileAccess fileAccess)
    : app_(app), context_(ImGui::CreateContext()), fileAccess_(fileAccess) {
  GroomStage::setEditorBrushes(&kEditorGroom);
  const Context current(*this);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  // A blinking cursor would keep the whole picture drawing.
  io.ConfigInputTextCursorBlink = false;
  io.ClipboardUserData = this;
  io.SetClipboardTextFn = [](void* self, const char* text) {
    auto& host = *static_cast<EditorHost*>(self);
    host.clipboard_ = text;
    if (host.writeClipboard_)
      host.writeClipboard_(text);
    else
      host.request(PlatformCommand::Kind::CopyText, text);
  };
  io.GetClipboardTextFn = [](void* self) {
    auto& host = *static_cast<EditorHost*>(self);
    if (host.readClipboard_) host.clipboard_ = host.readClipboard_();
    return host.clipboard_.c_str();
  };
  editor::InputQueue::mapKeys(io);
}

EditorHost::~EditorHost() {
  detach();
  ImGui::DestroyContext(context_);
}

Status EditorHost::attach() {
  const Context current(*this);
  if (!ImGui_ImplOpenGL3_Init()) return Error{ErrorId::WebglUnavailable, "Dear ImGui found no OpenGL ES 3.0"};
  attached_ = true;
  mostPictureSide_ = mostPictureSide();
  pictures_.showVersions();
  drawnHash_ = 0;
  justAttached_ = true;
  wake();
  return Done{};
}

void EditorHost::detach() {
  if (!attached_) return;
  attached_ = false;
  const Context current(*this);
  if (editor_.changing()) app_.endChange();
  if (studio_.busy()) message("The picture was given up: what it was drawn with went", true);
  studio_.end();
  app_.setCovered(Vec2(0));
  pictures_.release();
  // Where a context can be lost, in WebGL, deleting what it held is allowed and does nothing.
  ImGui_ImplOpenGL3_Shutdown();
}

void EditorHost::resize(int width, int height, float pixelRatio) {
  size_ = Vec2(width, height);
  scale_.pixelRatio = pixelRatio;
  wake();
}

void EditorHost::setLayout(std::string_view text) {
  editor_.setLayout(text);
  wake();
}

const char* EditorHost::cursor() const {
  switch (context_->MouseCursor) {
    case ImGuiMouseCursor_TextInput:
      return "text";
    case ImGuiMouseCursor_ResizeEW:
      return "ew-resize";
    case ImGuiMouseCursor_ResizeNS:
      return "ns-resize";
    case ImGuiMouseCursor_Hand:
      return "pointer";
    default:
      return "default";
  }
}

editor::EditorModel EditorHost::model() {
  editor::EditorModel model = describe(app_);
  model.fileAccess = fileAccess_;
  model.messages = messages_;
  model.frameSeconds = frameSeconds_;
  model.picture = {static_cast<int>(size_.x), static_cast<int>(size_.y), kLeastPictureSide, mostPictureSide_,
                   studio_.busy(), studio_.busy() ? studio_.progress() : 0, turnLeft_ > 0};
  model.groom.selects = selects_;
  modes_.describe(model.groom);
  if (!askedPictures_.empty()) model.pictureAsked = askedPictures_.front().substr(askedPictures_.front().find_last_of("/\\") + 1);
  model.ownCoats = ownCoats_;
  pictures_.describe(model);
  return model;
}

bool EditorHost::update(float dt) {
  if (!attached_ || size_.x <= 0 || size_.y <= 0) return false;
  const Context current(*this);
  turn(dt);
  // Not while a finger is down: what it is about to press must not move away.
  if (owner_ == Owner::None && input_.empty()) scale_.touch = input_.lastKind() == editor::PointerKind::Touch;
  if (editor::applyTheme(scale_)) {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
  }
  ImGui_ImplOpenGL3_NewFrame();
  frameTime_ = dt;
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = ImVec2(size_.x, size_.y);
  io.DeltaTime = std::max(dt, 1e-4f);  // ImGui insists on time going by
  // An event may have waited in the queue: the frames count from when ImGui sees it.
  if (!input_.empty()) wake();
  if (framesLeft_ > 0) --framesLeft_;
  input_.feed(io);
  pictures_.refresh(editor_);
  const bool groomShown = editor_.showsGroom();
  const std::optional<editor::TileView> pictured = editor_.shownTile();
  ImGui::NewFrame();
  const std::vector<editor::Command> commands = editor_.frame(model(), scale_);
  drawRing();
  modes_.draw(scale_.pixelRatio);
  ImGui::Render();
  if (editor_.shownTile() != pictured || editor_.showsGroom() != groomShown) wake();
  for (const editor::Command& command : commands) perform(command);
  app_.setCovered(editor_.covered(), justAttached_);
  justAttached_ = false;
  if (!commands.empty()) wake();
  shownHash_ = pictureHash();
  return shownHash_ != drawnHash_;
}

void EditorHost::draw() {
  if (!attached_) return;
  const Context current(*this);
  if (ImDrawData* data = ImGui::GetDrawData()) ImGui_ImplOpenGL3_RenderDrawData(data);
  drawnHash_ = shownHash_;
  frameSeconds_.push_back(frameTime_);
  if (frameSeconds_.size() > kFrameHistory) frameSeconds_.erase(frameSeconds_.begin());
}

bool EditorHost::active() const {
  return framesLeft_ > 0 || !input_.empty() || studio_.busy() || turnLeft_ > 0 ||
         (scale_.touch && owner_ == Owner::Panel);  // a finger that is held opens a menu
}

std::uint64_t EditorHost::pictureHash() const {
  Fnv1a hash;
  const ImDrawData* data = ImGui::GetDrawData();
  for (int i = 0; data && i < data->CmdListsCount; ++i) {
    const ImDrawList& list = *data->CmdLists[i];
    hash.addBytes(list.VtxBuffer.Data, static_cast<std::size_t>(list.VtxBuffer.size_in_bytes()));
    hash.addBytes(list.IdxBuffer.Data, static_cast<std::size_t>(list.IdxBuffer.size_in_bytes()));
    for (const ImDrawCmd& command : list.CmdBuffer) {
      hash.add(command.ClipRect);
      hash.add(command.TextureId);
    }
  }
  hash.add(pictures_.revision());
  return hash.value();
}

// Where the tool would reach from the pointer.
void EditorHost::drawRing() {
  const ImVec2 at = ImGui::GetIO().MousePos;
  const bool elsewhere = scale_.touch || !ImGui::IsMousePosValid() || covers({at.x, at.y});
  app_.hover(elsewhere ? std::nullopt : std::optional(Vec2(at.x, at.y)));
  if (!scale_.touch && owner_ != Owner::Modes) modes_.hover(elsewhere ? std::nullopt : std::optional(Vec2(at.x, at.y)));
  if (elsewhere) return;
  const auto draw = [&](bool ofMirror, int opacity) {
    std::vector<ImVec2> ring;
    for (const Vec2& point : app_.brushRing({at.x, at.y}, ofMirror)) ring.emplace_back(point.x, point.y);
    if (ring.empty()) return;
    ImGui::GetBackgroundDrawList()->AddPolyline(ring.data(), static_cast<int>(ring.size()), IM_COL32(255, 255, 255, opacity),
                                                ImDrawFlags_Closed, 1.5f * scale_.pixelRatio);
  };
  draw(false, 204);
  draw(true, 102);  // it may lie behind the model
}

// --- pictures ---

void EditorHost::begin(const PictureOrder& order, PlatformCommand::Kind kind, std::string name) {
  stopTurning();
  const Status begun = studio_.begin(order);
  check(begun);
  if (begun) request(kind, std::move(name));
}

std::optional<Studio::Band> EditorHost::nextBand() {
  if (!studio_.busy()) return {};
  auto band = studio_.next();
  if (band) return std::move(*band);
  message(band.error().message, true);
  return {};
}

void EditorHost::setVersions(std::vector<Version> versions) {
  pictures_.setVersions(std::move(versions));
  if (attached_) pictures_.showVersions();
  wake();
}

void EditorHost::setOwnCoats(std::vector<OwnCoat> coats) {
  ownCoats_ = std::move(coats);
  std::sort(ownCoats_.begin(), ownCoats_.end(), [](const auto& a, const auto& b) { return std::tie(a.name, a.id) < std::tie(b.name, b.id); });
  wake();
}

// Live, as the platform's own time goes by.
void EditorHost::turn(float dt) {
  if (turnLeft_ <= 0) return;
  const float step = std::min(dt, turnLeft_);
  turnLeft_ -= step;
  CameraOrbit orbit = app_.camera();
  orbit.yaw = turnLeft_ > 0 ? orbit.yaw + OrbitCamera::turned(step, secondsPerTurn_) : turnStart_.yaw;
  app_.setCamera(orbit);
}

void EditorHost::check(const Status& status) {
  if (!status) message(status.error().message, true);
}

void EditorHost::perform(const editor::Command& command) {
  using namespace editor::command;
  using Kind = PlatformCommand::Kind;
  const Overloaded actions{
      [&](const BeginChange&) { app_.beginChange(); },
      [&](const EndChange&) { app_.endChange(); },
      [&](const SetSettings& c) { app_.setSettings(c.settings); },
      [&](const SetTool& c) { app_.setTool(c.tool); },
      [&](const SetWetness& c) { app_.setWetness(c.amount); },
      [&](const Shake&) { app_.shake(); },
      [&](const Stamp& c) { stampLetters(app_, c.text, size_ * (Vec2(1) - editor_.covered())); },
      [&](const LoadShipped& shipped) { request(Kind::LoadShipped, shipped.name); },
      [&](const OpenDialog&) { request(Kind::OpenDialog); },
      [&](const OpenPath& c) { request(Kind::OpenPath, c.path); },
      [&](const ResetCamera&) { app_.resetCamera(); },
      [&](const Undo&) { app_.undo(); },
      [&](const Redo&) { app_.redo(); },
      [&](const CopyState&) { request(Kind::CopyText, app_.state()); },
      [&](const PasteState&) { request(Kind::PasteRequest); },
      [&](const ApplyPreset& c) { app_.applyPreset(c.name, c.type); },
      [&](const KeepCoat& c) { request(Kind::KeepCoat, c.name); },
      [&](const WearCoat& c) { request(Kind::WearCoat, c.id); },
      [&](const SaveOwnCoat& c) { request(Kind::SaveOwnCoat, c.id); },
      [&](const RenameCoat& c) { request(Kind::RenameCoat, c.id + '\n' + c.name); },
      [&](const DeleteCoat& c) { request(Kind::DeleteCoat, c.id); },
      [&](const SaveTypeSet&) { request(Kind::SaveTypeSet, typeSetName(app_, coatType())); },
      [&](const SaveFo&) { request(Kind::SaveFo, modelFileName(app_, scene::Format::Fo)); },
      [&](const SaveHair&) { request(Kind::SaveHair, modelFileName(app_, scene::Format::Hair)); },
      [&](const SaveScene&) { request(Kind::SaveScene, modelFileName(app_, scene::Format::Glb)); },
      [&](const SaveMaps&) { request(Kind::SaveMaps, app_.mapsName() + "-maps"); },
      [&](const SelectAt& c) {
        selects_ = c.what;
        bodyRadius_ = c.radius;
      },
      [&](const SetBody& c) { app_.setBody(c.index, c.body); },
      [&](const GroomAll& c) { app_.groomAll(c.edit, c.value, c.direction); },
      [&](const SetPoint& c) { modes_.set(c); },
      [&](const SetWhisker& c) { modes_.set(c.whisker); },
      [&](const RemoveWhisker&) { modes_.removeWhisker(); },
      [&](const ChooseWhisker& c) { modes_.chooseWhisker(c.step); },
      [&](const SetFurry& c) { (void)app_.setFurry(c.material, c.furry); },
      [&](const UsePicture& c) {
        if (askedPictures_.empty()) return;
        if (c.use) request(Kind::UsePicture, std::string(rowOf(*c.use).name) + '\n' + askedPictures_.front());
        askedPictures_.pop_front();
      },
      [&](const Act& c) { app_.act(c.action); },
      [&](const EditHair& c) { app_.editHair(c.edit, c.value, c.direction); },
      [&](const SetHairValues& c) { app_.setHairValues(c.scalp, c.values); },
      [&](const RenameScalp& c) { (void)app_.setHairValue(static_cast<int>(c.scalp), "name", c.name); },
      [&](const SavePicture& c) { begin({.width = c.width, .height = c.height, .transparent = c.transparent, .samples = app_.savedSamples()}, Kind::SavePicture, modelFileName(app_, scene::Format::Png)); },
      [&](const SaveTurntable& c) {
        // Films have even sides.
        begin({c.width / 2 * 2, c.height / 2 * 2, c.transparent, turntableFrames(c.secondsPerTurn), c.secondsPerTurn}, Kind::SaveTurntable,
              stemOf(app_) + "-turn");
      },
      [&](const TurnOnce& c) {
        turnStart_ = app_.camera();
        secondsPerTurn_ = c.secondsPerTurn;
        turnLeft_ = std::abs(c.secondsPerTurn);
      },
      [&](const StopPicture&) {
        stopTurning();
        studio_.end();
      },
      [&](const KeepVersion& c) { request(Kind::KeepVersion, c.name); },
      [&](const OpenVersion& c) { request(Kind::OpenVersion, c.id); },
      [&](const RenameVersion& c) { request(Kind::RenameVersion, c.id + '\n' + c.name); },
      [&](const DeleteVersion& c) { request(Kind::DeleteVersion, c.id); },
      [&](const DismissMessage& c) {
        messages_.erase(messages_.begin() + static_cast<std::ptrdiff_t>(c.index));
      },
  };
  std::visit(actions, command);
}

std::optional<PlatformCommand> EditorHost::takeCommand() {
  if (platform_.empty()) return {};
  PlatformCommand command = std::move(platform_.front());
  platform_.pop_front();
  return command;
}

void EditorHost::message(std::string text, bool isError) {
  // The same thing said again is no news.
  std::erase_if(messages_, [&](const editor::Message& old) { return old.text == text; });
  messages_.push_back({std::move(text), isError});
  if (messages_.size() > kMostMessages) messages_.erase(messages_.begin());
  wake();
}

void EditorHost::askPicture(std::string path) {
  // One that "Save maps" wrote says what it is.
  if (groom::mapOfFile(path)) return request(PlatformCommand::Kind::UsePicture, std::string(rowOf(PictureUse::Length).name) + '\n' + path);
  askedPictures_.push_back(std::move(path));
  wake();
}

void EditorHost::setClipboard(std::function<void(const char*)> write, std::function<std::string()> read) {
  writeClipboard_ = std::move(write);
  readClipboard_ = std::move(read);
}

}  // namespace fur::app
