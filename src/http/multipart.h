#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "http/headers.h"

namespace regarment {

/// What stands before the bytes of a part of multipart/form-data.
struct FormPart {
  std::string name;
  std::optional<std::string> filename;  // as sent; never to be used as a path
  std::string content_type;             // may be empty
};

/// Told of the parts of a form in their order.
class FormReceiver {
 public:
  virtual ~FormReceiver() = default;
  virtual void begin_part(const FormPart& part) = 0;
  virtual void take_data(std::string_view bytes) = 0;  // any number of pieces, none empty
  virtual void end_part() = 0;
};

/// The boundary of a "multipart/form-data" content type. Throws HttpProblem 400 "bad_multipart"
/// when there is none or it is not one (1 to 70 characters, RFC 2046).
std::string form_boundary(std::string_view content_type);

/// Takes multipart/form-data (RFC 7578) apart as it arrives, in pieces of any size, and keeps no
/// more than a part's header. Strict: no text before the first boundary, none but an empty line
/// after the last, CRLF line ends, at most 32 parts and 4 KiB of header each, a name in each.
/// Throws HttpProblem 400 "bad_multipart"; what the receiver throws passes through.
class FormParser {
 public:
  FormParser(const std::string& boundary, FormReceiver& receiver);

  void take(std::string_view bytes);
  /// Throws when the form is not complete.
  void finish();

 private:
  enum class State { Start, AfterBoundary, Header, Data, End, Closed };

  bool step();
  bool read_start();
  bool read_after_boundary();
  bool read_header();
  bool read_data();
  void begin_part(std::string_view header);

  std::string delimiter_;  // CRLF, two dashes, boundary
  FormReceiver& receiver_;
  State state_ = State::Start;
  std::string waiting_;  // not yet understood; in Data shorter than the delimiter between calls
  std::size_t consumed_ = 0;  // of waiting_
  int parts_ = 0;
};

}  // namespace regarment
