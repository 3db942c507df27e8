#pragma once

#include <string>
#include <string_view>

// Between what SQLite understands and what PostgreSQL does.

namespace regarment {

/// A statement with "$1", "$2" ... for each "?". No text in quotes may hold a "?".
std::string postgres_statement(std::string_view sql);

/// Statements that make or change tables, with PostgreSQL's types for SQLite's. Text compares by
/// bytes there as well.
std::string postgres_tables(std::string_view sql);

/// Any bytes as valid UTF-8 without a zero byte, which is all PostgreSQL keeps: what is valid stays
/// as it is, any other byte and 0x1A itself become 0x1A and two hexadecimal digits.
std::string postgres_text(std::string_view bytes);
/// The bytes again.
std::string bytes_of_postgres_text(std::string_view text);

}  // namespace regarment
