#include "report/csv_table.h"

#include <charconv>
#include <cmath>

#include "base/error.h"
#include "base/one_line.h"

namespace regarment {
namespace {

constexpr std::size_t kMaxBytes = 16u << 20;
constexpr std::size_t kMaxRows = 1'000'000;

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

// Takes rows off the front of a text, counting lines.
class RowReader {
 public:
  RowReader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  bool done() const { return at_ >= text_.size(); }
  std::size_t line() const { return line_; }

  std::vector<std::string> next() {
    std::vector<std::string> cells;
    do {
      cells.push_back(peek() == '"' ? quoted_cell() : plain_cell());
    } while (take(','));
    end_of_row();
    return cells;
  }

 private:
  char peek() const { return done() ? '\n' : text_[at_]; }
  bool take(char c) {
    if (done() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw ReadError(name_ + ": line " + std::to_string(line_) + ": " + what);
  }

  std::string plain_cell() {
    const std::size_t begin = at_;
    while (!done() && text_[at_] != ',' && text_[at_] != '\n' && text_[at_] != '\r') {
      if (text_[at_] == '"') fail("a quote inside a cell; put the whole cell in quotes");
      ++at_;
    }
    return std::string(trimmed(text_.substr(begin, at_ - begin)));
  }

  std::string quoted_cell() {
    const std::size_t opened = line_;
    std::string cell;
    ++at_;
    while (true) {
      if (done()) {
        line_ = opened;
        fail("a quote is opened and never closed; close it");
      }
      const char c = text_[at_++];
      if (c == '"' && !take('"')) return std::string(trimmed(cell));
      if (c == '\n') ++line_;
      cell += c;
    }
  }

  void end_of_row() {
    take('\r');
    if (done()) return;
    if (!take('\n')) fail("text after a closing quote; separate cells by commas");
    ++line_;
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0, line_ = 1;
};

void check_text(std::string_view text, const std::string& name) {
  if (text.size() > kMaxBytes) throw ReadError(name + ": larger than 16 MiB; split the table");
  if (text.find('\0') != std::string_view::npos) {
    throw ReadError(name + ": holds NUL bytes; save the table as UTF-8 text");
  }
}

}  // namespace

CsvTable CsvTable::parse(std::string_view text, const std::string& name) {
  check_text(text, name);
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  CsvTable table;
  table.name_ = name;
  RowReader reader(text, name);
  while (!reader.done()) {
    const std::size_t line = reader.line();
    std::vector<std::string> cells = reader.next();
    if (cells.size() == 1 && cells.front().empty()) continue;
    if (table.columns_.empty()) {
      table.columns_ = std::move(cells);
      continue;
    }
    if (cells.size() != table.columns_.size()) {
      throw ReadError(name + ": line " + std::to_string(line) + " has " +
                      std::to_string(cells.size()) + " cells, the header " +
                      std::to_string(table.columns_.size()) + "; make them equal");
    }
    if (table.rows_.size() == kMaxRows) throw ReadError(name + ": more than a million rows");
    table.rows_.push_back({line, std::move(cells)});
  }
  if (table.columns_.empty()) throw ReadError(name + ": is empty; the first row names the columns");
  for (std::size_t i = 0; i < table.columns_.size(); ++i) {
    if (!table.columns_[i].empty() && table.find(table.columns_[i]) != i) {
      throw ReadError(name + ": column '" + one_line(table.columns_[i]) + "' occurs twice");
    }
  }
  return table;
}

std::optional<std::size_t> CsvTable::find(std::string_view column) const {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i] == column) return i;
  }
  return std::nullopt;
}

std::string_view CsvTable::cell(std::size_t row, std::string_view column) const {
  const auto index = find(column);
  if (!index) return {};
  return rows_[row].cells[*index];
}

std::optional<double> CsvTable::number(std::size_t row, std::string_view column) const {
  const std::string_view text = cell(row, column);
  if (text.empty()) return std::nullopt;
  const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
  double value = std::nan("");
  const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool two_signs = text.starts_with("+-");
  if (two_signs || end.ec != std::errc() || end.ptr != digits.data() + digits.size() ||
      !std::isfinite(value)) {
    throw ReadError(where(row, column) + ": '" + one_line(text.substr(0, 40)) +
                    "' is not a number; write it like 54.5");
  }
  return value;
}

std::string CsvTable::where(std::size_t row, std::string_view column) const {
  return name_ + ": line " + std::to_string(line(row)) + ", column " + std::string(column);
}

std::string csv_text(std::string_view text) {
  std::string cell;
  if (!text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos) {
    cell += '\'';
  }
  cell += text;
  if (cell.find_first_of(",\"\r\n'") == std::string::npos) return cell;
  std::string out = "\"";
  for (const char c : cell) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

std::string csv_exact(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return std::string(text);
  std::string out = "\"";
  for (const char c : text) out.append(c == '"' ? 2 : 1, c);
  return out + "\"";
}

}  // namespace regarment
