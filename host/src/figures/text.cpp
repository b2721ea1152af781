// Text by FreeType, in the font that fontconfig chooses.
#include <fontconfig/fontconfig.h>

#include <boost/locale/encoding_utf.hpp>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "drawing.hpp"

namespace sailmap::drawing {
namespace {

constexpr int stroke_font = cv::FONT_HERSHEY_SIMPLEX;
constexpr double stroke_font_em = 31;  // pixels of this font's em at scale 1: its capitals are 22 high

double stroke_scale(int size) { return size / stroke_font_em; }
int stroke_thickness(int size) { return size >= 40 ? 2 : 1; }

bool starts_letter(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }

// The stroke font would draw several question marks for one letter of UTF-8.
std::string ascii(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (starts_letter(c)) out += static_cast<unsigned char>(c) < 0x80 ? c : '?';
  }
  return out;
}

// The last place at or before `at` where a letter of UTF-8 starts.
std::size_t letter_start(const std::string& text, std::size_t at) {
  while (at > 0 && at < text.size() && !starts_letter(text[at])) --at;
  return at;
}

std::size_t next_letter(const std::string& text, std::size_t at) {
  while (at < text.size() && !starts_letter(text[at])) ++at;
  return at;
}

}  // namespace

std::string printable(const std::string& text) {
  std::string out = boost::locale::conv::utf_to_utf<char>(text, boost::locale::conv::skip);
  for (char& c : out) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F) c = ' ';
  }
  return out;
}

std::string font_file() {
  const std::unique_ptr<FcPattern, void (*)(FcPattern*)> wanted(
      FcPatternBuild(nullptr, FC_FAMILY, FcTypeString, "DejaVu Sans", FC_FAMILY, FcTypeString, "sans-serif",
                     FC_SCALABLE, FcTypeBool, FcTrue, static_cast<char*>(nullptr)),
      FcPatternDestroy);
  FcConfigSubstitute(nullptr, wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  FcResult result = FcResultNoMatch;
  const std::unique_ptr<FcPattern, void (*)(FcPattern*)> font(FcFontMatch(nullptr, wanted.get(), &result),
                                                              FcPatternDestroy);
  FcChar8* file = nullptr;
  if (!font || FcPatternGetString(font.get(), FC_FILE, 0, &file) != FcResultMatch) return {};
  std::string out;
  for (; *file != 0; ++file) out += static_cast<char>(*file);
  return out;
}

Text::Text(const std::string& font) {
  if (font.empty()) return;
  font_ = cv::freetype::createFreeType2();
  font_->loadFontData(font, 0);
}

void Text::draw(cv::Mat& canvas, const std::string& text, cv::Point at, int size,
                const cv::Scalar& colour) const {
  const std::string shown = printable(text);
  if (shown.empty()) return;
  if (font_) {
    // FreeType2::putText counts from the top of the line: one size above the baseline.
    font_->putText(canvas, shown, {at.x, at.y - size}, size, colour, cv::FILLED, cv::LINE_AA, false);
  } else {
    cv::putText(canvas, ascii(shown), at, stroke_font, stroke_scale(size), colour, stroke_thickness(size),
                cv::LINE_AA);
  }
}

int Text::width(const std::string& text, int size) const {
  const std::string shown = printable(text);
  if (shown.empty()) return 0;
  int baseline = 0;
  return font_ ? font_->getTextSize(shown, size, cv::FILLED, &baseline).width
               : cv::getTextSize(ascii(shown), stroke_font, stroke_scale(size), stroke_thickness(size),
                                 &baseline)
                     .width;
}

void Text::draw_within(cv::Mat& canvas, const std::string& text, cv::Point at, int size,
                       const cv::Scalar& colour, int most) const {
  std::string cut = text;
  for (std::size_t keep = text.size(); keep > 2 && width(cut, size) > most; --keep) {
    cut = text.substr(0, letter_start(text, keep / 2)) + "..." +
          text.substr(next_letter(text, text.size() - (keep - keep / 2)));
  }
  draw(canvas, cut, at, size, colour);
}

// The longest beginning of `word` that fits in a line, at least one letter.
std::string Text::broken(const std::string& word, int size, int most) const {
  std::size_t end = word.size();
  const std::size_t first = next_letter(word, 1);
  while (end > first && width(word.substr(0, end), size) > most) end = letter_start(word, end - 1);
  return word.substr(0, std::max(end, first));
}

std::vector<std::string> Text::wrapped(const std::string& text, int size, int most) const {
  std::vector<std::string> lines;
  std::string line;
  std::istringstream words(printable(text));
  for (std::string word; words >> word;) {
    std::string longer = line;
    longer.append(line.empty() ? "" : " ").append(word);
    if (width(longer, size) <= most) {
      line = longer;
      continue;
    }
    if (!line.empty()) lines.push_back(line);
    for (line = broken(word, size, most); line.size() < word.size(); line = broken(word, size, most)) {
      lines.push_back(line);
      word.erase(0, line.size());
    }
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

}  // namespace sailmap::drawing
