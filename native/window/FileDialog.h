// The desktop's own dialogs for files: zenity's or kdialog's, whichever is installed, in a process of its own, so that the window goes on.
// The variable FUR_FILE_DIALOG names one of them, also by its path; "none": none.
#pragma once

#include <optional>
#include <string>

namespace fur::native {

class FileDialog {
 public:
  enum class Kind { Open, Save, Folder };

  FileDialog() = default;
  ~FileDialog() { close(); }
  FileDialog(const FileDialog&) = delete;
  FileDialog& operator=(const FileDialog&) = delete;

  // There is a program that shows them.
  static bool available() { return !program().empty(); }
  // What to say where there is none.
  static constexpr const char* kMissing = "there is no file dialog here: install zenity or kdialog";

  // False: it cannot, or one is open. `suggested`: a path, which need not exist.
  bool show(Kind kind, const std::string& title, const std::string& suggested);
  bool isOpen() const { return process_ > 0; }
  // Once, when it has been closed: the path, or "" where the person gave up.
  std::optional<std::string> poll();

 private:
  static std::string program();
  void close();

  int process_ = 0, output_ = -1;
  std::string answer_;
};

}  // namespace fur::native
