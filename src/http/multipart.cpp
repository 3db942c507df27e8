#include "http/multipart.h"

#include "http/problem.h"

namespace regarment {
namespace {

constexpr std::size_t kMostHeader = 4096;  // bytes of a part's header
constexpr int kMostParts = 32;
constexpr std::size_t kLongestBoundary = 70;
constexpr std::string_view kLineEnd = "\r\n", kHeaderEnd = "\r\n\r\n";

[[noreturn]] void refuse(const std::string& what) {
  throw HttpProblem(400, "bad_multipart",
                    "the form " + what + "; send multipart/form-data as RFC 7578 has it");
}

Headers read_fields(std::string_view text) {
  Headers out;
  while (!text.empty()) {
    const std::size_t end = text.find(kLineEnd);
    const std::string_view line = text.substr(0, end);
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos || colon == 0) refuse("has a part with a bad header");
    for (const char c : line)
      if (static_cast<unsigned char>(c) < 0x20 && c != '\t')
        refuse("has a control character in a part's header");
    out.add(std::string(line.substr(0, colon)), std::string(trimmed(line.substr(colon + 1))));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + kLineEnd.size());
  }
  return out;
}

}  // namespace

std::string form_boundary(std::string_view content_type) {
  const std::optional<std::string> boundary = header_parameter(content_type, "boundary");
  if (!boundary || boundary->empty() || boundary->size() > kLongestBoundary)
    refuse("names no boundary of 1 to 70 characters");
  const bool printable = boundary->find_first_not_of(
                             "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                             "'()+_,-./:=? ") == std::string::npos;
  if (!printable || boundary->back() == ' ') refuse("has a boundary with characters that none has");
  return *boundary;
}

FormParser::FormParser(const std::string& boundary, FormReceiver& receiver)
    : delimiter_("\r\n--" + boundary), receiver_(receiver) {}

void FormParser::take(std::string_view bytes) {
  waiting_.append(bytes);
  while (step()) {
  }
  waiting_.erase(0, consumed_);
  consumed_ = 0;
}

void FormParser::finish() {
  if (state_ != State::End && state_ != State::Closed) refuse("ends before its last boundary");
  if (!waiting_.empty()) refuse("goes on after its last boundary");
}

// Goes on by one piece; false when more bytes are needed.
bool FormParser::step() {
  switch (state_) {
    case State::Start:
      return read_start();
    case State::AfterBoundary:
      return read_after_boundary();
    case State::Header:
      return read_header();
    case State::Data:
      return read_data();
    case State::End:
    case State::Closed:
      break;
  }
  const std::string_view rest = std::string_view(waiting_).substr(consumed_);
  if (!rest.empty() && (state_ == State::Closed || !kLineEnd.starts_with(rest)))
    refuse("goes on after its last boundary");
  if (rest != kLineEnd) return false;
  consumed_ = waiting_.size();
  state_ = State::Closed;
  return false;
}

bool FormParser::read_start() {
  const std::string_view first = std::string_view(delimiter_).substr(kLineEnd.size());
  const std::string_view rest = std::string_view(waiting_).substr(consumed_);
  if (rest.substr(0, first.size()) != first.substr(0, rest.size()))
    refuse("does not begin with its boundary");
  if (rest.size() < first.size()) return false;
  consumed_ += first.size();
  state_ = State::AfterBoundary;
  return true;
}

bool FormParser::read_after_boundary() {
  if (waiting_.size() - consumed_ < 2) return false;
  const std::string_view two = std::string_view(waiting_).substr(consumed_, 2);
  if (two != kLineEnd && two != "--") refuse("has a boundary that is followed by other bytes");
  if (two == "--" && parts_ == 0) refuse("has no parts");
  consumed_ += 2;
  state_ = two == "--" ? State::End : State::Header;
  return true;
}

bool FormParser::read_header() {
  const std::string_view rest = std::string_view(waiting_).substr(consumed_);
  const std::size_t end = rest.find(kHeaderEnd);
  // Of the longest header all but the last byte of its end may be here.
  const std::size_t most = kMostHeader + kHeaderEnd.size() - 1;
  if (end == std::string_view::npos ? rest.size() > most : end > kMostHeader)
    refuse("has a part with a header of more than 4 KiB");
  if (end == std::string_view::npos) return false;
  begin_part(rest.substr(0, end));
  consumed_ += end + kHeaderEnd.size();
  state_ = State::Data;
  return true;
}

bool FormParser::read_data() {
  const std::string_view rest = std::string_view(waiting_).substr(consumed_);
  const std::size_t end = rest.find(delimiter_);
  const std::size_t sure = end != std::string_view::npos
                               ? end
                               : rest.size() - std::min(rest.size(), delimiter_.size() - 1);
  if (sure > 0) receiver_.take_data(rest.substr(0, sure));
  consumed_ += sure;
  if (end == std::string_view::npos) return false;
  receiver_.end_part();
  consumed_ += delimiter_.size();
  state_ = State::AfterBoundary;
  return true;
}

void FormParser::begin_part(std::string_view header) {
  if (++parts_ > kMostParts) refuse("has more than 32 parts");
  const Headers fields = read_fields(header);
  const std::string_view disposition = fields.get("Content-Disposition");
  const bool form_data =
      same_ignoring_case(trimmed(disposition.substr(0, disposition.find(';'))), "form-data");
  const std::optional<std::string> name = header_parameter(disposition, "name");
  if (!form_data || fields.count("Content-Disposition") != 1 || !name || name->empty())
    refuse("has a part without a name");
  if (fields.count("Content-Transfer-Encoding") != 0)
    refuse("has a part with a transfer encoding, which forms do not have");
  receiver_.begin_part(
      {*name, header_parameter(disposition, "filename"), std::string(fields.get("Content-Type"))});
}

}  // namespace regarment
