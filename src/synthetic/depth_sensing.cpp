#include "synthetic/depth_sensing.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "synthetic/scanner_options.h"

namespace regarment {
namespace {

constexpr double kLeastJump = 0.008, kMostJump = 0.15;  // m, between mixed pixels
constexpr double kFlying = 0.004;                       // m
constexpr double kLeastCosine = 0.2;                    // the noise grows no further
constexpr int kReach = 2;         // pixels, of the window a normal is taken from
constexpr double kSheet = 0.012;  // m, depths of one window and one surface

// What the projector's picture may be nearer than a point that it lights: rounding to its pixels.
bool lit(const DepthPicture& light, const Vec3& point, double tangent) {
  const Vec3 p = light.camera.pixel_from_body(point);
  const int x0 = static_cast<int>(std::floor(p.x() - 0.5));
  const int y0 = static_cast<int>(std::floor(p.y() - 0.5));
  if (x0 < 0 || y0 < 0 || x0 + 1 >= light.camera.width || y0 + 1 >= light.camera.height)
    return false;
  const double bias = 0.001 + std::min(tangent, 6.0) * p.z() / light.camera.focal;
  for (int y = y0; y <= y0 + 1; ++y)
    for (int x = x0; x <= x0 + 1; ++x)
      if (light.depth[light.index(x, y)] >= p.z() - bias) return true;
  return false;
}

// Waves across the picture, of mean square 1 together.
class Ripple {
 public:
  explicit Ripple(Random& random) {
    for (Wave& wave : waves_) {
      const double length = random.uniform(5, 20), angle = random.uniform(0, kTurn);
      wave = {kTurn / length * std::cos(angle), kTurn / length * std::sin(angle),
              random.uniform(0, kTurn)};
    }
  }
  double at(int x, int y) const {
    double sum = 0;
    for (const Wave& wave : waves_) sum += std::sin(wave.x * x + wave.y * y + wave.phase);
    return std::sqrt(2.0 / kWaves) * sum;
  }

 private:
  static constexpr double kTurn = 2 * std::numbers::pi;
  static constexpr int kWaves = 6;
  struct Wave {
    double x, y, phase;
  };
  std::array<Wave, kWaves> waves_{};
};

class Sensing {
 public:
  Sensing(const ScannerScene& scene, const DepthSensor& sensor, const SensingOptions& options,
          Random& random)
      : scene_(scene),
        options_(options),
        random_(random),
        ripple_(random),
        picture_(draw_depth(sensor.camera, scene.positions, scene.triangles)),
        light_(draw_depth(sensor.projector, scene.positions, scene.triangles)),
        measured_(picture_.depth.size(), 0.0) {}

  std::vector<SensedPoint> run() {
    believe_another_place();
    std::vector<SensedPoint> points;
    std::vector<std::size_t> pixel;
    const DepthCamera& camera = picture_.camera;
    for (int y = 0; y < camera.height; ++y)
      for (int x = 0; x < camera.width; ++x)
        if (const std::size_t i = picture_.index(x, y); measure(x, y, points)) pixel.push_back(i);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto x = static_cast<int>(pixel[k] % camera.width);
      const auto y = static_cast<int>(pixel[k] / camera.width);
      points[k].position = believed(x, y);
      points[k].normal = normal_at(x, y);
    }
    return points;
  }

 private:
  void believe_another_place() {
    const auto dice = [&] { return Vec3(random_.normal(), random_.normal(), random_.normal()); };
    const Vec3 turn = options_.calibration / options_.noise_distance * dice();
    const Vec3 shift = options_.calibration * dice();
    believed_ = picture_.camera;
    believed_.eye += shift;
    if (turn.norm() > 0)
      believed_.view_from_body =
          believed_.view_from_body *
          Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  }

  // Whether pixel (x, y) gives a depth; notes it, and what it is of.
  bool measure(int x, int y, std::vector<SensedPoint>& points) {
    const std::size_t i = picture_.index(x, y);
    const std::uint32_t t = picture_.triangle[i];
    if (t == DepthPicture::kNone) return false;
    SensedPoint point;
    point.triangle = t;
    point.true_position = picture_.camera.body_from_pixel({x + 0.5, y + 0.5, picture_.depth[i]});
    const Vec3 normal = normal_of(t);
    const double cosine = cosine_to(normal, picture_.camera.eye, point.true_position);
    const double light = cosine_to(normal, light_.camera.eye, point.true_position);
    if (!returns(t, std::min(cosine, light))) return false;
    if (!lit(light_, point.true_position, std::sqrt(1 - light * light) / light)) return false;
    measured_[i] = mixed(x, y, point) + error(picture_.depth[i], cosine, darkness(t));
    if (options_.ripple > 0) measured_[i] += options_.ripple * ripple_.at(x, y);
    if (options_.quantum > 0)
      measured_[i] = options_.quantum * std::round(measured_[i] / options_.quantum);
    points.push_back(point);
    return true;
  }

  Vec3 normal_of(std::uint32_t t) const {
    const Triangle& c = scene_.triangles[t];
    const std::vector<Vec3>& p = scene_.positions;
    return (p[c[1]] - p[c[0]]).cross(p[c[2]] - p[c[0]]).normalized();
  }

  static double cosine_to(const Vec3& normal, const Vec3& eye, const Vec3& point) {
    return normal.dot((eye - point).normalized());
  }

  double darkness(std::uint32_t t) const {
    const std::size_t owner = scene_.owner[t];
    return owner < options_.darkness.size() ? options_.darkness[owner] : 0.0;
  }

  // Whether enough light comes back. The same number of draws for every pixel that sees something,
  // so that one option does not change the dice of another.
  bool returns(std::uint32_t t, double cosine) {
    const double graze = random_.uniform(), dark = random_.uniform(), drop = random_.uniform();
    if (cosine <= 0) return false;
    const double angle = std::acos(std::min(cosine, 1.0));
    const double span = std::max(options_.grazing_end - options_.grazing_begin, 1e-9);
    if (graze < (angle - options_.grazing_begin) / span) return false;
    if (dark < darkness(t) * (1.5 - 0.5 * cosine)) return false;
    return drop >= options_.dropout;
  }

  double error(double depth, double cosine, double dark) {
    const double far = depth / options_.noise_distance;
    return options_.noise * far * far * (1 + 2 * dark) / std::max(cosine, kLeastCosine) *
           random_.normal();
  }

  // The depth at a pixel, which at a jump may be anywhere between the two sides.
  double mixed(int x, int y, SensedPoint& point) {
    const double own = picture_.depth[picture_.index(x, y)];
    const double chance = random_.uniform(), share = random_.uniform();
    if (chance >= options_.mixed) return own;
    for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
      const int u = x + dx, v = y + dy;
      if (u < 0 || v < 0 || u >= picture_.camera.width || v >= picture_.camera.height) continue;
      const std::size_t j = picture_.index(u, v);
      if (picture_.triangle[j] == DepthPicture::kNone) continue;
      const double jump = picture_.depth[j] - own;
      if (std::abs(jump) < kLeastJump || std::abs(jump) > kMostJump) continue;
      const double off = share * std::abs(jump), rest = (1 - share) * std::abs(jump);
      point.flying = std::min(off, rest) > kFlying;
      if (rest <= kFlying) take_over(u, v, point);
      return own + share * jump;
    }
    return own;
  }

  // A mixed depth that is nearly its neighbour's is a point of what the neighbour sees.
  void take_over(int x, int y, SensedPoint& point) const {
    const std::size_t j = picture_.index(x, y);
    point.triangle = picture_.triangle[j];
    point.true_position = picture_.camera.body_from_pixel({x + 0.5, y + 0.5, picture_.depth[j]});
  }

  Vec3 believed(int x, int y) const {
    return believed_.body_from_pixel({x + 0.5, y + 0.5, measured_[picture_.index(x, y)]});
  }

  // Normal of the plane through the measured points around; towards the camera itself where there
  // are too few.
  Vec3 normal_at(int x, int y) const {
    const DepthCamera& camera = picture_.camera;
    const Vec3 here = believed(x, y);
    const double depth = measured_[picture_.index(x, y)];
    Vec3 sum = Vec3::Zero();
    Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
    int count = 0;
    for (int v = std::max(0, y - kReach); v <= std::min(camera.height - 1, y + kReach); ++v)
      for (int u = std::max(0, x - kReach); u <= std::min(camera.width - 1, x + kReach); ++u) {
        const double other = measured_[picture_.index(u, v)];
        if (other == 0 || std::abs(other - depth) > kSheet) continue;
        const Vec3 p = believed(u, v) - here;
        sum += p;
        products += p * p.transpose();
        ++count;
      }
    Vec3 towards = (believed_.eye - here).normalized();
    if (count < 6) return towards;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(products - sum * sum.transpose() / count);
    const Vec3 normal = solver.eigenvectors().col(0);
    return normal.dot(towards) < 0 ? Vec3(-normal) : normal;
  }

  const ScannerScene& scene_;
  const SensingOptions& options_;
  Random& random_;
  Ripple ripple_;
  DepthPicture picture_, light_;
  DepthCamera believed_;          // the camera where it is believed to stand
  std::vector<double> measured_;  // depth per pixel of the picture, m; 0: none
};

}  // namespace

void SensingOptions::check() const {
  check_scanner_value("noise", noise, 0, 0.003);
  check_scanner_value("ripple", ripple, 0, 0.002);
  check_scanner_value("noise_distance", noise_distance, 0.5, 5);
  check_scanner_value("quantum", quantum, 0, 0.005);
  check_scanner_value("calibration", calibration, 0, 0.001);
  check_scanner_value("grazing_begin", grazing_begin, 0, std::numbers::pi / 2);
  check_scanner_value("grazing_end", grazing_end, grazing_begin, std::numbers::pi / 2);
  check_scanner_value("dropout", dropout, 0, 0.9);
  check_scanner_value("mixed", mixed, 0, 1);
  for (const double dark : darkness) check_scanner_value("darkness", dark, 0, 1);
}

std::vector<SensedPoint> sense(const ScannerScene& scene, const DepthSensor& sensor,
                               const SensingOptions& options, Random& random) {
  options.check();
  return Sensing(scene, sensor, options, random).run();
}

}  // namespace regarment
