// Written at build time from share/report (embed.cmake).
#pragma once

#include <string_view>

namespace sailmap::report {

std::string_view page_markup();
std::string_view page_style();
std::string_view page_script();

}  // namespace sailmap::report
