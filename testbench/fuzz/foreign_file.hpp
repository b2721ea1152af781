// Bytes from outside as a file, and what a reader of such a file may do with them.
#pragma once

#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "sailmap/error.hpp"

namespace sailmap::fuzz {

// A finding: libFuzzer keeps the input of a program that aborts.
inline void demand(bool holds, std::string_view what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %.*s\n", static_cast<int>(what.size()), what.data());
  std::abort();
}

// One file a process, in memory where the system has a folder for that, gone with the process.
class ForeignFile {
 public:
  explicit ForeignFile(const std::string& extension) : path_(folder()) {
    path_ /= "sailmap_fuzz_" + std::to_string(::getpid()) + extension;
  }
  ForeignFile(const ForeignFile&) = delete;
  ForeignFile& operator=(const ForeignFile&) = delete;
  ForeignFile(ForeignFile&&) = delete;
  ForeignFile& operator=(ForeignFile&&) = delete;
  ~ForeignFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }

  // Replaces the content and returns where the file is.
  const std::filesystem::path& hold(const std::uint8_t* data, std::size_t size) {
    std::ofstream out(path_, std::ios::binary);
    out.write(static_cast<const char*>(static_cast<const void*>(data)), static_cast<std::streamsize>(size));
    out.close();
    demand(!out.fail(), "the file for the fuzzer's bytes can be written");
    return path_;
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  static std::filesystem::path folder() {
    const std::filesystem::path memory = "/dev/shm";
    std::error_code unknown;
    return std::filesystem::is_directory(memory, unknown) ? memory : std::filesystem::temp_directory_path();
  }

  std::filesystem::path path_;
};

// Catches what is printed through C++ streams while it lives: a library prints nothing.
class Silence {
 public:
  Silence() : out_(std::cout.rdbuf(printed_.rdbuf())), error_(std::cerr.rdbuf(printed_.rdbuf())) {}
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
  Silence(Silence&&) = delete;
  Silence& operator=(Silence&&) = delete;
  ~Silence() {
    std::cout.rdbuf(out_);
    std::cerr.rdbuf(error_);
    demand(printed_.str().empty(), "nothing is printed: " + printed_.str());
  }

 private:
  std::ostringstream printed_;
  std::streambuf* out_;
  std::streambuf* error_;
};

inline bool is_one_line(std::string_view message) {
  return !message.empty() && message.find_first_of("\r\n") == std::string_view::npos;
}

// What `read` returns, or nothing when it throws Error with one line that begins with `name`. Any other
// exception goes on, and ends the program.
template <class Read>
auto read_foreign(const std::string& name, const Read& read) -> std::optional<decltype(read())> {
  const Silence silence;
  try {
    return read();
  } catch (const Error& fault) {
    const std::string message = fault.what();
    demand(is_one_line(message), "an error is one line: " + message);
    demand(message.starts_with(name), "an error begins with the name of the file: " + message);
    return std::nullopt;
  }
}

}  // namespace sailmap::fuzz
