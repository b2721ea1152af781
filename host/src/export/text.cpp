#include "text.hpp"

#include <boost/locale/utf.hpp>
#include <iterator>

namespace sailmap {
namespace {

namespace utf = boost::locale::utf;
using Utf8 = utf::utf_traits<char>;

constexpr utf::code_point replacement = 0xFFFD;

bool any(utf::code_point) { return true; }

bool in_xml(utf::code_point c) {
  return c == '\t' || c == '\n' || c == '\r' || (c >= 0x20 && c != 0xFFFE && c != 0xFFFF);
}

template <class Allowed>
std::string cleaned(std::string_view bytes, Allowed allowed) {
  std::string out;
  for (const char* at = bytes.data(); at != bytes.data() + bytes.size();) {
    const char* next = at;
    utf::code_point point = Utf8::decode(next, bytes.data() + bytes.size());
    if (!utf::is_valid_codepoint(point)) {
      point = replacement;
      next = at + 1;
    }
    Utf8::encode(allowed(point) ? point : replacement, std::back_inserter(out));
    at = next;
  }
  return out;
}

}  // namespace

std::string utf8(std::string_view bytes) { return cleaned(bytes, any); }

std::string xml_text(std::string_view bytes) { return cleaned(bytes, in_xml); }

std::string quoted(std::string_view bytes, std::string_view escaped_quote) {
  std::string out = "\"";
  for (const char c : utf8(bytes)) {
    if (c == '"') {
      out += escaped_quote;
    } else {
      out += c;
    }
  }
  return out + "\"";
}

}  // namespace sailmap
