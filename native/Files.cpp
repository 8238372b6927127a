#include "native/Files.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "scene/ImageDecode.h"
#include "scene/Formats.h"
#include "scene/Png.h"

namespace fur::native {

namespace fs = std::filesystem;

Result<std::vector<std::uint8_t>> readFile(const std::string& path) {
  std::error_code failure;
  const auto size = fs::file_size(path, failure);
  if (failure) return Error{ErrorId::Network, path + ": " + failure.message()};
  if (size > scene::kMaxFileBytes)
    return Error{ErrorId::TooLarge, path + ": " + std::to_string(size >> 20) + " MiB, the limit is " +
                                        std::to_string(scene::kMaxFileBytes >> 20) + " MiB"};
  std::ifstream in(path, std::ios::binary);
  std::vector<std::uint8_t> bytes(size);
  if (!in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size)))
    return Error{ErrorId::Network, path + ": cannot be read"};
  return bytes;
}

Status writeFile(const std::string& path, std::span<const std::uint8_t> bytes) {
  std::ofstream out(path, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  out.flush();
  if (!out) return Error{ErrorId::Network, path + ": cannot be written"};
  return Done{};
}

Status replaceFile(const std::string& path, std::span<const std::uint8_t> bytes) {
  const std::filesystem::path part = path + ".part";
  std::error_code failure;
  Status status = writeFile(part.string(), bytes);
  if (status) {
    std::filesystem::rename(part, path, failure);
    if (failure) status = refused(path, failure);
  }
  if (!status) std::filesystem::remove(part, failure);
  return status;
}

Error refused(const std::filesystem::path& place, const std::error_code& why) { return {ErrorId::Network, place.string() + ": " + why.message()}; }

std::string freePath(const std::string& wanted) {
  const fs::path path(wanted);
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return wanted;
  for (int i = 2;; ++i) {
    const fs::path next = path.parent_path() / (path.stem().string() + '-' + std::to_string(i) + path.extension().string());
    if (!fs::exists(next, ignored)) return next.string();
  }
}

std::string numberedPath(const std::string& path, int number, int count) {
  const std::size_t digits = std::max<std::size_t>(3, std::to_string(count - 1).size());
  std::string text = std::to_string(number);
  text.insert(0, digits - text.size(), '0');
  const fs::path whole(path);
  return (whole.parent_path() / (whole.stem().string() + '-' + text + whole.extension().string())).string();
}

Status writePng(const std::string& path, int width, int height, const std::vector<std::uint8_t>& rgba) {
  return writeFile(path, scene::writePng(width, height, 4, rgba));
}

namespace {

// Where the model of that name lies among those that are shipped.
std::string findShipped(const std::string& name, const std::string& programPath) {
  const fs::path file = ("models/" + name).append(scene::endingOf(scene::Format::Glb));
  std::error_code ignored;
  for (fs::path folder = fs::absolute(programPath, ignored).parent_path();; folder = folder.parent_path()) {
    for (const fs::path& below : {file, "build" / file})
      if (fs::exists(folder / below, ignored)) return (folder / below).string();
    if (folder == folder.parent_path()) return file.string();
  }
}

// The files that a .gltf may name, from its own folder.
scene::FileSet neighbours(const std::string& path) {
  scene::FileSet set;
  if (scene::formatNamed(path) != scene::Format::Gltf) return set;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(fs::absolute(path, ignored).parent_path(), ignored)) {
    const std::string name = entry.path().filename().string();
    if (!scene::isNamedAs(scene::FileKind::Companion, name) && !scene::isNamedAs(scene::FileKind::Picture, name)) continue;
    if (auto bytes = readFile(entry.path().string())) set[name] = std::move(*bytes);
  }
  return set;
}

void decodePictures(app::App& app) {
  for (const std::uint32_t number : app.pendingPictures()) {
    if (auto image = scene::decodeImage(app.typePicture(number).bytes)) app.provideTypePicture(number, image->width, image->height, std::move(image->rgba));
    else app.addWarning("a colour map could not be read: " + image.error().message);
  }
}

}  // namespace

Status restoreTypeFiles(app::App& app, std::span<const std::uint8_t> bytes) {
  const Status status = app.restoreTypeFiles(bytes);
  decodePictures(app);
  return status;
}

Status loadTypeSet(app::App& app, const std::string& path, int type) {
  const auto bytes = readFile(path);
  if (!bytes) return bytes.error();
  const Status status = app.loadTypeSet(bytes.value(), fs::path(path).filename().string(), type);
  decodePictures(app);
  return status;
}

Status loadTypePicture(app::App& app, const std::string& path, int type) {
  auto bytes = readFile(path);
  if (!bytes) return bytes.error();
  auto image = scene::decodeImage(*bytes);
  if (!image) return Error{image.error().id, path + ": " + image.error().message};
  return app.setTypePicture(type, std::move(*bytes), image->width, image->height, std::move(image->rgba));
}

Status loadHair(app::App& app, const std::string& path) {
  const auto bytes = readFile(path);
  if (!bytes) return bytes.error();
  return app.loadHair(bytes.value(), fs::path(path).filename().string());
}

namespace {

// use(its name, what is in it, the file)
template <class Use>
Status withPicture(const std::string& path, const Use& use) {
  auto bytes = readFile(path);
  if (!bytes) return bytes.error();
  const auto image = scene::decodeImage(bytes.value());
  if (!image) return Error{image.error().id, path + ": " + image.error().message};
  return use(fs::path(path).filename().string(), image.value(), std::move(*bytes));
}

}  // namespace

Status loadGroomImage(app::App& app, groom::ImageOf what, const std::string& path) {
  return withPicture(path, [&](const std::string& name, const auto& image, auto&&) {
    app.groomFromFile(what, name, image.width, image.height, image.rgba);
    return Status(Done{});
  });
}

Status usePicture(app::App& app, app::PictureUse use, const std::string& path) {
  return withPicture(path, [&](const std::string& name, const auto& image, std::vector<std::uint8_t> file) {
    return app.usePicture(use, name, image.width, image.height, image.rgba, std::move(file));
  });
}

Status writeFiles(const std::string& folder, std::span<const scene::NamedFile> files) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) return Error{ErrorId::Network, folder + ": " + failure.message()};
  for (const scene::NamedFile& file : files)
    if (Status status = writeFile((fs::path(folder) / file.name).string(), file.bytes); !status) return status;
  return Done{};
}

bool isModel(const std::string& nameOrPath) {
  return !scene::isNamedAs(scene::FileKind::Coat, nameOrPath) && !scene::isNamedAs(scene::FileKind::Hair, nameOrPath) && !scene::isNamedAs(scene::FileKind::Picture, nameOrPath);
}

Status loadScene(app::App& app, const std::string& nameOrPath, const std::string& programPath) {
  if (nameOrPath == "sphere" || nameOrPath == "torus" || nameOrPath == "plane") return app.loadPrimitive(nameOrPath);
  if (scene::isNamedAs(scene::FileKind::Coat, nameOrPath)) return loadTypeSet(app, nameOrPath);
  if (scene::isNamedAs(scene::FileKind::Hair, nameOrPath)) return loadHair(app, nameOrPath);
  if (scene::isNamedAs(scene::FileKind::Picture, nameOrPath)) return loadGroomImage(app, groom::ImageOf::Length, nameOrPath);
  std::error_code ignored;
  const bool shipped = !fs::path(nameOrPath).has_extension() && !fs::exists(nameOrPath, ignored);
  const std::string path = shipped ? findShipped(nameOrPath, programPath) : nameOrPath;
  const auto bytes = readFile(path);
  if (!bytes) return bytes.error();
  const std::string name = fs::path(nameOrPath).filename().string();
  if (Status status = app.loadModel(bytes.value(), name, neighbours(path)); !status) return status;
  decodePictures(app);
  while (!app.pendingImage().bytes.empty()) {
    auto image = scene::decodeImage(app.pendingImage().bytes);
    if (!image) app.addWarning(name + ": " + image.error().message);
    if (image) app.provideImage(image->width, image->height, std::move(image->rgba));
    else app.provideImage(0, 0, {});
  }
  return Done{};
}

}  // namespace fur::native
