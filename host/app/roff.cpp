#include "roff.hpp"

#include <cctype>

namespace sailmap::app {
namespace {

// As it stands: also in what a terminal copies.
std::string literal(char c) {
  switch (c) {
    case '\\':
      return "\\(rs";
    case '-':
      return "\\-";
    case '\'':
      return "\\(aq";
    case '`':
      return "\\(ga";
    case '^':
      return "\\(ha";
    case '~':
      return "\\(ti";
    case '"':
      return "\\(dq";
    default:
      return {c};
  }
}

std::string literal(const std::string& text) {
  std::string out;
  for (const char c : text) out += literal(c);
  return out;
}

bool begins_word(const std::string& text, std::size_t at) {
  return at == 0 || std::isspace(static_cast<unsigned char>(text[at - 1])) != 0 || text[at - 1] == '(';
}

bool ends_word(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

}  // namespace

std::string roff_text(const std::string& text) {
  std::string out;
  bool code = false;     // within back quotes
  bool dashed = false;   // within a word that begins with a dash
  bool new_line = true;  // a dot or an apostrophe here would be a request
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') {
      out += "\n.br\n";
      dashed = false;
      new_line = true;
      continue;
    }
    if (c == '`') {
      code = !code;
      out += code ? "\\fB" : "\\fR";
      new_line = false;
      continue;
    }
    if (begins_word(text, i)) dashed = c == '-';
    if (ends_word(c)) dashed = false;
    if (new_line && (c == '.' || c == '\'')) out += "\\&";
    out += c == '-' && !dashed && !code ? "-" : literal(c);
    new_line = false;
  }
  return out;
}

std::string roff_lines(const std::string& text) { return roff_text(text) + "\n"; }

std::string roff_bold(const std::string& name) { return "\\fB" + literal(name) + "\\fR"; }

std::string roff_italic(const std::string& name) { return "\\fI" + literal(name) + "\\fR"; }

}  // namespace sailmap::app
