// Pictures and turntables of any size, drawn band by band beside what is shown while the scene stands still for them.
//
//   begin(order), then next() until last(): each gives a band of a frame, from the top; or end() to give up.
#pragma once

#include <optional>
#include <vector>

#include "app/App.h"
#include "gl/Objects.h"

namespace fur::app {

struct PictureOrder {
  int width = 1920, height = 1080;
  bool transparent = false;
  // More than one: the camera goes once round the model, by OrbitCamera::turned().
  int frames = 1;
  float secondsPerTurn = 0;
  int samples = 1;  // as App::draw() has them
};

// Of a turn of so many seconds, at kFramesPerSecond.
int turntableFrames(float secondsPerTurn);
inline constexpr int kFramesPerSecond = 30;
inline constexpr int kMostPictureSide = 8192, kLeastPictureSide = 16;
// The longest side that this machine draws; needs a context.
int mostPictureSide();

class Studio {
 public:
  struct Band {
    int frame, top, rows;
    bool lastOfFrame;
    std::vector<std::uint8_t> rgba;  // straight alpha, rows from the top
  };

  explicit Studio(App& app) : app_(app) {}

  // too-large names the limit. From now on App::tick() does nothing, until the last band or end().
  Status begin(const PictureOrder& order);
  Result<Band> next();
  void end();
  bool busy() const { return order_.has_value(); }
  float progress() const;  // 0..1
  const PictureOrder& order() const { return *order_; }

  // The whole of a small opaque picture at once.
  Result<std::vector<std::uint8_t>> thumbnail(int width, int height);

 private:
  Status makeTargets();
  Result<std::vector<std::uint8_t>> draw(int bottom, int rows);

  App& app_;
  std::optional<PictureOrder> order_;
  CameraOrbit start_;
  int frame_ = 0, rowsDone_ = 0;
  gl::Target drawn_, resolved_;
  int targetRows_ = 0;
};

}  // namespace fur::app
