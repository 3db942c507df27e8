#include "exports/glb_writer.h"

#include <cmath>
#include <cstring>

#include <nlohmann/json.hpp>

namespace regarment {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kByte = 5121, kUnsignedInt = 5125, kFloat = 5126;  // component types
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;
constexpr std::uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinChunk = 0x004E4942;

void put(std::string& out, std::uint32_t value) {
  for (int byte = 0; byte < 4; ++byte) out += static_cast<char>((value >> (8 * byte)) & 0xffU);
}

void pad(std::string& text, char with) {
  while (text.size() % 4 != 0) text += with;
}

char linear(std::uint8_t srgb) {
  const double c = srgb / 255.0;
  const double value = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  return static_cast<char>(static_cast<std::uint8_t>(std::lround(255.0 * value)));
}

std::vector<float> flattened(const auto& values, int size) {
  std::vector<float> out;
  out.reserve(values.size() * static_cast<std::size_t>(size));
  for (const auto& v : values)
    for (int k = 0; k < size; ++k) out.push_back(static_cast<float>(v[k]));
  return out;
}

}  // namespace

int GlbWriter::add(Accessor accessor) {
  accessor.size = data_.size() - accessor.offset;
  accessors_.push_back(std::move(accessor));
  return static_cast<int>(accessors_.size()) - 1;
}

int GlbWriter::floats(const char* type, std::size_t count, const std::vector<float>& values) {
  const std::size_t offset = data_.size();
  data_.reserve(offset + 4 * values.size());
  for (const float value : values) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    put(data_, bits);
  }
  return add({type, kFloat, count, offset, 0});
}

int GlbWriter::vectors(std::span<const Vec3> values) {
  return floats("VEC3", values.size(), flattened(values, 3));
}

int GlbWriter::positions(std::span<const Vec3> values) {
  const int at = vectors(values);
  Accessor& accessor = accessors_.back();
  for (int k = 0; k < 3; ++k) {
    float low = static_cast<float>(values[0][k]), high = low;
    for (const Vec3& p : values) {
      low = std::min(low, static_cast<float>(p[k]));
      high = std::max(high, static_cast<float>(p[k]));
    }
    accessor.low.push_back(low);
    accessor.high.push_back(high);
  }
  return at;
}

int GlbWriter::coordinates(std::span<const Vec2> values) {
  return floats("VEC2", values.size(), flattened(values, 2));
}

int GlbWriter::scalars(std::span<const float> values) {
  return floats("SCALAR", values.size(), {values.begin(), values.end()});
}

int GlbWriter::colours(std::span<const Colour> values) {
  const std::size_t offset = data_.size();
  std::array<char, 256> curve{};
  for (std::size_t i = 0; i < curve.size(); ++i) curve[i] = linear(static_cast<std::uint8_t>(i));
  data_.reserve(offset + 4 * values.size());
  for (const Colour& colour : values) {
    for (const std::uint8_t channel : colour) data_ += curve[channel];
    data_ += static_cast<char>(255);
  }
  return add({"VEC4", kByte, values.size(), offset, 0});
}

int GlbWriter::indices(std::span<const std::uint32_t> values) {
  const std::size_t offset = data_.size();
  data_.reserve(offset + 4 * values.size());
  for (const std::uint32_t value : values) put(data_, value);
  return add({"SCALAR", kUnsignedInt, values.size(), offset, 0, true});
}

std::string GlbWriter::bytes(std::string_view document) const {
  Json json = Json::parse(document);
  Json views = Json::array(), accessors = Json::array();
  for (const Accessor& a : accessors_) {
    Json accessor = {{"bufferView", views.size()},
                     {"componentType", a.component},
                     {"count", a.count},
                     {"type", a.type}};
    if (a.component == kByte) accessor["normalized"] = true;
    if (!a.low.empty()) {
      accessor["min"] = a.low;
      accessor["max"] = a.high;
    }
    accessors.push_back(std::move(accessor));
    views.push_back({{"buffer", 0},
                     {"byteOffset", a.offset},
                     {"byteLength", a.size},
                     {"target", a.is_index ? kElementArrayBuffer : kArrayBuffer}});
  }
  json["accessors"] = std::move(accessors);
  json["bufferViews"] = std::move(views);
  json["buffers"] = Json::array({{{"byteLength", data_.size()}}});
  std::string text = json.dump();
  pad(text, ' ');
  std::string out;
  out.reserve(28 + text.size() + data_.size());
  put(out, kMagic);
  put(out, 2);
  put(out, static_cast<std::uint32_t>(28 + text.size() + data_.size()));
  put(out, static_cast<std::uint32_t>(text.size()));
  put(out, kJsonChunk);
  out += text;
  put(out, static_cast<std::uint32_t>(data_.size()));
  put(out, kBinChunk);
  return out + data_;
}

}  // namespace regarment
