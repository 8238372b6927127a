#include "native/window/Shots.h"

#include <filesystem>

#include "native/Files.h"

namespace fur::native {

namespace fs = std::filesystem;

void Shots::begin(const std::string& path, const app::PictureOrder& order) {
  path_ = path;
  order_ = order;
  rgba_.clear();
}

void Shots::work(app::EditorHost& host) {
  const auto band = host.nextBand();
  if (!band) return;
  rgba_.insert(rgba_.end(), band->rgba.begin(), band->rgba.end());
  if (!band->lastOfFrame) return;
  const Status status = writeFrame(band->frame);
  rgba_.clear();
  if (!status) host.endPicture();
  if (!status) return host.message(status.error().message, true);
  if (band->frame + 1 < order_.frames) return;
  std::error_code ignored;
  const std::string place = fs::absolute(path_, ignored).string();
  host.message(order_.frames > 1 ? std::to_string(order_.frames) + " pictures are in " + place : "Saved as " + place, false);
}

Status Shots::writeFrame(int frame) {
  if (order_.frames == 1) return writePng(path_, order_.width, order_.height, rgba_);
  std::error_code failure;
  fs::create_directories(path_, failure);
  if (failure) return Error{ErrorId::Network, path_ + ": " + failure.message()};
  return writePng(numberedPath((fs::path(path_) / fs::path(path_).filename()).string() + ".png", frame, order_.frames), order_.width, order_.height, rgba_);
}

}  // namespace fur::native
