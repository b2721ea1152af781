#include "map_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "map/config_json.hpp"

namespace sailmap::app {
namespace {

using nlohmann::ordered_json;

// The images of one map by number.
class Keys {
 public:
  explicit Keys(const TopologicalMap& map) : map_(map) {
    std::map<std::string, int> seen;
    for (const Update& update : map.history()) keys_.push_back({update.name, ++seen[update.name]});
  }

  [[nodiscard]] const std::vector<ImageKey>& images() const { return keys_; }
  [[nodiscard]] const ImageKey& of_node(int node) const {
    const int image = map_.nodes()[static_cast<std::size_t>(node)].views.front().image;
    return keys_[static_cast<std::size_t>(image)];
  }

  [[nodiscard]] std::vector<ImageKey> nodes() const {
    std::vector<ImageKey> out;
    for (const Node& node : map_.nodes()) out.push_back(of_node(node.id));
    return out;
  }

  [[nodiscard]] std::vector<EdgeOfImages> edges() const {
    std::vector<EdgeOfImages> out;
    for (const Edge& edge : map_.edges()) out.push_back({of_node(edge.from), of_node(edge.to), edge.kind});
    return out;
  }

  // Of the images that the nodes keep.
  [[nodiscard]] std::map<ImageKey, const Signature*> signatures() const {
    std::map<ImageKey, const Signature*> out;
    for (const Node& node : map_.nodes()) {
      for (const View& view : node.views)
        out.emplace(keys_[static_cast<std::size_t>(view.image)], &view.signature);
    }
    return out;
  }

  [[nodiscard]] std::map<ImageKey, DetectionOfImage> detections() const {
    std::map<ImageKey, DetectionOfImage> out;
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      const Detection& d = map_.history()[i].detection;
      DetectionOfImage detection{d.reason, std::nullopt, d.best.similarity};
      if (d.best.node >= 0) detection.node = of_node(d.best.node);
      out.emplace(keys_[i], detection);
    }
    return out;
  }

 private:
  const TopologicalMap& map_;
  std::vector<ImageKey> keys_;
};

// In the order of each list.
template <class T>
OnlyIn<T> only_in(const std::vector<T>& a, const std::vector<T>& b) {
  const std::set<T> in_a(a.begin(), a.end());
  const std::set<T> in_b(b.begin(), b.end());
  OnlyIn<T> out;
  std::ranges::copy_if(a, std::back_inserter(out.a), [&](const T& item) { return !in_b.contains(item); });
  std::ranges::copy_if(b, std::back_inserter(out.b), [&](const T& item) { return !in_a.contains(item); });
  return out;
}

std::vector<ImageKey> changed_regions(const Keys& a, const Keys& b) {
  const std::map<ImageKey, const Signature*> in_a = a.signatures();
  const std::map<ImageKey, const Signature*> in_b = b.signatures();
  std::vector<ImageKey> out;
  for (const ImageKey& image : a.images()) {
    const auto one = in_a.find(image);
    const auto other = in_b.find(image);
    if (one == in_a.end() || other == in_b.end() || *one->second == *other->second) continue;
    out.push_back(image);
  }
  return out;
}

std::vector<ParameterChange> changed_parameters(const StoredMap& a, const StoredMap& b) {
  ordered_json of_a = {{"frontend", a.frontend}};
  ordered_json of_b = {{"frontend", b.frontend}};
  of_a.update(to_json(a.map.config()));
  of_b.update(to_json(b.map.config()));
  std::vector<ParameterChange> out;
  const ordered_json flat_a = of_a.flatten();
  const ordered_json flat_b = of_b.flatten();
  for (const auto& [key, value] : flat_a.items()) {
    if (value == flat_b.at(key)) continue;
    std::string parameter = key.substr(1);
    std::ranges::replace(parameter, '/', '.');
    out.push_back({parameter, value, flat_b.at(key)});
  }
  return out;
}

bool same(const DetectionOfImage& a, const DetectionOfImage& b, double tolerance) {
  if (a.reason != b.reason || a.node != b.node) return false;
  const double larger = std::max(std::abs(a.similarity), std::abs(b.similarity));
  return !(std::abs(a.similarity - b.similarity) > tolerance * larger);
}

}  // namespace

std::string text_of(const ImageKey& key) {
  return key.occurrence == 1 ? key.name : key.name + " (no. " + std::to_string(key.occurrence) + ")";
}

bool MapComparison::equal() const {
  return parameters.empty() && images.empty() && regions.empty() && nodes.empty() && edges.empty() &&
         detections.empty();
}

MapComparison compare(const StoredMap& a, const StoredMap& b, double tolerance) {
  const Keys of_a(a.map);
  const Keys of_b(b.map);
  MapComparison out;
  out.parameters = changed_parameters(a, b);
  out.images = only_in(of_a.images(), of_b.images());
  out.regions = changed_regions(of_a, of_b);
  out.nodes = only_in(of_a.nodes(), of_b.nodes());
  out.edges = only_in(of_a.edges(), of_b.edges());
  const std::map<ImageKey, DetectionOfImage> in_a = of_a.detections();
  const std::map<ImageKey, DetectionOfImage> in_b = of_b.detections();
  for (const ImageKey& image : of_a.images()) {
    const auto other = in_b.find(image);
    if (other == in_b.end() || same(in_a.at(image), other->second, tolerance)) continue;
    out.detections.push_back({image, in_a.at(image), other->second});
  }
  return out;
}

}  // namespace sailmap::app
