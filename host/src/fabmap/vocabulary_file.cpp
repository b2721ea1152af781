// The vocabulary as a JSON document.
#include <cmath>
#include <nlohmann/json.hpp>

#include "../io/file_reading.hpp"
#include "check.hpp"
#include "sailmap/fabmap.hpp"
#include "sailmap/file.hpp"

namespace sailmap::fabmap {
namespace {

using nlohmann::ordered_json;

constexpr const char* format_name = "sailmap fabmap vocabulary";
constexpr int format_version = 1;
constexpr int descriptor_size = 128;  // of SIFT

ordered_json to_json(const cv::Mat& centres) {
  ordered_json rows = ordered_json::array();
  for (int y = 0; y < centres.rows; ++y) {
    rows.push_back(std::vector<float>(centres.ptr<float>(y), centres.ptr<float>(y) + centres.cols));
  }
  return rows;
}

cv::Mat centres_from(const ordered_json& rows) {
  cv::Mat out(static_cast<int>(rows.size()), descriptor_size, CV_32F);
  for (int y = 0; y < out.rows; ++y) {
    const auto row = rows.at(static_cast<std::size_t>(y)).get<std::vector<float>>();
    if (row.size() != descriptor_size) throw Error("a word is not of 128 numbers");
    std::copy(row.begin(), row.end(), out.ptr<float>(y));
  }
  return out;
}

ordered_json to_json(const ChowLiuTree& tree) {
  ordered_json nodes = ordered_json::array();
  for (const TreeNode& node : tree) {
    nodes.push_back({node.parent, node.marginal, node.given_parent, node.given_no_parent});
  }
  return nodes;
}

ChowLiuTree tree_from(const ordered_json& nodes) {
  ChowLiuTree tree;
  for (const ordered_json& node : nodes) {
    tree.push_back({node.at(0).get<int>(), node.at(1).get<double>(), node.at(2).get<double>(),
                    node.at(3).get<double>()});
  }
  return tree;
}

Vocabulary vocabulary_from(const ordered_json& json) {
  if (json.at("format") != format_name) throw Error("not a sailmap vocabulary");
  if (json.at("version") != format_version) {
    throw Error("vocabulary format version " + json.at("version").dump() + ", this program reads version " +
                std::to_string(format_version));
  }
  Vocabulary out{centres_from(json.at("centres")), tree_from(json.at("tree")),
                 json.at("training").get<std::vector<Words>>(), json.at("features").get<int>()};
  if (out.centres.rows < 2 || out.tree.size() != static_cast<std::size_t>(out.centres.rows)) {
    throw Error(std::to_string(out.centres.rows) + " words but a tree of " + std::to_string(out.tree.size()));
  }
  if (out.training.empty()) throw Error("no training image");
  if (out.features < 1) throw Error(std::to_string(out.features) + " features an image");
  for (const Words& words : out.training) check_words(words, out.tree.size());
  const Places checks_the_tree(out.tree, {});
  return out;
}

}  // namespace

void write_vocabulary(const std::filesystem::path& path, const Vocabulary& vocabulary) {
  const ordered_json json = {{"format", format_name},
                             {"version", format_version},
                             {"features", vocabulary.features},
                             {"centres", to_json(vocabulary.centres)},
                             {"tree", to_json(vocabulary.tree)},
                             {"training", vocabulary.training}};
  write_file(path, [&json](std::ostream& out) { out << json.dump() << '\n'; });
}

Vocabulary read_vocabulary(const std::filesystem::path& path) {
  std::ifstream in = io::open_for_reading(path);
  try {
    return vocabulary_from(ordered_json::parse(in));
  } catch (const ordered_json::exception& fault) {
    throw Error(path.string() + ": not a sailmap vocabulary, or a damaged one: " + fault.what());
  } catch (const Error& fault) {
    throw Error(path.string() + ": " + fault.what());
  }
}

}  // namespace sailmap::fabmap
