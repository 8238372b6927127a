#include "app/editor/Studio.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "app/view/OrbitCamera.h"
#include "core/NumberText.h"
#include "scene/Png.h"

namespace fur::app {

namespace {

constexpr int kSamples = 4;
// Some 70 MB with four samples of colour and depth.
constexpr int kPixelsPerBand = 2 << 20;

}  // namespace

int turntableFrames(float secondsPerTurn) {
  return std::max(2, static_cast<int>(std::lround(std::abs(secondsPerTurn) * kFramesPerSecond)));
}

int mostPictureSide() {
  auto capabilities = gl::queryCapabilities();
  return capabilities ? std::min(kMostPictureSide, capabilities->maxTextureSize) : kLeastPictureSide;
}

Status Studio::begin(const PictureOrder& order) {
  end();
  const int most = mostPictureSide();
  if (order.width > most || order.height > most || order.width < kLeastPictureSide || order.height < kLeastPictureSide)
    return Error{ErrorId::TooLarge, "a picture of " + decimal(order.width) + " x " + decimal(order.height) +
                                        " cannot be drawn: sides of " + decimal(kLeastPictureSide) + " to " + decimal(most) +
                                        " pixels can"};
  order_ = order;
  if (Status status = makeTargets(); !status) {
    order_.reset();
    return status;
  }
  app_.finishCoat();
  app_.setStanding(true);
  start_ = app_.camera();
  frame_ = rowsDone_ = 0;
  return Done{};
}

Status Studio::makeTargets() {
  targetRows_ = std::clamp(kPixelsPerBand / order_->width, 1, order_->height);
  auto drawn = gl::Target::offscreen(order_->width, targetRows_, kSamples);
  if (!drawn) return drawn.error();
  auto resolved = gl::Target::offscreen(order_->width, targetRows_, 0);
  if (!resolved) return resolved.error();
  drawn_ = std::move(*drawn);
  resolved_ = std::move(*resolved);
  gl::bindPlatformFramebuffer();
  return Done{};
}

void Studio::end() {
  drawn_ = {};
  resolved_ = {};
  const auto ended = std::exchange(order_, std::nullopt);
  if (!ended) return;
  app_.setStanding(false);
  if (ended->frames > 1) app_.setCamera(start_);
  app_.invalidate();
}

float Studio::progress() const {
  const float frame = static_cast<float>(rowsDone_) / static_cast<float>(order_->height);
  return (static_cast<float>(frame_) + frame) / static_cast<float>(order_->frames);
}

// The target stands in for the platform's framebuffer meanwhile.
Result<std::vector<std::uint8_t>> Studio::draw(int bottom, int rows) {
  drawn_.bind();
  const gl::PlatformStandIn standIn;
  if (Status status = app_.drawPart({order_->width, order_->height, bottom, targetRows_, order_->transparent, order_->samples}); !status) return status.error();
  resolved_.resolve(drawn_, order_->width, targetRows_);
  auto rgba = gl::readPixels(order_->width, rows);
  if (const std::string error = gl::takeError(); !error.empty()) return Error{ErrorId::OutOfMemory, "the picture cannot be drawn: " + error};
  if (order_->transparent) scene::makeStraight(rgba);
  return rgba;
}

Result<Studio::Band> Studio::next() {
  const PictureOrder order = *order_;
  const bool turns = order.frames > 1;
  if (rowsDone_ == 0 && turns) {
    const float seconds = std::abs(order.secondsPerTurn) / static_cast<float>(order.frames);
    app_.setStanding(false);
    if (frame_ > 0) advanceFilm(app_, seconds);
    app_.setStanding(true);
    CameraOrbit orbit = start_;
    orbit.yaw += OrbitCamera::turned(seconds * static_cast<float>(frame_), order.secondsPerTurn);
    app_.setCamera(orbit);
  }
  const int rows = std::min(targetRows_, order.height - rowsDone_);
  auto rgba = draw(order.height - rowsDone_ - rows, rows);
  if (!rgba) {
    end();
    return rgba.error();
  }
  Band band{frame_, rowsDone_, rows, rowsDone_ + rows == order.height, std::move(*rgba)};
  rowsDone_ += rows;
  if (!band.lastOfFrame) return band;
  rowsDone_ = 0;
  if (++frame_ == order.frames) end();
  return band;
}

Result<std::vector<std::uint8_t>> Studio::thumbnail(int width, int height) {
  if (busy()) return Error{ErrorId::TooLarge, "a picture is being drawn"};
  order_ = PictureOrder{width, height};
  Status made = makeTargets();
  auto rgba = made ? draw(0, height) : Result<std::vector<std::uint8_t>>(made.error());
  order_.reset();
  drawn_ = {};
  resolved_ = {};
  return rgba;
}

}  // namespace fur::app
