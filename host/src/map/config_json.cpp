#include "config_json.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "io/json_numbers.hpp"
#include "sailmap/error.hpp"

namespace sailmap {

using io::single;
using io::whole_number;
using nlohmann::ordered_json;

std::string_view name(Inhibition inhibition) {
  switch (inhibition) {
    case Inhibition::box:
      return "box";
    case Inhibition::disk:
      return "disk";
    case Inhibition::gaussian:
      return "gaussian";
  }
  throw Error("unknown inhibition number " + std::to_string(static_cast<int>(inhibition)));
}

Inhibition inhibition_from_name(std::string_view text) {
  for (const Inhibition value : {Inhibition::box, Inhibition::disk, Inhibition::gaussian}) {
    if (name(value) == text) return value;
  }
  throw Error("no inhibition '" + std::string(text) + "'; there are: box, disk, gaussian");
}

std::string_view name(DescriptorKind kind) {
  return kind == DescriptorKind::conspicuity ? "conspicuity" : "background";
}

DescriptorKind descriptor_kind_from_name(std::string_view text) {
  if (text == "conspicuity") return DescriptorKind::conspicuity;
  if (text == "background") return DescriptorKind::background;
  throw Error("no descriptor '" + std::string(text) + "'; there are: conspicuity, background");
}

std::string_view name(SignatureMaker maker) { return maker == SignatureMaker::host ? "host" : "chip"; }

SignatureMaker signature_maker_from_name(std::string_view text) {
  if (text == "host") return SignatureMaker::host;
  if (text == "chip") return SignatureMaker::chip;
  throw Error("no signature by '" + std::string(text) + "'; there are: host, chip");
}

ordered_json to_json(const MapConfig& config) {
  const RegionConfig& r = config.regions;
  const MatchConfig& m = config.match;
  const DetectionConfig& d = config.detection;
  return {{"regions",
           {{"max_regions", r.max_regions},
            {"stop_ratio", r.stop_ratio},
            {"box_side", r.box_side},
            {"inhibition", name(r.inhibition)},
            {"inhibition_radius", r.inhibition_radius},
            {"descriptor", name(r.descriptor)},
            {"signature", name(r.signature)}}},
          {"match",
           {{"method", name(m.method)},
            {"search_radius", m.search_radius},
            {"displacement_tolerance", m.displacement_tolerance},
            {"similarity_cap", m.similarity_cap}}},
          {"detection",
           {{"threshold", d.threshold},
            {"min_matches", d.min_matches},
            {"ambiguity_ratio", d.ambiguity_ratio},
            {"same_place_nodes", d.same_place_nodes},
            {"ranked_nodes", d.ranked_nodes}}},
          {"exclude_recent", config.exclude_recent},
          {"loop_edges", config.loop_edges},
          {"sparse", config.sparse},
          {"sparse_threshold", config.sparse_threshold},
          {"temporal", config.temporal}};
}

MapConfig map_config_from_json(const ordered_json& json) {
  MapConfig config;
  const auto& r = json.at("regions");
  config.regions.max_regions = whole_number(r.at("max_regions"));
  r.at("stop_ratio").get_to(config.regions.stop_ratio);
  config.regions.box_side = whole_number(r.at("box_side"));
  config.regions.inhibition = inhibition_from_name(r.at("inhibition").get<std::string>());
  r.at("inhibition_radius").get_to(config.regions.inhibition_radius);
  config.regions.descriptor = descriptor_kind_from_name(r.at("descriptor").get<std::string>());
  // Not in maps made before the hardware made signatures.
  if (r.contains("signature")) {
    config.regions.signature = signature_maker_from_name(r.at("signature").get<std::string>());
  }
  const auto& m = json.at("match");
  config.match.method = method_from_name(m.at("method").get<std::string>());
  config.regions.describe_place = config.match.method == Method::context;
  m.at("search_radius").get_to(config.match.search_radius);
  m.at("displacement_tolerance").get_to(config.match.displacement_tolerance);
  m.at("similarity_cap").get_to(config.match.similarity_cap);
  const auto& d = json.at("detection");
  d.at("threshold").get_to(config.detection.threshold);
  config.detection.min_matches = whole_number(d.at("min_matches"));
  d.at("ambiguity_ratio").get_to(config.detection.ambiguity_ratio);
  config.detection.same_place_nodes = whole_number(d.at("same_place_nodes"));
  // Not in maps that ranked all nodes whatever their number; no verdict depends on it.
  if (d.contains("ranked_nodes")) config.detection.ranked_nodes = whole_number(d.at("ranked_nodes"));
  config.exclude_recent = whole_number(json.at("exclude_recent"));
  json.at("loop_edges").get_to(config.loop_edges);
  json.at("sparse").get_to(config.sparse);
  json.at("sparse_threshold").get_to(config.sparse_threshold);
  // Not in maps made before there was a filter.
  config.temporal = json.contains("temporal") ? whole_number(json.at("temporal")) : 0;
  return config;
}

ordered_json to_json(const Signature& signature) {
  ordered_json regions = ordered_json::array();
  for (const Region& region : signature.regions) {
    regions.push_back(
        {{"x", region.x}, {"y", region.y}, {"saliency", region.saliency}, {"descriptor", region.descriptor}});
  }
  ordered_json json = {
      {"width", signature.width}, {"height", signature.height}, {"regions", std::move(regions)}};
  if (signature.place.get() != PlaceDescriptor{}) json["place"] = to_text(signature.place);
  return json;
}

namespace {

// Of a region, on an image of so many pixels along this axis.
std::int16_t coordinate_from_json(const ordered_json& json, int pixels) {
  const int value = whole_number(json);
  if (value < 0 || value >= pixels || value > std::numeric_limits<std::int16_t>::max()) {
    throw Error("a region's position is not a pixel of the image: " + json.dump());
  }
  return static_cast<std::int16_t>(value);
}

}  // namespace

Signature signature_from_json(const ordered_json& json) {
  Signature signature{whole_number(json.at("width")), whole_number(json.at("height")), {}};
  if (signature.width < 1 || signature.height < 1) throw Error("an image without pixels");
  for (const auto& region : json.at("regions")) {
    const auto& descriptor = region.at("descriptor");
    if (descriptor.size() != feature_count) throw Error("a descriptor has not ten numbers");
    Region& out =
        signature.regions.emplace_back(Region{coordinate_from_json(region.at("x"), signature.width),
                                              coordinate_from_json(region.at("y"), signature.height),
                                              single(region.at("saliency")),
                                              {}});
    for (std::size_t i = 0; i < feature_count; ++i) out.descriptor[i] = single(descriptor.at(i));
  }
  if (json.contains("place")) signature.place = place_from_text(json.at("place").get<std::string>());
  return signature;
}

namespace {

ordered_json to_json(const Candidate& candidate) {
  if (candidate.node < 0) return nullptr;
  return {{"node", candidate.node}, {"similarity", candidate.similarity}};
}

Candidate candidate_from_json(const ordered_json& json) {
  if (json.is_null()) return {};
  return {whole_number(json.at("node")), json.at("similarity").get<double>()};
}

}  // namespace

ordered_json to_json(const Detection& detection) {
  ordered_json matches = ordered_json::array();
  for (const RegionMatch& m : detection.matches) {
    matches.push_back({{"query", m.query}, {"candidate", m.candidate}, {"distance", m.distance}});
  }
  return {{"reason", name(detection.reason)},
          {"best", to_json(detection.best)},
          {"runner_up", to_json(detection.runner_up)},
          {"matches", std::move(matches)}};
}

Detection detection_from_json(const ordered_json& json) {
  Detection detection;
  detection.reason = reason_from_name(json.at("reason").get<std::string>());
  detection.best = candidate_from_json(json.at("best"));
  detection.runner_up = candidate_from_json(json.at("runner_up"));
  for (const auto& m : json.at("matches")) {
    detection.matches.push_back(
        {whole_number(m.at("query")), whole_number(m.at("candidate")), m.at("distance").get<double>()});
  }
  return detection;
}

}  // namespace sailmap
