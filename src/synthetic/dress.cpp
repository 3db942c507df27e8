#include "synthetic/dress.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "base/error.h"
#include "garment/find_template.h"
#include "synthetic/falling_sheet.h"
#include "synthetic/finer.h"
#include "synthetic/penetration.h"
#include "synthetic/put_on.h"
#include "synthetic/resting_sheet.h"
#include "synthetic/yield.h"

namespace regarment {
namespace {

constexpr double kClearance = 0.012;       // m, between body and garment when it is put on
constexpr double kCoarser = 2.0;           // edges of the first, coarse cloth against the last
constexpr double kPulled = 0.25;           // s it is drawn together before it falls
constexpr double kFalling = 0.6;           // s it falls before the next is put on
constexpr double kMoving = 1.2;            // s the body takes through its poses
constexpr double kSettling = 0.8;          // s of coarse cloth after that
constexpr double kFolding = 0.4;           // s of fine cloth
constexpr double kCoarseStep = 1.0 / 500;  // s
constexpr double kFineStep = 1.0 / 1000;   // s
constexpr double kRestSpeed = 0.01;        // m/s, of the 99th percentile: cloth at rest
constexpr double kRestMedian = 0.002;      // m/s, of half of it
constexpr double kLeastRest = 0.5;         // s tension takes to even out
constexpr double kRebuildEvery = 0.04;     // s, nearest points of what moves are good for

/// Particles of the upper edge of a garment that hangs from the waist; none of one with sleeves.
std::vector<std::uint32_t> top_edge(const Pattern& pattern) {
  std::vector<std::uint32_t> out;
  double least = std::numeric_limits<double>::infinity();
  for (const PatternEdge& edge : pattern.edges) {
    if (edge.limb != "torso") return {};
    const double t = pattern.flat[edge.vertices.front()].y();
    if (t >= least) continue;
    least = t;
    out.clear();
    for (const int v : edge.vertices)
      out.push_back(static_cast<std::uint32_t>(pattern.particle[v]));
  }
  return out;
}

/// One garment while it is being dressed.
struct Worn {
  const GarmentWish* wish = nullptr;
  Pattern pattern;
  Sheet sheet;
  std::unique_ptr<FallingSheet> falling;
  std::unique_ptr<RestingSheet> resting;    // once it hangs nearly still
  std::unique_ptr<Obstacle> below, around;  // what it is to garments further out and further in

  void wear(std::vector<Vec3> positions) {
    const auto obstacle = [&](ObstacleKind kind) {
      return std::make_unique<Obstacle>(kind, sheet.triangles, positions, sheet.fabric.thickness);
    };
    below = obstacle(ObstacleKind::Below);
    around = obstacle(ObstacleKind::Around);
    falling = std::make_unique<FallingSheet>(sheet, std::move(positions));
    falling->hold_level(top_edge(pattern));
  }
  void rest() { resting = std::make_unique<RestingSheet>(sheet, falling->positions()); }
  const std::vector<Vec3>& positions() const {
    return resting ? resting->positions() : falling->positions();
  }
  Mesh mesh() const { return {positions(), sheet.triangles, {}, {}}; }
};

class Wardrobe {
 public:
  Wardrobe(const std::vector<Mesh>& poses, const DressOptions& options, const Progress& progress,
           std::size_t garments)
      : poses_(poses),
        options_(options),
        progress_(progress),
        body_(ObstacleKind::Body, poses.front().triangles, poses.front().positions, 0.0) {
    worn_.reserve(garments);  // sheets are pointed at
  }

  /// Puts on what is to be worn next, over the rest.
  void put_on(const GarmentWish& wish);
  /// Takes the body through its poses.
  void move();
  /// Lets all come to rest as coarse cloth, then as fine.
  void settle();
  Dressing result() const;

 private:
  void make(Worn& worn, double edge_length) const;
  /// One step of every garment, against the body and the garments below; `body_moves` when it does.
  void step(bool body_moves = false);
  void fall(double seconds);
  void refine();

  const std::vector<Mesh>& poses_;
  const DressOptions& options_;
  const Progress& progress_;
  Obstacle body_;
  std::vector<Worn> worn_;  // innermost first
  FallOptions fall_;
  RestOptions rest_;
  double simulated_ = 0.0, rebuilt_ = 0.0;  // s
  bool rested_ = false;
};

void Wardrobe::make(Worn& worn, double edge_length) const {
  const GarmentTemplate garment = find_template(worn.wish->template_name);
  worn.pattern = make_pattern(garment, worn.wish->dimensions, edge_length);
  worn.sheet = make_sheet(worn.pattern, worn.wish->fabric, worn.wish->band);
}

void Wardrobe::step(bool body_moves) {
  const bool rebuild = simulated_ - rebuilt_ >= kRebuildEvery;
  if (rebuild) rebuilt_ = simulated_;
  if (body_moves && rebuild) body_.rebuild();
  for (std::size_t i = 0; i < worn_.size(); ++i) {
    std::vector<const Obstacle*> obstacles = {&body_};
    for (std::size_t k = 0; k < worn_.size(); ++k)
      if (k != i) obstacles.push_back((k < i ? worn_[k].below : worn_[k].around).get());
    Worn& worn = worn_[i];
    if (worn.resting)
      worn.resting->step(obstacles, rest_);
    else
      worn.falling->step(obstacles, fall_);
    if (worn_.size() < 2) break;
    for (Obstacle* obstacle : {worn.below.get(), worn.around.get()}) {
      obstacle->move_to(worn.positions());
      if (rebuild) obstacle->rebuild();
    }
  }
  simulated_ += worn_.front().resting ? rest_.time_step : fall_.time_step;
  progress_.report("dress", std::min(1.0, simulated_ / options_.longest));
}

void Wardrobe::fall(double seconds) {
  const double end = simulated_ + seconds;
  while (simulated_ < end) step();
}

void Wardrobe::put_on(const GarmentWish& wish) {
  std::vector<Mesh> clothes;
  clothes.reserve(worn_.size());
  for (const Worn& worn : worn_) clothes.push_back(worn.mesh());
  std::vector<const Mesh*> clothed = {&poses_.front()};
  for (const Mesh& mesh : clothes) clothed.push_back(&mesh);
  Worn& worn = worn_.emplace_back();
  worn.wish = &wish;
  make(worn, kCoarser * options_.edge_length);
  worn.wear(regarment::put_on(worn.pattern, clothed, wish.top_height, kClearance));
  // Drawn together slowly, or the stretched seams would throw the cloth through the body.
  fall_ = {};
  fall_.time_step = kCoarseStep;
  fall_.air = 40;
  fall_.self_contact = false;
  fall(kPulled);
  fall_ = {};
  fall_.time_step = kCoarseStep;
  fall(kFalling);
}

void Wardrobe::move() {
  if (poses_.size() < 2) return;
  const auto intervals = static_cast<double>(poses_.size() - 1);
  const double begin = simulated_;
  while (simulated_ < begin + kMoving) {
    const double u = std::min(1.0, (simulated_ - begin) / kMoving) * intervals;
    const auto i = std::min(static_cast<std::size_t>(u), poses_.size() - 2);
    const double share = u - static_cast<double>(i);
    std::vector<Vec3> at(poses_[i].positions.size());
    for (std::size_t v = 0; v < at.size(); ++v)
      at[v] = (1 - share) * poses_[i].positions[v] + share * poses_[i + 1].positions[v];
    body_.move_to(std::move(at));
    step(true);
  }
  // Twice, so that it stands still.
  body_.move_to(poses_.back().positions);
  body_.move_to(poses_.back().positions);
  body_.rebuild();
}

void Wardrobe::refine() {
  for (Worn& worn : worn_) {
    const Pattern coarse = worn.pattern;
    const std::vector<Vec3> x = worn.positions();
    make(worn, options_.edge_length);
    worn.wear(onto_finer(coarse, x, worn.pattern));
  }
}

void Wardrobe::settle() {
  fall_.air = 4;
  fall(kSettling);
  refine();
  fall_.time_step = kFineStep;
  fall(kFolding);
  for (Worn& worn : worn_) worn.rest();
  rest_.air = 10;
  const double begin = simulated_;
  while (simulated_ - begin < options_.longest && !rested_) {
    step();
    rested_ =
        simulated_ - begin > kLeastRest &&
        std::all_of(worn_.begin(), worn_.end(), [](const Worn& worn) {
          return worn.resting->speed(0.99) < kRestSpeed && worn.resting->speed(0.5) < kRestMedian;
        });
  }
}

Dressing Wardrobe::result() const {
  Dressing out;
  out.person.body = poses_.back();
  for (auto worn = worn_.rbegin(); worn != worn_.rend(); ++worn) {
    const GarmentWish& wish = *worn->wish;
    out.person.garments.push_back({wish.template_name, wish.dimensions, wish.fabric, wish.band,
                                   worn->pattern, worn->positions()});
    out.reports.push_back({rested_, worn->resting->speed(0.99), 0.0, simulated_});
  }
  yield_to_cloth(out.person);
  for (std::size_t i = 0; i < worn_.size(); ++i)
    out.reports[i].deepest =
        deepest_inside(out.person.body, worn_[worn_.size() - 1 - i].sheet.triangles,
                       out.person.garments[i].particles);
  return out;
}

void check_poses(const std::vector<Mesh>& poses) {
  if (poses.empty()) throw InvalidInput("dress_person: there is no body");
  for (const Mesh& pose : poses) {
    if (pose.triangles.empty() || pose.triangles != poses.front().triangles ||
        pose.positions.size() != poses.front().positions.size())
      throw InvalidInput("dress_person: the poses are not of one body");
  }
}

}  // namespace

void DressOptions::check() const {
  const auto range = [](const char* name, double value, double low, double high) {
    if (!(value >= low && value <= high))
      throw InvalidInput("DressOptions: " + std::string(name) + " is " + std::to_string(value) +
                         ", it must be " + std::to_string(low) + " to " + std::to_string(high));
  };
  range("edge_length", edge_length, 0.006, 0.04);
  range("longest", longest, 0.5, 60.0);
}

Dressing dress_person(const std::vector<Mesh>& poses, const std::vector<GarmentWish>& garments,
                      const DressOptions& options, const Progress& progress) {
  options.check();
  check_poses(poses);
  if (garments.empty()) return {{poses.back(), {}}, {}};
  Wardrobe wardrobe(poses, options, progress, garments.size());
  for (auto wish = garments.rbegin(); wish != garments.rend(); ++wish) wardrobe.put_on(*wish);
  wardrobe.move();
  wardrobe.settle();
  return wardrobe.result();
}

}  // namespace regarment
