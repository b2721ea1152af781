// The page's data, part by part.
#pragma once

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "pairs.hpp"
#include "pictures.hpp"
#include "subject.hpp"

namespace sailmap::report {

// What could not be done, for the page. Images that cannot be read are counted and the first few named.
class Problems {
 public:
  void add(const std::string& problem) { others_.push_back(problem); }
  void add_image(int image, const std::string& fault);
  [[nodiscard]] nlohmann::ordered_json json() const;

 private:
  std::set<int> images_;
  std::vector<std::string> faults_;
  std::vector<std::string> others_;
};

// {"count", "prefix", "names"}: the folder that all have in common is kept once.
nlohmann::ordered_json names_of(const std::vector<std::string>& names);

// Columns: {"image", "place", "score", "rival", "rival_score", "margin", "right", "regions"}; null where not
// known.
nlohmann::ordered_json loops_of(const Subject& subject);

// Columns, an entry an image: {"node", "best": first image of the best node, "score", "reason"}, and
// "reasons": what the numbers of the last column mean.
nlohmann::ordered_json history_of(const TopologicalMap& map);

struct Shown {
  nlohmann::ordered_json pairs = nlohmann::ordered_json::array();
  nlohmann::ordered_json pictures = nlohmann::ordered_json::object();  // by image
  std::size_t bytes = 0;
  std::string left_out;  // empty, or what the budget did not allow
};

// The loops `picks`, the images asked for, and some more evenly over the sequence, until the budget is used
// up. Where an image file is missing, the thumbnail that the map's file may have is shown.
Shown show(const Subject& subject, const std::vector<Pick>& picks, const ReportOptions& options,
           const StoredSignatures& stored, Looker& looker, Problems& problems);

}  // namespace sailmap::report
