#include "text_lines.hpp"

#include <charconv>
#include <cmath>
#include <fstream>
#include <system_error>

#include "file_reading.hpp"

namespace sailmap::io {

namespace {

constexpr std::string_view white_space = " \t\r\n\v\f";
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

template <class T>
std::optional<T> parse_whole(std::string_view text) {
  T value{};
  const char* end = text.data() + text.size();
  const auto [stopped, fault] = std::from_chars(text.data(), end, value);
  if (fault != std::errc{} || stopped != end) return std::nullopt;
  return value;
}

}  // namespace

std::vector<Line> read_lines(const std::filesystem::path& path) {
  std::ifstream in = open_for_reading(path);
  std::vector<Line> lines;
  std::string text;
  for (int number = 1; std::getline(in, text); ++number) {
    if (text.find('\0') != std::string::npos) throw Error(path.string() + ": not a text file");
    std::string_view rest = text;
    if (number == 1 && rest.starts_with(byte_order_mark)) rest.remove_prefix(byte_order_mark.size());
    rest = trimmed(rest);
    if (!rest.empty() && rest.front() != '#') lines.push_back({number, std::string(rest)});
  }
  if (in.bad()) throw Error(path.string() + ": reading failed");
  return lines;
}

Error line_error(const std::filesystem::path& path, const Line& line, const std::string& fault) {
  return Error{path.string() + ":" + std::to_string(line.number) + ": " + fault};
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(white_space);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(white_space) - first + 1);
}

std::vector<std::string_view> split_words(std::string_view text) {
  std::vector<std::string_view> words;
  std::size_t begin = text.find_first_not_of(white_space);
  while (begin != std::string_view::npos) {
    const std::size_t end = text.find_first_of(white_space, begin);
    words.push_back(text.substr(begin, end == std::string_view::npos ? end : end - begin));
    begin = text.find_first_not_of(white_space, end);
  }
  return words;
}

std::vector<std::string_view> split_fields(std::string_view text, char separator) {
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t end = text.find(separator);
    fields.push_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos) return fields;
    text.remove_prefix(end + 1);
  }
}

std::optional<int> parse_integer(std::string_view text) { return parse_whole<int>(text); }

std::optional<double> parse_number(std::string_view text) {
  const auto value = parse_whole<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace sailmap::io
