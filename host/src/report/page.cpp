#include "page.hpp"

#include <fmt/format.h>

#include <random>
#include <string_view>

#include "figures/graph_drawing.hpp"
#include "page_sources.hpp"

namespace sailmap::report {
namespace {

using nlohmann::ordered_json;

// Scripts and styles without it do not run: should text ever come to be read as markup, it stays dead.
std::string random_nonce() {
  std::random_device random;
  std::string out;
  for (int k = 0; k < 4; ++k) out += fmt::format("{:08x}", random());
  return out;
}

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

std::string assemble(const ordered_json& data, std::string_view may_connect) {
  const std::string nonce = random_nonce();
  const std::string policy = fmt::format(
      "default-src 'none'; img-src data:{0}; script-src 'nonce-{1}'; style-src 'nonce-{1}'; base-uri 'none'; "
      "form-action 'none'{2}",
      may_connect.empty() ? "" : " 'self'", nonce, may_connect);
  std::string markup(page_markup());
  markup = replaced(markup, "%POLICY%", policy);
  markup = replaced(markup, "%NONCE%", nonce);
  const auto title = data.find("title");
  const std::string heading = title == data.end() ? "sailmap" : title->get<std::string>();
  const std::string json = replaced(dump(data), "<", "\\u003c");
  // In the order they stand in; what is put in is not looked through again.
  std::string out;
  std::size_t from = 0;
  const auto put = [&](std::string_view mark, std::string_view content) {
    const std::size_t at = markup.find(mark, from);
    out.append(markup, from, at - from).append(content);
    from = at + mark.size();
  };
  put("%TITLE%", GraphDrawing::escaped(heading));
  put("%STYLE%", page_style());
  put("%DATA%", json);
  put("%SCRIPT%", page_script());
  return out.append(markup, from, std::string::npos);
}

}  // namespace

std::string dump(const ordered_json& data) {
  return data.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

std::string page(const ordered_json& data) { return assemble(data, ""); }

std::string live_page(const ordered_json& data) { return assemble(data, "; connect-src 'self'"); }

}  // namespace sailmap::report
