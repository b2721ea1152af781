// Who may write a map file.
#pragma once

#include <filesystem>

namespace sailmap::store {

// The right to write a map file, for one writer at a time; gone with the program however it ends. It must
// outlive the connections of this process to the file, whose own locks closing it would drop.
class WriteLock {
 public:
  // Makes the file when there is none. Throws Error, without the name of the file, when another writer, of
  // this program or another, has the lock, or the file cannot be written.
  explicit WriteLock(std::filesystem::path path);
  WriteLock(const WriteLock&) = delete;
  WriteLock& operator=(const WriteLock&) = delete;
  WriteLock(WriteLock&&) = delete;
  WriteLock& operator=(WriteLock&&) = delete;
  // Removes a file that it made and nobody wrote to.
  ~WriteLock();

  // After a rename has put another file in its place.
  void follow();

 private:
  void acquire();
  void release();
  [[nodiscard]] bool is_current() const;

  std::filesystem::path path_;
  int file_ = -1;
};

}  // namespace sailmap::store
