#include "io/files/folder_lock.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace plica {
namespace {

namespace fs = std::filesystem;

struct flock whole_file() {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

[[noreturn]] void refuse(const fs::path& folder, const std::string& wrong,
                         const std::string& allowed) {
  throw InputError(
      {{.file = folder.string(), .line = 0, .key = "", .wrong = wrong, .allowed = allowed}});
}

std::string holder_of(int handle) {
  struct flock lock = whole_file();
  const bool known = fcntl(handle, F_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
  return known && lock.l_pid > 0 ? "process " + std::to_string(lock.l_pid) : "another process";
}

// Whether the name still stands for the open file: its last holder may just have removed it.
bool is_named(int handle, const fs::path& file) {
  struct stat open_file {
  }, named{};
  return fstat(handle, &open_file) == 0 && lstat(file.c_str(), &named) == 0 &&
         open_file.st_dev == named.st_dev && open_file.st_ino == named.st_ino;
}

} // namespace

FolderLock::FolderLock(const fs::path& folder) : file_(folder / ".plica.lock") {
  while (!take()) {
  }
}

FolderLock::~FolderLock() {
  unlink(file_.c_str()); // before the lock goes: nobody else's file is removed
  close(handle_);
}

bool FolderLock::take() {
  const fs::path folder = file_.parent_path();
  handle_ = open(file_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
  struct stat status {};
  if (handle_ < 0 || fstat(handle_, &status) != 0 || !S_ISREG(status.st_mode)) {
    const std::string why = handle_ < 0 ? std::strerror(errno) : "it is no file";
    if (handle_ >= 0) close(handle_);
    refuse(folder, "cannot write here: " + file_.filename().string() + ": " + why,
           "a folder that can be written, with --out");
  }
  struct flock lock = whole_file();
  if (fcntl(handle_, F_SETLK, &lock) != 0 && (errno == EACCES || errno == EAGAIN)) {
    const std::string holder = holder_of(handle_);
    close(handle_);
    throw FolderInUse({{.file = folder.string(),
                        .line = 0,
                        .key = "",
                        .wrong = "another plica (" + holder + ") is writing here",
                        .allowed = "wait until it has ended, or another folder with --out"}});
  }
  if (!is_named(handle_, file_)) {
    close(handle_);
    return false;
  }
  std::array<char, 256> word{};
  const ssize_t size = read(handle_, word.data(), word.size());
  left_.assign(word.data(), size > 0 ? std::size_t(size) : 0);
  return true;
}

void FolderLock::leave(const std::string& word) const {
  const bool left = ftruncate(handle_, 0) == 0 &&
                    pwrite(handle_, word.data(), word.size(), 0) == ssize_t(word.size());
  if (!left)
    refuse(file_.parent_path(), std::string("cannot write here: ") + std::strerror(errno),
           "a folder that can be written, with --out");
}

} // namespace plica
