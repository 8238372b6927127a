// Reading and writing whole files, for both native programs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/App.h"
#include "core/Result.h"

namespace fur::native {

Result<std::vector<std::uint8_t>> readFile(const std::string& path);
Status writeFile(const std::string& path, std::span<const std::uint8_t> bytes);
// The same beside what is there, which it then replaces: a disk that is full leaves that as it is.
Status replaceFile(const std::string& path, std::span<const std::uint8_t> bytes);
// What the system says of that place.
Error refused(const std::filesystem::path& place, const std::error_code& why);
// `wanted`, or with a number behind it where there is something of that name already.
std::string freePath(const std::string& wanted);
// "turn.png" is "turn-007.png": of three digits or, of more than a thousand, as many as the last one takes.
std::string numberedPath(const std::string& path, int number, int count);
// Into a folder, which is made where there is none.
Status writeFiles(const std::string& folder, std::span<const scene::NamedFile> files);
// RGBA8 rows from the top.
Status writePng(const std::string& path, int width, int height, const std::vector<std::uint8_t>& rgba);

// A type set (.fts) or saved coat (.coat) by path takes the place of the coat.
Status loadTypeSet(app::App& app, const std::string& path, int type = 0);
// App::restoreTypeFiles(), with the pictures decoded.
Status restoreTypeFiles(app::App& app, std::span<const std::uint8_t> bytes);
// A picture as the colour map of a fur type, 0 to 3.
Status loadTypePicture(app::App& app, const std::string& path, int type);
Status loadHair(app::App& app, const std::string& path);  // a .hair file

// An image by path becomes the length map of the groom, or the map that it was saved as (App::groomFromFile()).
Status usePicture(app::App& app, app::PictureUse use, const std::string& path);
Status loadGroomImage(app::App& app, groom::ImageOf what, const std::string& path);

// Whether loadScene() would take it for a model: else it is a coat or a length map for the one that is there.
bool isModel(const std::string& nameOrPath);

// A model by path, or "sphere", "torus", "plane", or the name of one that is shipped, as "bunny" or "five-coats"
// (models/NAME.glb beside the program or below its parent folders). Decodes its picture too; one that cannot be
// decoded is a warning. A path of a type set goes to loadTypeSet(), of strands to loadHair(), of a picture is a length map.
Status loadScene(app::App& app, const std::string& nameOrPath, const std::string& programPath);

}  // namespace fur::native
