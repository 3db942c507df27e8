#include "synthetic/body_library.h"

#include <cstdint>
#include <cstring>

#include "base/error.h"
#include "base/one_line.h"

// Made by bodies.s.in.
extern "C" const std::byte regarment_packed_bodies[];
extern "C" const std::byte regarment_packed_bodies_end[];

namespace regarment {
namespace {

constexpr std::size_t kMostBodies = 1000;
constexpr std::size_t kNameBytes = 32;

// Takes little-endian numbers off the front of the file.
class Bytes {
 public:
  explicit Bytes(std::span<const std::byte> bytes) : rest_(bytes) {}

  std::span<const std::byte> take(std::size_t count) {
    if (rest_.size() < count) throw ReadError("packed bodies: the file ends too early");
    const auto out = rest_.first(count);
    rest_ = rest_.subspan(count);
    return out;
  }

  template <typename T>
  T number() {
    T value;
    std::memcpy(&value, take(sizeof(T)).data(), sizeof(T));
    return value;
  }

  std::string text(std::size_t count) {
    const auto bytes = take(count);
    std::string out(count, '\0');
    std::memcpy(out.data(), bytes.data(), count);
    return out.substr(0, out.find('\0'));
  }

  std::size_t left() const { return rest_.size(); }

 private:
  std::span<const std::byte> rest_;
};

struct Box {
  Vec3 low, high;
};

Vec3 corner(Bytes& bytes) {
  Vec3 out;
  for (int k = 0; k < 3; ++k) out[k] = static_cast<double>(bytes.number<float>());
  return out;
}

Box read_box(Bytes& bytes, const std::string& name) {
  const Vec3 low = corner(bytes), high = corner(bytes);
  const bool fine = low.allFinite() && high.allFinite() && ((high - low).array() > 0).all();
  if (!fine) throw ReadError("packed bodies: the box of '" + one_line(name, 40) + "' is empty");
  return {low, high};
}

std::vector<Triangle> read_triangles(Bytes& bytes, std::size_t count, std::size_t vertices) {
  std::vector<Triangle> out(count);
  for (Triangle& triangle : out) {
    for (auto& index : triangle) {
      index = bytes.number<std::uint16_t>();
      if (index >= vertices) throw ReadError("packed bodies: a triangle names a missing vertex");
    }
  }
  return out;
}

std::vector<Vec3> read_positions(Bytes& bytes, std::size_t count, const Box& box) {
  constexpr double kSteps = 65535.0;
  std::vector<Vec3> out(count);
  for (Vec3& p : out) {
    for (int k = 0; k < 3; ++k) {
      const double share = bytes.number<std::uint16_t>() / kSteps;
      p[k] = box.low[k] + (box.high[k] - box.low[k]) * share;
    }
  }
  return out;
}

}  // namespace

BodyLibrary unpack_bodies(std::span<const std::byte> packed) {
  Bytes bytes(packed);
  if (bytes.text(8) != "RGBODY1\n") throw ReadError("packed bodies: the file begins otherwise");
  const std::size_t bodies = bytes.number<std::uint32_t>();
  const std::size_t vertices = bytes.number<std::uint32_t>();
  const std::size_t triangles = bytes.number<std::uint32_t>();
  constexpr std::size_t kBox = kNameBytes + 6 * sizeof(float);
  const bool fits = bodies > 0 && bodies <= kMostBodies && vertices <= 65536 && vertices > 0 &&
                    triangles <= 131072 &&
                    bytes.left() == bodies * kBox + triangles * 6 + bodies * vertices * 6;
  if (!fits) throw ReadError("packed bodies: the file's size does not agree with its counts");
  BodyLibrary out;
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < bodies; ++i) {
    out.names.push_back(bytes.text(kNameBytes));
    boxes.push_back(read_box(bytes, out.names.back()));
  }
  out.triangles = read_triangles(bytes, triangles, vertices);
  for (const Box& box : boxes) out.positions.push_back(read_positions(bytes, vertices, box));
  return out;
}

const BodyLibrary& body_library() {
  static const BodyLibrary library =
      unpack_bodies(std::span(&regarment_packed_bodies[0], &regarment_packed_bodies_end[0]));
  return library;
}

}  // namespace regarment
