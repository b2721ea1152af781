// Rows into an open map file, each kind by a statement that is prepared once.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <string>
#include <tuple>

#include "row_io.hpp"
#include "sailmap/map_store.hpp"

namespace sailmap::store {

class RowWriter {
 public:
  // The tables are there.
  explicit RowWriter(SQLite::Database& database)
      : statements_(Prepared<MapRow>(database), Prepared<SessionRow>(database), Prepared<ImageRow>(database),
                    Prepared<SignatureRow>(database), Prepared<DetectionRow>(database),
                    Prepared<ThumbnailRow>(database), Prepared<NodeRow>(database),
                    Prepared<EdgeRow>(database)) {}

  template <class Row>
  void put(Row row) {
    insert(std::get<Prepared<Row>>(statements_).statement, std::move(row));
  }

  // An image and what came of it. `signature`: null when it is not known.
  void put_image(const Update& update, bool is_view, const Signature* signature, const ImageNote& note);
  void put_edge(int id, const Edge& edge) {
    put(EdgeRow{id, edge.from, edge.to, std::string(name(edge.kind))});
  }
  void put_map(const MapConfig& config, const std::string& frontend);

 private:
  template <class Row>
  struct Prepared {
    explicit Prepared(SQLite::Database& database) : statement(database, insert_statement<Row>()) {}
    SQLite::Statement statement;
  };

  std::tuple<Prepared<MapRow>, Prepared<SessionRow>, Prepared<ImageRow>, Prepared<SignatureRow>,
             Prepared<DetectionRow>, Prepared<ThumbnailRow>, Prepared<NodeRow>, Prepared<EdgeRow>>
      statements_;
};

// All of a map, in a transaction of the caller; the tables are there and empty.
void write_map(SQLite::Database& database, const TopologicalMap& map, const std::string& frontend);

}  // namespace sailmap::store
