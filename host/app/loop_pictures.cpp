#include "loop_pictures.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <optional>

#include "describe_image.hpp"
#include "progress.hpp"
#include "sailmap/context.hpp"
#include "sailmap/error.hpp"
#include "sailmap/figures.hpp"
#include "sailmap/file.hpp"

namespace sailmap::app {
namespace {

namespace fs = std::filesystem;

// A picture, or what was wrong with its images. Writing it may fail for good; reading them may not.
struct Drawn {
  cv::Mat picture;
  std::string fault;
};

class LoopDrawer {
 public:
  LoopDrawer(const StoredMap& stored, const PictureOptions& options)
      : map_(stored.map), options_(options), frontend_(make_frontend_without_hardware(stored.frontend)) {}

  // The pair is described and matched anew: a dense map does not keep the signatures of images that closed a
  // loop. `update` has a best node.
  Drawn draw(const Update& update) {
    try {
      const DescribedImage query = describe(update.name);
      const View& view = view_matched(update, query.signature);
      const DescribedImage candidate = describe(view.name);
      const MapConfig& config = map_.config();
      const MatchResult found = match(query.signature, candidate.signature, config.match);
      if (found.matches.size() != update.detection.matches.size()) {
        spdlog::warn("{} or {} has changed since the map was made: {} regions matched then, {} now",
                     update.name, view.name, update.detection.matches.size(), found.matches.size());
      }
      return {match_figure(query.image, candidate.image, shown(query.signature), shown(candidate.signature),
                           found, config.regions.box_side, verdict(update, view)),
              {}};
    } catch (const Error& fault) {
      return {{}, fault.what()};
    }
  }

 private:
  DescribedImage describe(const std::string& name) {
    return describe_image((options_.images / name).string(), *frontend_, map_.config().regions);
  }

  [[nodiscard]] const View& view_matched(const Update& update, const Signature& query) const {
    const auto& views = map_.nodes()[static_cast<std::size_t>(update.detection.best.node)].views;
    const View* best = &views.front();
    if (views.size() == 1) return *best;
    double highest = 0;
    for (const View& view : views) {
      // A sparse node holds the image itself when it closed a loop there.
      if (view.image >= update.image) continue;
      const double similarity = match(query, view.signature, map_.config().match).similarity;
      if (similarity > highest) best = &view;
      highest = std::max(highest, similarity);
    }
    return *best;
  }

  [[nodiscard]] Signature shown(const Signature& signature) const {
    return map_.config().match.method == Method::context ? with_context_regions(signature) : signature;
  }

  [[nodiscard]] std::string verdict(const Update& update, const View& view) const {
    const Detection& d = update.detection;
    std::string text = fmt::format("image {} ({}), node {} ({}): {}, similarity {:.4g}, threshold {:g}",
                                   update.image, update.name, d.best.node, view.name, name(d.reason),
                                   d.best.similarity, map_.config().detection.threshold);
    if (d.runner_up.node >= 0) {
      text += fmt::format("; runner-up node {}: {:.4g}", d.runner_up.node, d.runner_up.similarity);
    }
    return text;
  }

  const TopologicalMap& map_;
  const PictureOptions& options_;
  std::unique_ptr<Frontend> frontend_;
};

}  // namespace

std::vector<std::string> draw_loops(const StoredMap& stored, const std::vector<const Update*>& loops,
                                    const PictureOptions& options, int& failed) {
  make_folder(options.folder);
  LoopDrawer drawer(stored, options);
  Progress progress("pictures", static_cast<int>(loops.size()));
  std::vector<std::string> files;
  for (const Update* update : loops) {
    std::string& file = files.emplace_back();
    if (update->detection.best.node >= 0) {
      const Drawn drawn = drawer.draw(*update);
      if (drawn.fault.empty()) {
        const fs::path path = options.folder / fmt::format("image_{:06}_node_{:06}.png", update->image,
                                                           update->detection.best.node);
        write_image(path, drawn.picture);
        file = path.string();
      } else {
        progress.clear();
        spdlog::error("{}", drawn.fault);
        ++failed;
      }
    }
    progress.step_to(static_cast<int>(files.size()));
  }
  return files;
}

}  // namespace sailmap::app
