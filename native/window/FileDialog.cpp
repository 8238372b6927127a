#include "native/window/FileDialog.h"

#include <cstdlib>
#include <filesystem>
#include <vector>

#ifndef _WIN32
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;
#endif

namespace fur::native {

namespace fs = std::filesystem;

namespace {

bool isProgram(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) && (fs::status(path, ignored).permissions() & fs::perms::owner_exec) != fs::perms::none;
}

std::vector<std::string> argumentsFor(const std::string& program, FileDialog::Kind kind, const std::string& title, const std::string& suggested) {
  using Kind = FileDialog::Kind;
  if (fs::path(program).filename() == "kdialog") {
    const char* ways[] = {"--getopenfilename", "--getsavefilename", "--getexistingdirectory"};
    return {program, "--title", title, ways[static_cast<int>(kind)], suggested};
  }
  std::vector<std::string> all{program, "--file-selection", "--title=" + title, "--filename=" + suggested};
  if (kind == Kind::Save) all.insert(all.end(), {"--save", "--confirm-overwrite"});
  if (kind == Kind::Folder) all.push_back("--directory");
  return all;
}

}  // namespace

std::string FileDialog::program() {
  const char* named = std::getenv("FUR_FILE_DIALOG");
  const std::string wanted = named ? named : "";
  if (wanted.find('/') != std::string::npos) return isProgram(wanted) ? wanted : "";
  const char* folders = std::getenv("PATH");
  for (const std::string name : {"zenity", "kdialog"}) {
    if (!wanted.empty() && wanted != name) continue;
    const std::string all = folders ? folders : "";
    for (std::size_t at = 0, end; at < all.size(); at = end + 1) {
      end = std::min(all.find(':', at), all.size());
      if (const fs::path path = fs::path(all.substr(at, end - at)) / name; isProgram(path)) return path.string();
    }
  }
  return {};
}

#ifdef _WIN32

bool FileDialog::show(Kind, const std::string&, const std::string&) { return false; }
std::optional<std::string> FileDialog::poll() { return {}; }
void FileDialog::close() {}

#else

bool FileDialog::show(Kind kind, const std::string& title, const std::string& suggested) {
  const std::string program = FileDialog::program();
  int ends[2];
  if (program.empty() || isOpen() || pipe(ends) != 0) return false;
  std::vector<std::string> arguments = argumentsFor(program, kind, title, suggested);
  std::vector<char*> values;
  for (std::string& argument : arguments) values.push_back(argument.data());
  values.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_addclose(&actions, ends[0]);
  posix_spawn_file_actions_addclose(&actions, ends[1]);
  pid_t process = 0;
  const int failure = posix_spawn(&process, program.c_str(), &actions, nullptr, values.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  if (failure != 0) return ::close(ends[0]), false;
  process_ = process;
  output_ = ends[0];
  answer_.clear();
  return true;
}

std::optional<std::string> FileDialog::poll() {
  if (!isOpen()) return {};
  int status = 0;
  const bool ended = waitpid(process_, &status, WNOHANG) == process_;
  char part[4096];
  for (ssize_t count; (count = read(output_, part, sizeof part)) > 0;) answer_.append(part, static_cast<std::size_t>(count));
  if (!ended) return {};
  ::close(output_);
  process_ = 0;
  output_ = -1;
  while (!answer_.empty() && (answer_.back() == '\n' || answer_.back() == '\r')) answer_.pop_back();
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? answer_ : std::string();
}

void FileDialog::close() {
  if (!isOpen()) return;
  kill(process_, SIGTERM);
  waitpid(process_, nullptr, 0);
  ::close(output_);
  process_ = 0;
}

#endif

}  // namespace fur::native
