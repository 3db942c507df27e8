#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "http/request.h"

namespace regarment {

/// Bytes begin (inclusive) to end (exclusive).
using ByteRange = std::pair<std::uint64_t, std::uint64_t>;
struct WholeFile {};
struct NoSuchRange {};

/// What a GET with its Range and If-Range asks for of `size` bytes with this ETag. Several ranges,
/// another unit and what is not of the form of a range ask for the whole.
std::variant<WholeFile, ByteRange, NoSuchRange> asked_range(const Request& request,
                                                            std::uint64_t size,
                                                            std::string_view etag);

/// Whether If-None-Match has this ETag (weak comparison, RFC 9110) or is "*".
bool has_etag(const Request& request, std::string_view etag);

}  // namespace regarment
