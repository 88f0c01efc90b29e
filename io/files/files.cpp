#include "io/files/files.hpp"

#include "words/input_error.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace plica {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& what, const fs::path& path, const std::string& why) {
  throw InputError({{.file = path.string(),
                     .line = 0,
                     .key = "",
                     .wrong = "cannot " + what + ": " + why,
                     .allowed = "a place that can be written"}});
}

class Handle {
public:
  Handle(const fs::path& file, int flags) : number_(open(file.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~Handle() {
    if (number_ >= 0) ::close(number_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  bool good() const { return number_ >= 0; }
  int number() const { return number_; }
  bool close() { return ::close(std::exchange(number_, -1)) == 0; }

private:
  int number_;
};

bool write_all(int handle, const std::string& content) {
  for (std::size_t done = 0; done < content.size();) {
    const ssize_t n = ::write(handle, content.data() + done, content.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    done += std::size_t(n);
  }
  return true;
}

const char* kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "is a directory";
  if (S_ISFIFO(mode)) return "is a pipe";
  if (S_ISSOCK(mode)) return "is a socket";
  return "is a device";
}

} // namespace

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail("make the folder for the results", folder, error.message());
  if (!fs::is_directory(folder, error))
    fail("write the results here", folder, "it is a file, not a folder");
}

void write_new(const fs::path& file, const std::string& content, const fs::path& shown) {
  Handle handle(file, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW);
  if (!handle.good()) fail("write", shown, std::strerror(errno));
  if (write_all(handle.number(), content) && handle.close()) return;
  const int why = errno;
  unlink(file.c_str());
  fail("write", shown, std::strerror(why));
}

void write_whole(const fs::path& target, const std::string& content) {
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  make_folder(folder);
  if (fs::is_directory(target)) fail("write", target, "a folder has this name");
  std::string aside = (folder / ".plica-XXXXXX").string();
  if (!mkdtemp(aside.data())) fail("write", target, std::strerror(errno));
  const fs::path temporary = fs::path(aside) / target.filename();
  std::error_code error, ignored;
  try {
    write_new(temporary, content, target);
  } catch (...) {
    fs::remove(aside, ignored);
    throw;
  }
  fs::rename(temporary, target, error);
  fs::remove_all(aside, ignored);
  if (error) fail("write", target, error.message());
}

// Opened without waiting for the other end of a pipe.
std::string read_whole(const fs::path& path) {
  const auto fail_to_read = [&](const std::string& why) {
    throw std::runtime_error("cannot read " + path.string() + ": " + why);
  };
  const Handle handle(path, O_RDONLY | O_NONBLOCK | O_NOCTTY);
  struct stat status {};
  if (!handle.good() || fstat(handle.number(), &status) != 0) fail_to_read(std::strerror(errno));
  if (!S_ISREG(status.st_mode)) fail_to_read(std::string("it ") + kind_of(status.st_mode));
  std::string text(std::size_t(status.st_size), '\0');
  std::size_t size = 0;
  while (true) {
    if (size == text.size()) text.resize(size + 4096); // files of /proc say 0, others grow
    const ssize_t n = ::read(handle.number(), text.data() + size, text.size() - size);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail_to_read(std::strerror(errno));
    if (n == 0) break;
    size += std::size_t(n);
  }
  text.resize(size);
  return text;
}

std::string why_unreadable(const fs::path& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0)
    return errno == ENOENT ? "file not found"
                           : std::string("cannot be read: ") + std::strerror(errno);
  if (!S_ISREG(status.st_mode)) return kind_of(status.st_mode);
  if (access(path.c_str(), R_OK) != 0)
    return std::string("cannot be read: ") + std::strerror(errno);
  return "";
}

} // namespace plica
