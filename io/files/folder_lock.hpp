// One command at a time writes into a folder.
//
// A record lock on the file .plica.lock: the system drops it with the process, so that a run that
// was killed blocks nobody, and a child process never holds it. The file is gone with the lock.
// Where the file system knows no locks, none is taken.
#pragma once

#include "words/input_error.hpp"

#include <filesystem>
#include <string>

namespace plica {

// Another command is at work on it: later it may be free.
class FolderInUse : public InputError {
public:
  using InputError::InputError;
};

class FolderLock {
public:
  // FolderInUse, with the process, when another command writes here; InputError when nothing can be
  // written.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  // A word that the next holder finds when this one was killed.
  void leave(const std::string& word) const;
  const std::string& left() const { return left_; } // by a holder that was killed

private:
  bool take();

  std::filesystem::path file_;
  int handle_ = -1;
  std::string left_;
};

} // namespace plica
