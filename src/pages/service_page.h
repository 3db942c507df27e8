#pragma once

#include <optional>
#include <string>
#include <vector>

namespace regarment {

/// What a browser is given for an address of the service's pages: a page, or one of the files that
/// pages name. None of them holds anything of a job: pages fetch that over /v1 with what their
/// reader may see, so they can be given to everybody.
struct ServicePage {
  std::string content_type;
  std::string text;
  // The Content-Security-Policy to send with it: scripts, styles and pictures of this service
  // alone, nothing inline, nothing from elsewhere, in no frame.
  std::string policy;
};

/// The page at a path, given as its decoded segments ("/" is none or one empty):
///   /  /review  /evaluate  /jobs/ID  /jobs/ID/correct  /pages/FILE
/// FILE is a script, style.css, garments.json (garment_choices.h) or garment-NAME.svg. An ID may be
/// anything: whether there is such a job the page finds out. Nothing for other paths. The same
/// bytes each time.
std::optional<ServicePage> service_page(const std::vector<std::string>& path);

/// The paths of `service_page` as patterns of a router: "/jobs/{id}".
const std::vector<std::string>& service_page_patterns();

}  // namespace regarment
