#pragma once

#include "garment/find_template.h"
#include "measure/garment_region.h"
#include "segmentation/segment.h"
#include "support/made_person.h"

namespace regarment::test {

/// A person in a made skirt, taken through all that comes before labelling.
struct Dressed {
  explicit Dressed(const PersonPlan& made) : plan(made), person(make_person(made)) {
    look(person.mesh);
  }
  Dressed(const PersonPlan& made, const Mesh& mesh) : plan(made), person(make_person(made)) {
    look(mesh);
  }
  Dressed(const Dressed&) = delete;  // the region borrows the edges
  Dressed& operator=(const Dressed&) = delete;

  PersonPlan plan;
  MadePerson person;
  Scan scan;
  SurfaceSamples samples;
  Body body;
  GarmentEdges edges;
  std::vector<BodyPart> parts;  // per vertex of the scan

  Labels labels() const {
    Labels out;
    label_region(scan, parts, GarmentRegion(edges, body), 1, out);
    return out;
  }

 private:
  void look(const Mesh& mesh) {
    scan = scan_of(mesh);
    samples = sample_surface(mesh, 0.006);
    body = find_body(samples, MadePerson::kHeight);
    const GarmentTemplate skirt = find_template("skirt");
    const Pattern pattern = make_pattern(skirt, skirt.typical(), 0.05);
    edges = find_garment_edges(samples, body, pattern, skirt.name(), {});
    parts = vertex_parts(scan, samples, body);
  }
};

inline PersonPlan in_skirt(const MadeSkirt& skirt = {}) {
  PersonPlan plan;
  plan.skirt = skirt;
  return plan;
}

}  // namespace regarment::test
