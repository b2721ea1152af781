// Rows to and from SQLite. Every row ends with a checksum of its columns, since SQLite finds damage to its
// own structure but not to what is stored in it.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <zlib.h>

#include <limits>
#include <string>
#include <tuple>

#include "rows.hpp"
#include "sailmap/error.hpp"

namespace sailmap::store {

// CRC-32 over the type, length and bytes of each value.
class Checksum {
 public:
  void add(int value) { add_bytes('i', &value, sizeof value); }
  void add(double value) { add_bytes('d', &value, sizeof value); }
  void add(const std::string& value) { add_bytes('s', value.data(), value.size()); }
  void add(const Blob& value) { add_bytes('b', value.data(), value.size()); }
  void add(const std::optional<double>& value) {
    if (value) {
      add(*value);
    } else {
      add_bytes('n', nullptr, 0);
    }
  }
  [[nodiscard]] std::int64_t value() const { return static_cast<std::int64_t>(crc_); }

 private:
  void add_bytes(char type, const void* bytes, std::size_t size) {
    update(&type, 1);
    const auto length = static_cast<std::uint64_t>(size);
    update(&length, sizeof length);
    update(bytes, size);
  }
  void update(const void* bytes, std::size_t size) {
    if (size > 0) crc_ = ::crc32_z(crc_, static_cast<const Bytef*>(bytes), size);
  }

  uLong crc_ = ::crc32(0, nullptr, 0);
};

inline void bind(SQLite::Statement& statement, int index, int value) { statement.bind(index, value); }
inline void bind(SQLite::Statement& statement, int index, double value) { statement.bind(index, value); }
inline void bind(SQLite::Statement& statement, int index, const std::string& value) {
  statement.bindNoCopy(index, value);
}
inline void bind(SQLite::Statement& statement, int index, const Blob& value) {
  // A null pointer would bind NULL.
  static const unsigned char none = 0;
  statement.bindNoCopy(index, value.empty() ? &none : value.data(), static_cast<int>(value.size()));
}
inline void bind(SQLite::Statement& statement, int index, const std::optional<double>& value) {
  if (value) {
    statement.bind(index, *value);
  } else {
    statement.bind(index);
  }
}

inline void demand_type(bool holds, const SQLite::Column& column) {
  if (!holds) throw Error(std::string("column ") + column.getName() + " holds something of another type");
}

inline void read(const SQLite::Column& column, int& value) {
  const std::int64_t wide = column.getInt64();
  demand_type(column.isInteger() && wide >= -std::numeric_limits<int>::max() &&
                  wide <= std::numeric_limits<int>::max(),
              column);
  value = static_cast<int>(wide);
}
inline void read(const SQLite::Column& column, double& value) {
  demand_type(column.isFloat() || column.isInteger(), column);
  value = column.getDouble();
}
inline void read(const SQLite::Column& column, std::string& value) {
  demand_type(column.isText(), column);
  value.assign(column.getText(), static_cast<std::size_t>(column.getBytes()));
}
inline void read(const SQLite::Column& column, Blob& value) {
  demand_type(column.isBlob(), column);
  const auto* bytes = static_cast<const unsigned char*>(column.getBlob());
  value.assign(bytes, bytes + column.getBytes());
}
inline void read(const SQLite::Column& column, std::optional<double>& value) {
  value.reset();
  if (column.isNull()) return;
  read(column, value.emplace());
}

template <class Row>
std::int64_t checksum_of(Row& row) {
  Checksum sum;
  std::apply([&](const auto&... field) { (sum.add(field), ...); }, row.fields());
  return sum.value();
}

template <class Row>
std::string insert_statement() {
  constexpr std::size_t count = std::tuple_size_v<decltype(std::declval<Row&>().fields())>;
  std::string marks;
  for (std::size_t i = 0; i < count; ++i) marks += "?, ";
  return std::string("INSERT OR REPLACE INTO ") + Row::table + " (" + Row::columns + ", checksum) VALUES (" +
         marks + "?)";
}

// `rest`: WHERE, ORDER BY and LIMIT.
template <class Row>
std::string select_statement(const std::string& rest) {
  return std::string("SELECT ") + Row::columns + ", checksum FROM " + Row::table + " " + rest;
}

template <class Row>
void insert(SQLite::Statement& statement, Row row) {
  statement.reset();
  int index = 0;
  std::apply([&](const auto&... field) { (bind(statement, ++index, field), ...); }, row.fields());
  statement.bind(++index, checksum_of(row));
  statement.exec();
  statement.clearBindings();
}

// Throws Error when the row is not what was written.
template <class Row>
Row read_row(SQLite::Statement& statement) {
  Row row;
  int index = 0;
  std::apply([&](auto&... field) { (read(statement.getColumn(index++), field), ...); }, row.fields());
  if (statement.getColumn(index).getInt64() != checksum_of(row)) {
    throw Error("row " + std::to_string(row.id) + " of table " + Row::table + " is damaged");
  }
  return row;
}

}  // namespace sailmap::store
