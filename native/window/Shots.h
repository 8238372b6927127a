// Writes what the panel's section "Picture" draws: a picture, or the numbered frames of a turn in a folder of their own.
#pragma once

#include <string>
#include <vector>

#include "app/editor/EditorHost.h"

namespace fur::native {

class Shots {
 public:
  // What EditorHost::nextBand() is about to give.
  void begin(const std::string& path, const app::PictureOrder& order);
  // One band. Tells the host when all is written, or why it is not.
  void work(app::EditorHost& host);

 private:
  Status writeFrame(int frame);

  std::string path_;
  app::PictureOrder order_;
  std::vector<std::uint8_t> rgba_;
};

}  // namespace fur::native
