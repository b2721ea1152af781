#include <chrono>
#include <utility>

#include "connection.hpp"
#include "json_map.hpp"
#include "read_map.hpp"
#include "replace_file.hpp"
#include "sailmap/map_store.hpp"
#include "schema.hpp"
#include "write_lock.hpp"
#include "write_rows.hpp"

namespace sailmap {

using namespace store;

namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

}  // namespace

struct MapWriter::State {
  explicit State(std::filesystem::path file) : path(std::move(file)), lock(path) {
    if (is_json(path)) migrate_json();
    connection = connect_to_write(path);
    is_new = is_blank(*connection);
    if (!is_new) check_schema(*connection);
  }

  // The lock is then that of the new file.
  void migrate_json() {
    const StoredMap stored = read_json_map(path);
    replace_file(path, [&](SQLite::Database& database) { write_map(database, stored.map, stored.frontend); });
    lock.follow();
  }

  // The tables of a new file come to be with its first image.
  RowWriter& rows() {
    if (!row_writer) begin_writing(*connection);
    if (!transaction) transaction.emplace(*connection, SQLite::TransactionBehavior::IMMEDIATE);
    if (!row_writer) {
      if (is_new) create_schema(*connection);
      row_writer.emplace(*connection);
    }
    return *row_writer;
  }

  void put_session() {
    session.images = images - session.first_image;
    rows().put(session);
  }

  void commit() {
    if (!transaction) return;
    put_session();
    transaction->commit();
    transaction.reset();
    is_new = false;
    committed = images;
  }

  // Does `work`; when it fails, what was not committed is dropped, and nothing more can be written.
  template <class Work>
  void attempt(const Work& work) {
    if (failed) return;
    try {
      with_file(path, work);
    } catch (...) {
      failed = true;
      transaction.reset();
      throw;
    }
  }

  std::filesystem::path path;
  WriteLock lock;  // before the connection: it goes last
  Connection connection;
  bool is_new = false;
  std::optional<RowWriter> row_writer;
  std::optional<SQLite::Transaction> transaction;
  SessionRow session;
  std::string frontend;
  bool failed = false;
  int images = 0;     // of the map that are in the file or on their way to it
  int committed = 0;  // that are in it
  std::size_t nodes = 0;
  std::size_t edges = 0;
};

MapWriter::MapWriter(const std::filesystem::path& path)
    : state_(with_file(path, [&] { return std::make_unique<State>(path); })) {}

MapWriter::~MapWriter() {
  // Nothing to commit: at most the log remains, and the next reader finds it.
  state_->transaction.reset();
  state_->row_writer.reset();
  state_->connection.reset();
  if (state_->is_new) remove_with_log(state_->path);
}

std::optional<StoredMap> MapWriter::load() const {
  if (state_->is_new) return std::nullopt;
  return with_file(state_->path, [&] { return read_map(*state_->connection); });
}

void MapWriter::begin_session(const StoredMap& stored, const std::string& source) {
  State& state = *state_;
  state.images = state.committed = stored.map.images();
  state.nodes = stored.map.nodes().size();
  state.edges = stored.map.edges().size();
  state.frontend = stored.frontend;
  const int number = static_cast<int>(stored.map.sessions().size()) - 1;
  state.session = {number, source, now(), stored.map.sessions().back(), 0, 0, 0};
}

void MapWriter::resume_session(const StoredMap& stored) {
  begin_session(stored, "");
  if (state_->is_new) return;
  state_->session = with_file(state_->path, [&] { return read_sessions(*state_->connection).back(); });
}

void MapWriter::append(const TopologicalMap& map, const Signature& signature, const ImageNote& note) {
  state_->attempt([&] {
    State& state = *state_;
    const bool first_ever = state.is_new && !state.row_writer;
    RowWriter& rows = state.rows();
    if (first_ever) rows.put_map(map.config(), state.frontend);
    const Update& update = map.history().back();
    const Node& node = map.nodes()[static_cast<std::size_t>(update.node)];
    const bool is_view = node.views.back().image == update.image;
    rows.put_image(update, is_view, &signature, note);
    for (; state.nodes < map.nodes().size(); ++state.nodes) {
      const Node& made = map.nodes()[state.nodes];
      rows.put(NodeRow{made.id, made.views.front().image});
    }
    for (; state.edges < map.edges().size(); ++state.edges) {
      rows.put_edge(static_cast<int>(state.edges), map.edges()[state.edges]);
    }
    state.images = map.images();
  });
}

void MapWriter::note_session(int skipped, double seconds) {
  state_->session.skipped = skipped;
  state_->session.seconds = seconds;
}

void MapWriter::commit() {
  state_->attempt([&] { state_->commit(); });
}

int MapWriter::committed() const { return state_->committed; }

void MapWriter::finish() {
  commit();
  state_->row_writer.reset();
  leave_one_file(*state_->connection);
}

}  // namespace sailmap
