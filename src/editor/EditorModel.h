// What the panel shows, and what it asks for. The panel never changes anything itself: a model goes
// in, commands come out, and the next model shows what became of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <imgui.h>

#include "app/tools/FurAt.h"
#include "app/tools/GroomEdits.h"
#include "app/tools/HairEdits.h"
#include "app/tools/PictureUses.h"
#include "app/tools/Tools.h"
#include "core/Math.h"
#include "hair/Body.h"
#include "hair/HairValues.h"
#include "settings/Settings.h"

namespace fur::editor {

using app::FurNumber;
using app::GroomEdit;
using app::HairEdit;
using app::PictureUse;
using app::Tool;

// How a person can bring a file: through a dialog of the platform alone, or also by typing its path.
enum class FileAccess { Dialog, Path };

struct Message {
  std::string text;
  bool isError = false;
};

// In the order of furgen::TileChannel, which EditorHost checks.
enum class TileChannel { Coverage, Dominance, Variance, Tangent, Offset, Strand };
inline constexpr int kTileChannels = 6;

// One layer of the fur tile (0 = skin) in one channel.
struct TileView {
  int layer = 0;
  TileChannel channel = TileChannel::Coverage;
  bool operator==(const TileView&) const = default;
};

// The coat that is drawn, and how far the one is that the settings ask for.
struct CoatView {
  float progress = 1;               // 0..1
  std::uint64_t revision = 0;       // another one whenever another coat is drawn
  std::span<const float> coverage;  // share of each layer that strands cover, from the skin up
  // Pictures of what Editor::shownTile() asks for: the layer, and the fin map with its root in row 0. Null
  // until they are there.
  ImTextureID tile = nullptr, fin = nullptr;
  int tileSize = 0;  // texels
};

// What the next press on the model selects, or where it puts a collision shape.
enum class Selects { Nothing, Connected, Paint, Sphere, Capsule };

// How something leans away from the skin: by how much, and where to, from above: 0 up the model, then clockwise. Degrees.
struct LeanView {
  float lean = 0, heading = 0;
};
// The fur at one place.
struct PointView {
  float length = 1;               // share of the longest
  LeanView comb;
  float types[4] = {1, 0, 0, 0};  // shares
  float wetness = 0;              // 0..1
};
// A whisker; lengths in model units.
struct WhiskerView {
  float length = 0, width = 0, spread = 0, stiffness = 0;
  LeanView aim;
  int hairs = 1;
  std::uint32_t color = 0;  // 0xRRGGBB
};

// The groom of the model, shares of its surface as groom::Coverage has them.
struct GroomView {
  float bald = 0, length = 1;
  float types[4] = {1, 0, 0, 0};
  int mapSize = 256;
  int whiskers = 0;
  bool plain = true;           // nothing of it is anybody's work
  bool painted = false, masked = false;  // there is paint, there is a mask
  ImTextureID map = nullptr;   // a picture while Editor::showsGroom(); null until it is there
  std::span<const Vec4> outlines{};  // of the charts, over it: both ends, 0..1
  Selects selects = Selects::Nothing;
  std::optional<PointView> under{}, point{};  // what the pointer is at; what the tool Edit has chosen
  std::optional<WhiskerView> whisker{};       // that is chosen
};

// One of several materials of the model.
struct MaterialView {
  std::string name;
  bool furry = true;
};

// A scalp of the model's long hair.
struct ScalpView {
  std::string name;
  std::size_t guides = 0, wisps = 0, held = 0, hidden = 0;  // of its guides
  hair::HairValues values;
};
struct HairView {
  std::vector<ScalpView> scalps;
  std::size_t selected = 0;  // the one that tools work on
  std::vector<hair::Body> bodies;  // spheres and capsules that hair does not enter
  int selectedBody = -1;
  bool bones = false;              // the model has some
};

// Where the water is and went, as wet::Accounts has it; held: in long hair, too; dried: evaporated and wiped off.
struct WaterView {
  double came = 0, held = 0, film = 0, drops = 0, dripped = 0, dried = 0;
};

// What the section "Picture" shows.
struct PictureView {
  int shownWidth = 0, shownHeight = 0;  // of what is seen, pixels
  int leastSide = 16, mostSide = 8192;
  bool busy = false;     // a picture or a turntable is being drawn
  float progress = 0;    // of it, 0..1
  bool turning = false;  // the camera goes round, live
};

// Of a scene that was kept under a name.
struct VersionView {
  std::string id;    // for commands
  std::string name;  // any text
  std::string when;
  ImTextureID picture = nullptr;
};
// A coat of the person's own, beside the presets.
struct OwnCoatView {
  std::string id;    // for commands
  std::string name;
};
inline constexpr int kVersionPictureWidth = 144, kVersionPictureHeight = 96;
inline constexpr int kMostNameCharacters = 80;

struct EditorModel {
  settings::Settings settings;
  Tool tool = Tool::Droplet;
  std::string modelName;
  std::vector<std::string> animations;  // names of what it can play, for the setting `animation`, which counts from 1
  std::vector<std::string> actions;     // of an animal, what it can do
  std::string action;                   // and what it does now
  float meanWetness = 0;  // 0..1
  WaterView water;
  bool canUndo = false, canRedo = false;
  FileAccess fileAccess = FileAccess::Dialog;
  std::span<const Message> messages;  // oldest first
  std::vector<std::string> lostBySaving;  // what SaveScene would leave out
  int vertices = 0, triangles = 0, strands = 0, layers = 0, finEdges = 0;
  std::size_t cpuBytes = 0, gpuBytes = 0;
  std::span<const float> frameSeconds;  // the last frames, oldest first
  CoatView coat;
  bool typeGiven[settings::kFurTypes] = {};     // its coat comes from a type set
  bool typePictured[settings::kFurTypes] = {};  // it has a colour map
  bool skinPictured = false;                    // so has the skin
  GroomView groom;
  std::vector<MaterialView> materials;  // none: there is one
  HairView hair;
  PictureView picture;
  std::string pictureAsked;  // the file of a picture of which it is to be asked what it is; "": none
  std::span<const VersionView> versions;  // newest first
  std::span<const OwnCoatView> ownCoats;  // by name
};

namespace command {
// Every SetSettings between these two belongs to one undo step.
struct BeginChange {};
struct EndChange {};
struct SetSettings {
  settings::Settings settings;
};
struct SetTool {
  Tool tool;
};
struct SetWetness {
  float amount;
};
struct Shake {};
struct Stamp {
  std::string text;
};
struct LoadShipped {
  std::string name;
};  // a model or scene that ships with the program, or "sphere", "torus", "plane"
struct OpenDialog {};
struct OpenPath {
  std::string path;
};
struct ResetCamera {};
struct Undo {};
struct Redo {};
struct CopyState {};   // settings and camera as text, to the clipboard
struct PasteState {};  // and from it
struct ApplyPreset {
  std::string name;  // of settings/Presets.h
  int type = 0;      // of the fur, 0 to 3
};
// A coat of one's own under a name: that of the type that is edited is kept, or it is worn by that.
struct KeepCoat {
  std::string name;
};
struct WearCoat {
  std::string id;
};
struct SaveOwnCoat {    // as a file
  std::string id;
};
struct RenameCoat {
  std::string id, name;
};
struct DeleteCoat {
  std::string id;
};
struct SaveTypeSet {};  // the coat of the type that is edited as .fts
struct SaveFo {};       // the model as .fo
struct SaveHair {};     // the selected scalp's strands as .hair
struct SaveScene {};    // all of it as .glb
struct SaveMaps {};     // the groom's maps, wetness and layout as pictures
struct SelectAt {
  Selects what;
  float radius = 0;  // of a sphere or capsule
};
struct GroomAll {       // app::App::groomAll()
  GroomEdit edit = GroomEdit::Clear;
  float value = 1;
  Vec3 direction{0};
};
struct SetPoint {       // of the chosen one; of the comb all of `comb`
  FurNumber what = FurNumber::Length;
  float value = 0;
  LeanView comb{};
};
struct SetWhisker {     // the chosen one
  WhiskerView whisker;
};
struct RemoveWhisker {};
struct ChooseWhisker {  // the one after it, or before
  int step;
};
struct SetFurry {       // app::App::setFurry()
  int material;
  bool furry;
};
struct Act {            // app::App::act()
  std::string action;
};
struct EditHair {       // app::App::editHair()
  HairEdit edit = HairEdit::AddScalp;
  float value = 1;
  Vec3 direction{0};
};
struct SetHairValues {
  std::size_t scalp;
  hair::HairValues values;
};
struct SetBody {
  std::size_t index;
  hair::Body body;
};
struct RenameScalp {
  std::size_t scalp;
  std::string name;
};
struct UsePicture {     // the one that is asked about; none: it is not used
  std::optional<PictureUse> use;
};
struct SavePicture {
  int width, height;
  bool transparent;
};
// A film of one turn of the camera, or its frames. Less than no seconds: the other way round.
struct SaveTurntable {
  int width, height;
  bool transparent;
  float secondsPerTurn;
};
struct TurnOnce {
  float secondsPerTurn;
};
struct StopPicture {};  // and turning
struct KeepVersion {
  std::string name;
};
struct OpenVersion {
  std::string id;
};
struct RenameVersion {
  std::string id, name;
};
struct DeleteVersion {
  std::string id;
};
struct DismissMessage {
  std::size_t index;
};
}  // namespace command

using Command = std::variant<command::BeginChange, command::EndChange, command::SetSettings, command::SetTool,
                             command::SetWetness, command::Shake, command::Stamp, command::LoadShipped,
                             command::OpenDialog, command::OpenPath, command::ResetCamera, command::Undo,
                             command::Redo, command::CopyState, command::PasteState, command::ApplyPreset,
                             command::KeepCoat, command::WearCoat, command::SaveOwnCoat, command::RenameCoat, command::DeleteCoat,
                             command::SaveTypeSet, command::SaveFo, command::SaveHair, command::SaveScene, command::SaveMaps, command::SelectAt, command::GroomAll, command::SetFurry, command::UsePicture,
                             command::SetPoint, command::SetWhisker, command::RemoveWhisker, command::ChooseWhisker,
                             command::Act, command::EditHair, command::SetHairValues, command::SetBody, command::RenameScalp,
                             command::SavePicture, command::SaveTurntable, command::TurnOnce, command::StopPicture,
                             command::KeepVersion, command::OpenVersion, command::RenameVersion, command::DeleteVersion,
                             command::DismissMessage>;

}  // namespace fur::editor
