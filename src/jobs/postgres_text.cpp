#include "jobs/postgres_text.h"

#include <array>
#include <charconv>
#include <utility>

namespace regarment {
namespace {

constexpr char kEscape = '\x1a';

// Longest first where one begins with another.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kWords = {{
    {" INTEGER PRIMARY KEY AUTOINCREMENT", " BIGINT GENERATED ALWAYS AS IDENTITY PRIMARY KEY"},
    {" INTEGER", " BIGINT"},
    {" REAL", " DOUBLE PRECISION"},
    {" TEXT", " TEXT COLLATE \"C\""},
    {") WITHOUT ROWID", ")"},
}};

unsigned byte_at(std::string_view text, std::size_t at) {
  return at < text.size() ? static_cast<unsigned char>(text[at]) : 0U;
}

// Length of the UTF-8 character at `at` that may stand as it is; 0: there is none.
std::size_t kept_length(std::string_view text, std::size_t at) {
  const unsigned first = byte_at(text, at), second = byte_at(text, at + 1);
  if (first < 0x80) return first != 0 && text[at] != kEscape ? 1 : 0;
  if (first < 0xC2 || first > 0xF4) return 0;
  // Overlong forms, surrogates and what lies beyond Unicode show in the second byte.
  const unsigned least = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  const unsigned most = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  if (second < least || second > most) return 0;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  for (std::size_t i = 2; i < length; ++i) {
    if ((byte_at(text, at + i) & 0xC0U) != 0x80U) return 0;
  }
  return length;
}

}  // namespace

std::string postgres_statement(std::string_view sql) {
  std::string out;
  int values = 0;
  for (const char c : sql) {
    if (c == '?') {
      out += "$" + std::to_string(++values);
    } else {
      out += c;
    }
  }
  return out;
}

std::string postgres_tables(std::string_view sql) {
  std::string out(sql);
  for (const auto& [ours, theirs] : kWords) {
    for (auto at = out.find(ours); at != std::string::npos;
         at = out.find(ours, at + theirs.size())) {
      out.replace(at, ours.size(), theirs);
    }
  }
  return out;
}

std::string postgres_text(std::string_view bytes) {
  static constexpr std::string_view kDigits = "0123456789abcdef";
  std::string out;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t length = kept_length(bytes, at);
    if (length > 0) {
      out.append(bytes.substr(at, length));
      at += length;
      continue;
    }
    const unsigned byte = byte_at(bytes, at++);
    out += {kEscape, kDigits[byte >> 4U], kDigits[byte & 15U]};
  }
  return out;
}

std::string bytes_of_postgres_text(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; at < text.size(); ++at) {
    unsigned byte = byte_at(text, at);
    if (text[at] == kEscape && at + 2 < text.size()) {
      std::from_chars(text.data() + at + 1, text.data() + at + 3, byte, 16);
      at += 2;
    }
    out += static_cast<char>(byte);
  }
  return out;
}

}  // namespace regarment
