#include "pages/service_page.h"
#include "service/routes.h"

namespace regarment {
namespace {

Response show_page(const Call& call) {
  std::optional<ServicePage> page = service_page(call.request.path);
  if (!page) throw HttpProblem(404, "no_such_page", "there is no such page; begin at /");
  Response out = text_response(200, page->content_type, std::move(page->text));
  out.headers = {{"Content-Security-Policy", page->policy}, {"Cache-Control", "no-cache"}};
  return with_etag(call.request, std::move(out));
}

}  // namespace

std::vector<Route> page_routes() {
  std::vector<Route> out;
  for (const std::string& pattern : service_page_patterns()) {
    Route route{"GET", pattern, {}, show_page};
    route.open = true;
    out.push_back(std::move(route));
  }
  return out;
}

}  // namespace regarment
