#include "report/drawing_check.h"

#include <set>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/one_line.h"

namespace regarment {
namespace {

constexpr std::size_t kMostBytes = 8u << 20;
constexpr std::string_view kSpace = " \t\r\n";

const std::set<std::string_view> kElements = {
    "svg",    "g",       "defs", "title", "desc",  "path",   "line", "polyline", "polygon",
    "circle", "ellipse", "rect", "text",  "tspan", "marker", "use",  "symbol"};

// Reads the tags of a text one after the other; what is between them is text.
class TagReader {
 public:
  TagReader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  void check() {
    skip_prolog();
    while (true) {
      at_ = text_.find('<', at_);
      if (at_ == std::string_view::npos) return;
      ++at_;
      check_tag();
    }
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw ReadError(name_ + ": " + what + " has no place in a drawing; run 'regarment fit' again");
  }
  bool take(std::string_view expected) {
    if (!text_.substr(at_).starts_with(expected)) return false;
    at_ += expected.size();
    return true;
  }
  void skip_space() {
    while (at_ < text_.size() && kSpace.find(text_[at_]) != std::string_view::npos) ++at_;
  }
  std::string_view word(std::string_view ends) {
    const std::size_t end = std::min(text_.find_first_of(ends, at_), text_.size());
    return text_.substr(std::exchange(at_, end), end - at_);
  }

  void skip_prolog() {
    if (!take("<?xml")) return;
    at_ = text_.find("?>", at_);
    if (at_ == std::string_view::npos) fail("a prolog that does not end");
  }

  void check_tag() {
    if (take("!--")) {
      at_ = text_.find("-->", at_);
      if (at_ == std::string_view::npos) fail("a comment that does not end");
      return;
    }
    const bool closing = take("/");
    const std::string_view element = word(" \t\r\n/>");
    if (!kElements.contains(element)) fail("<" + one_line(element, 40) + ">");
    while (true) {
      skip_space();
      if (take("/>") || take(">")) return;
      if (closing || at_ >= text_.size()) fail("a tag that does not end");
      check_attribute();
    }
  }

  void check_attribute() {
    const std::string_view attribute = word("= \t\r\n/><\"'");
    if (attribute.empty() || !take("=\"")) fail("an attribute without a value in quotes");
    const std::string_view value = word("\"<");
    if (!take("\"")) fail("a value that does not end");
    const bool reference = attribute == "href" || attribute == "xlink:href";
    const bool runs = attribute.starts_with("on") || (reference && !value.starts_with('#'));
    const bool fetches =
        !attribute.starts_with("xmlns") &&
        (value.find("//") != std::string_view::npos || value.find('\\') != std::string_view::npos);
    if (runs || fetches) fail("the attribute " + one_line(attribute, 40));
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
};

}  // namespace

void check_drawing(const std::string& svg, const std::string& name) {
  if (svg.size() > kMostBytes)
    throw ReadError(name + ": larger than 8 MiB; run 'regarment fit' again");
  if (svg.find("<svg") == std::string::npos) throw ReadError(name + ": is not an SVG drawing");
  TagReader(svg, name).check();
}

}  // namespace regarment
