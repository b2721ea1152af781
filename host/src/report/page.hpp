// The HTML page: fixed sources (share/report, embedded at build time) and data.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace sailmap::report {

// The whole page, which asks nothing of anything. `data` is put in as JSON that cannot end its element;
// whatever text it holds, the page's scripts show it as text.
std::string page(const nlohmann::ordered_json& data);

// The same page, allowed to ask the server it came from.
std::string live_page(const nlohmann::ordered_json& data);

// One line; what is not UTF-8 is replaced.
std::string dump(const nlohmann::ordered_json& data);

}  // namespace sailmap::report
