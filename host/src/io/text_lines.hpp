// Text files line by line, and the numbers in a line.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sailmap/error.hpp"

namespace sailmap::io {

struct Line {
  int number = 0;  // from 1
  std::string text;
};

// The lines that say something: blank lines and those that begin with # are left out; white space at either
// end (a carriage return too) and a byte order mark are removed. Throws Error naming the file when it is
// missing, cannot be read, or holds a zero byte, as no text does.
std::vector<Line> read_lines(const std::filesystem::path& path);

// "file:line: fault".
Error line_error(const std::filesystem::path& path, const Line& line, const std::string& fault);

std::string_view trimmed(std::string_view text);

// The words between runs of white space.
std::vector<std::string_view> split_words(std::string_view text);

// The trimmed fields between separators; empty ones are kept.
std::vector<std::string_view> split_fields(std::string_view text, char separator);

// Nothing unless the whole text is one decimal integer that fits.
std::optional<int> parse_integer(std::string_view text);

// Nothing unless the whole text is one finite number.
std::optional<double> parse_number(std::string_view text);

}  // namespace sailmap::io
