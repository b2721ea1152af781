// One writer a format.
#pragma once

#include <ostream>

#include "sailmap/map_export.hpp"

namespace sailmap {

void write_dot(const TopologicalMap& map, std::ostream& out, const ExportOptions& options);
void write_graphml(const TopologicalMap& map, std::ostream& out, const ExportOptions& options);
void write_g2o(const TopologicalMap& map, std::ostream& out, const ExportOptions& options);
void write_tum(const TopologicalMap& map, std::ostream& out, const ExportOptions& options);
void write_kitti(const TopologicalMap& map, std::ostream& out, const ExportOptions& options);
void write_csv(const TopologicalMap& map, std::ostream& out, const ExportOptions& options);
void write_json(const TopologicalMap& map, std::ostream& out, const ExportOptions& options);

}  // namespace sailmap
