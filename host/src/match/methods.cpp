#include <string>

#include "sailmap/error.hpp"
#include "sailmap/similarity.hpp"

namespace sailmap {
namespace {

struct Entry {
  std::string_view name;
  Method method;
};
constexpr Entry entries[] = {
    {"paper_weighted", Method::paper_weighted}, {"paper", Method::paper}, {"context", Method::context}};

}  // namespace

std::string_view name(Method method) {
  for (const Entry& entry : entries) {
    if (entry.method == method) return entry.name;
  }
  throw Error("unknown method number " + std::to_string(static_cast<int>(method)));
}

Method method_from_name(std::string_view name) {
  std::string known;
  for (const Entry& entry : entries) {
    if (entry.name == name) return entry.method;
    known += (known.empty() ? "" : ", ") + std::string(entry.name);
  }
  throw Error("no method '" + std::string(name) + "'; there are: " + known);
}

std::vector<std::string_view> method_names() {
  std::vector<std::string_view> names;
  for (const Entry& entry : entries) names.push_back(entry.name);
  return names;
}

}  // namespace sailmap
