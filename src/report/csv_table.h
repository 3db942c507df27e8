#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace regarment {

/// A table of text read from CSV (RFC 4180: commas, quotes doubled inside quotes, LF or CRLF; a
/// UTF-8 byte order mark is skipped). The first row names the columns; empty lines are skipped.
class CsvTable {
 public:
  /// `name` is used in messages. Throws ReadError naming the line when a row has more or fewer
  /// cells than the header, a quote is not closed or stands inside a plain cell, a column name
  /// occurs twice, a NUL byte occurs, or the text passes 16 MiB or a million rows.
  static CsvTable parse(std::string_view text, const std::string& name);

  std::size_t size() const { return rows_.size(); }
  const std::string& name() const { return name_; }
  std::size_t line(std::size_t row) const { return rows_[row].line; }  // 1 = the header

  bool has(std::string_view column) const { return find(column).has_value(); }
  /// The cell, spaces around it removed; empty where the table has no such column.
  std::string_view cell(std::size_t row, std::string_view column) const;
  /// A number in the cell, or nothing when it is empty. Throws ReadError naming line and column
  /// when it is not a finite decimal number with a point.
  std::optional<double> number(std::size_t row, std::string_view column) const;
  /// "table.csv: line 3, column value_cm", the beginning of a message about a cell.
  std::string where(std::size_t row, std::string_view column) const;

 private:
  struct Row {
    std::size_t line = 0;
    std::vector<std::string> cells;
  };
  std::optional<std::size_t> find(std::string_view column) const;

  std::string name_;
  std::vector<std::string> columns_;
  std::vector<Row> rows_;  // each as long as columns_
};

/// One cell as it is written: quoted where CSV asks for it, and text that a spreadsheet would run
/// as a formula (it begins with = + - @, tab or carriage return) gets an apostrophe in front.
std::string csv_text(std::string_view text);
/// One cell that CsvTable reads back as it is, whatever it begins with: for programs, not for
/// people.
std::string csv_exact(std::string_view text);

}  // namespace regarment
