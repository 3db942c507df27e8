// Any bytes as a form: refused, or parts as multipart.h promises, and the same ones whatever the
// pieces it comes in. The first byte says how large these are, the second whether the boundary is
// read from the first line, as of a content type, or is a plain one.
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <vector>

#include "http/multipart.h"
#include "http/problem.h"

namespace {

using namespace regarment;

constexpr std::size_t kMostParts = 32, kLongestBoundary = 70;

void require(bool right) {
  if (!right) std::abort();
}

struct Part {
  FormPart head;
  std::string bytes;
  bool ended = false;

  bool operator==(const Part& other) const {
    return head.name == other.head.name && head.filename == other.head.filename &&
           head.content_type == other.head.content_type && bytes == other.bytes;
  }
};

class Parts : public FormReceiver {
 public:
  void begin_part(const FormPart& part) override {
    require(!part.name.empty() && (parts_.empty() || parts_.back().ended));
    parts_.push_back({part, {}, false});
  }
  void take_data(std::string_view bytes) override {
    require(!bytes.empty() && !parts_.empty() && !parts_.back().ended);
    parts_.back().bytes.append(bytes);
  }
  void end_part() override {
    require(!parts_.empty() && !parts_.back().ended);
    parts_.back().ended = true;
  }
  const std::vector<Part>& parts() const { return parts_; }

 private:
  std::vector<Part> parts_;
};

std::optional<std::vector<Part>> parsed(std::string_view form, const std::string& boundary,
                                        std::size_t piece) {
  Parts parts;
  try {
    FormParser parser(boundary, parts);
    for (; !form.empty(); form.remove_prefix(std::min(piece, form.size())))
      parser.take(form.substr(0, piece));
    parser.finish();
  } catch (const HttpProblem& problem) {
    require(problem.status == 400 && problem.code == "bad_multipart");
    return std::nullopt;
  }
  return parts.parts();
}

std::string boundary_of(std::string_view& form, bool from_type) {
  if (!from_type) return "b";
  const std::size_t end = std::min(form.find('\n'), form.size());
  const std::string boundary = form_boundary(form.substr(0, end));
  form.remove_prefix(std::min(end + 1, form.size()));
  require(!boundary.empty() && boundary.size() <= kLongestBoundary);
  return boundary;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  std::string_view form(reinterpret_cast<const char*>(data) + 2, size - 2);
  try {
    const std::string boundary = boundary_of(form, (data[1] & 1U) != 0);
    const auto whole = parsed(form, boundary, form.size() + 1);
    require(whole == parsed(form, boundary, data[0] + std::size_t{1}));
    if (!whole) return 0;
    require(!whole->empty() && whole->size() <= kMostParts);
    std::size_t bytes = 0;
    for (const Part& part : *whole) {
      require(part.ended);
      bytes += part.bytes.size();
    }
    require(bytes < form.size());
  } catch (const HttpProblem& problem) {
    require(problem.status == 400 && problem.code == "bad_multipart");
  }
  return 0;
}
