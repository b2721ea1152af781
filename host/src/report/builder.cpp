#include "builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgcodecs.hpp>

#include "sailmap/error.hpp"
#include "sailmap/map_store.hpp"

namespace sailmap::report {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t faults_named = 8;
constexpr int pair_side = 400;       // longer side of an image of a pair, pixels
constexpr int thumbnail_side = 240;  // of the others

// Folder part, with its separator, that all names begin with.
std::string common_folder(const std::vector<std::string>& names) {
  if (names.empty()) return "";
  std::string prefix = names.front();
  for (const std::string& name : names) {
    const auto end = std::ranges::mismatch(prefix, name);
    prefix.erase(end.in1, prefix.end());
  }
  const std::size_t separator = prefix.rfind('/');
  return separator == std::string::npos ? "" : prefix.substr(0, separator + 1);
}

// Numbers below `count` such that any beginning of the list is spread evenly: the bits of a counter reversed.
std::vector<int> evenly(int count) {
  std::vector<int> out;
  int bits = 0;
  while ((1 << bits) < count) ++bits;
  for (int k = 0; k < (1 << bits); ++k) {
    int reversed = 0;
    for (int b = 0; b < bits; ++b) reversed |= ((k >> b) & 1) << (bits - 1 - b);
    if (reversed < count) out.push_back(reversed);
  }
  return out;
}

// Fills Shown; remembers what was looked at and failed.
class Showing {
 public:
  Showing(const Subject& subject, const ReportOptions& options, const StoredSignatures& stored,
          Looker& looker, Problems& problems)
      : subject_(subject), options_(options), stored_(stored), looker_(looker), problems_(problems) {}

  Shown run(const std::vector<Pick>& picks) {
    std::size_t shown = 0;
    for (; shown < picks.size() && !full(); ++shown) add_pair(picks[shown]);
    if (shown < picks.size()) {
      out_.left_out = fmt::format("{} of {} loops chosen for pictures", picks.size() - shown, picks.size());
    }
    for (const int image : options_.images) add_picture(image, thumbnail_side);
    add_thumbnails();
    return std::move(out_);
  }

 private:
  [[nodiscard]] bool full() const { return out_.bytes >= options_.budget; }
  [[nodiscard]] bool has(int image) const { return out_.pictures.contains(std::to_string(image)); }

  [[nodiscard]] const std::string& name(int image) const {
    return subject_.names[static_cast<std::size_t>(image)];
  }

  // nullptr when the image cannot be read, which is then on the page.
  std::unique_ptr<Look> look(int image) {
    if (failed_.contains(image)) return nullptr;
    try {
      return std::make_unique<Look>(looker_.look(name(image)));
    } catch (const Error& fault) {
      auto thumbnail = look_at_thumbnail(image);
      if (thumbnail) return thumbnail;
      failed_.insert(image);
      problems_.add_image(image, fault.what());
      return nullptr;
    }
  }

  // What the map's file keeps of an image, if it does.
  [[nodiscard]] std::unique_ptr<Look> look_at_thumbnail(int image) const {
    const Signature* signature = stored_.of(image);
    if (options_.store == nullptr || signature == nullptr) return nullptr;
    const std::vector<unsigned char> jpeg = options_.store->thumbnail(image);
    if (jpeg.empty()) return nullptr;
    auto look = std::make_unique<Look>();
    look->image = cv::imdecode(jpeg, cv::IMREAD_COLOR);
    look->signature = *signature;
    if (look->image.empty()) return nullptr;
    return look;
  }

  void keep(int image, const Look& look, int side) {
    if (has(image)) return;
    ordered_json picture = picture_of(look, side);
    out_.bytes += picture.dump().size();
    out_.pictures[std::to_string(image)] = std::move(picture);
  }

  bool add_picture(int image, int side) {
    if (has(image)) return true;
    const auto looked = look(image);
    if (looked) keep(image, *looked, side);
    return looked != nullptr;
  }

  void add_pair(const Pick& pick) {
    const Loop& loop = subject_.loops[pick.loop];
    const auto image = look(loop.image);
    const int view =
        image ? best_view(loop, image->signature, stored_, subject_.config.match) : loop.views.front();
    const auto place = look(view);
    if (image) keep(loop.image, *image, pair_side);
    if (place) keep(view, *place, pair_side);
    ordered_json entry = {{"loop", pick.loop}, {"why", pick.why}};
    try {
      if (image && place)
        entry.update(pair_of(loop, {view, name(loop.image), name(view)}, *image, *place, subject_));
    } catch (const Error& fault) {
      problems_.add(fault.what());
    }
    if (!entry.contains("view")) entry["view"] = view;
    out_.pairs.push_back(std::move(entry));
    if (loop.rival >= 0) add_picture(loop.rival, thumbnail_side);
  }

  void add_thumbnails() {
    int added = 0;
    int failures = 0;
    // Images that made nodes are what a person clicks on.
    std::vector<int> images;
    for (int i = 0; i < static_cast<int>(subject_.names.size()); ++i) {
      if (subject_.map == nullptr || stored_.of(i) != nullptr) images.push_back(i);
    }
    for (const int k : evenly(static_cast<int>(images.size()))) {
      // A sequence that is not there need not be looked for to its end.
      if (added >= options_.thumbnails || failures > 2 * options_.thumbnails) return;
      const int image = images[static_cast<std::size_t>(k)];
      if (has(image)) continue;
      if (full()) {
        if (out_.left_out.empty()) out_.left_out = "thumbnails of further images";
        return;
      }
      ++(add_picture(image, thumbnail_side) ? added : failures);
    }
  }

  const Subject& subject_;
  const ReportOptions& options_;
  const StoredSignatures& stored_;
  Looker& looker_;
  Problems& problems_;
  Shown out_;
  std::set<int> failed_;
};

ordered_json or_null(bool known, double value) {
  return known ? ordered_json(shortened(value)) : ordered_json();
}

}  // namespace

void Problems::add_image(int image, const std::string& fault) {
  if (images_.insert(image).second && faults_.size() < faults_named) faults_.push_back(fault);
}

ordered_json Problems::json() const {
  ordered_json out = ordered_json::array();
  for (const std::string& problem : others_) out.push_back(problem);
  if (!images_.empty()) {
    out.push_back(fmt::format("{} image{} could not be read and {} not shown{}", images_.size(),
                              images_.size() == 1 ? "" : "s", images_.size() == 1 ? "is" : "are",
                              images_.size() > faults_.size() ? ", among them:" : ":"));
  }
  for (const std::string& fault : faults_) out.push_back(fault);
  return out;
}

ordered_json names_of(const std::vector<std::string>& names) {
  const std::string folder = common_folder(names);
  ordered_json list = ordered_json::array();
  for (const std::string& name : names) list.push_back(name.substr(folder.size()));
  return {{"count", names.size()}, {"prefix", folder}, {"names", std::move(list)}};
}

ordered_json loops_of(const Subject& subject) {
  ordered_json out;
  for (const char* key : {"image", "place", "score", "rival", "rival_score", "margin", "right", "regions"}) {
    out[key] = ordered_json::array();
  }
  for (const Loop& loop : subject.loops) {
    const bool has_rival = loop.rival >= 0;
    out["image"].push_back(loop.image);
    out["place"].push_back(loop.views.front());
    out["score"].push_back(shortened(loop.score));
    out["rival"].push_back(has_rival ? ordered_json(loop.rival) : ordered_json());
    out["rival_score"].push_back(or_null(has_rival, loop.rival_score));
    out["margin"].push_back(shortened(margin(loop, subject.threshold)));
    out["right"].push_back(loop.right ? ordered_json(*loop.right) : ordered_json());
    out["regions"].push_back(loop.matches ? ordered_json(loop.matches->size()) : ordered_json());
  }
  return out;
}

ordered_json history_of(const TopologicalMap& map) {
  ordered_json out;
  for (const char* key : {"node", "best", "score", "reason", "reasons"}) out[key] = ordered_json::array();
  std::map<Reason, int> number_of;
  for (const Update& update : map.history()) {
    const Detection& d = update.detection;
    const bool found = d.best.node >= 0;
    const auto [number, is_new] = number_of.emplace(d.reason, static_cast<int>(number_of.size()));
    if (is_new) out["reasons"].push_back(name(d.reason));
    out["node"].push_back(update.node);
    out["best"].push_back(
        found ? ordered_json(map.nodes()[static_cast<std::size_t>(d.best.node)].views.front().image)
              : ordered_json());
    out["score"].push_back(or_null(found, d.best.similarity));
    out["reason"].push_back(number->second);
  }
  return out;
}

Shown show(const Subject& subject, const std::vector<Pick>& picks, const ReportOptions& options,
           const StoredSignatures& stored, Looker& looker, Problems& problems) {
  return Showing(subject, options, stored, looker, problems).run(picks);
}

}  // namespace sailmap::report
