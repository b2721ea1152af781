#include "write_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <mutex>
#include <set>
#include <string>
#include <system_error>
#include <utility>

#include "sailmap/error.hpp"

namespace sailmap::store {
namespace {

using FileNumber = std::pair<dev_t, ino_t>;

// The files that this process writes: asked before one is opened, since opening and closing it again would
// drop the locks of the connection that writes it.
std::mutex written_mutex;
std::set<FileNumber>& written() {
  static std::set<FileNumber> files;
  return files;
}

FileNumber number_of(const struct stat& status) { return {status.st_dev, status.st_ino}; }

}  // namespace

WriteLock::WriteLock(std::filesystem::path path) : path_(std::move(path)) { acquire(); }

WriteLock::~WriteLock() {
  struct stat held {};
  const bool empty = ::fstat(file_, &held) == 0 && S_ISREG(held.st_mode) && held.st_size == 0;
  std::error_code ignored;
  if (empty && is_current()) std::filesystem::remove(path_, ignored);
  release();
}

void WriteLock::follow() {
  release();
  acquire();
}

void WriteLock::release() {
  const std::scoped_lock hold(written_mutex);
  struct stat held {};
  if (::fstat(file_, &held) == 0) written().erase(number_of(held));
  ::close(file_);
}

void WriteLock::acquire() {
  const std::scoped_lock hold(written_mutex);
  do {
    struct stat named {};
    if (::stat(path_.c_str(), &named) == 0 && written().contains(number_of(named))) {
      throw Error("this program is writing this map already");
    }
    file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file_ < 0) throw Error(std::string("cannot be written: ") + std::strerror(errno));
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
      const int fault = errno;
      ::close(file_);
      throw Error(fault == EWOULDBLOCK ? "another program is writing this map"
                                       : std::string("cannot be locked: ") + std::strerror(fault));
    }
    // Renamed over or removed between the two calls: the lock is on a file that nobody finds any more.
    if (is_current()) break;
    ::close(file_);
  } while (true);
  struct stat held {};
  if (::fstat(file_, &held) == 0) written().insert(number_of(held));
}

bool WriteLock::is_current() const {
  struct stat held {};
  struct stat named {};
  return ::fstat(file_, &held) == 0 && ::stat(path_.c_str(), &named) == 0 &&
         number_of(held) == number_of(named);
}

}  // namespace sailmap::store
