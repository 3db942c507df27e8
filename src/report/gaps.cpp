#include "report/gaps.h"

#include <kainjow/mustache.hpp>

#include "base/error.h"

namespace regarment {
namespace {

namespace mustache = kainjow::mustache;

mustache::data data_of(const Gaps& gaps);

struct ToData {
  mustache::data operator()(const std::string& text) const { return text; }
  mustache::data operator()(bool yes) const {
    return yes ? mustache::data::type::bool_true : mustache::data::type::bool_false;
  }
  mustache::data operator()(const std::vector<Gaps>& items) const {
    mustache::data out(mustache::data::type::list);
    for (const Gaps& item : items) out.push_back(data_of(item));
    return out;
  }
};

mustache::data data_of(const Gaps& gaps) {
  mustache::data object(mustache::data::type::object);
  for (const auto& [name, value] : gaps.values) object.set(name, std::visit(ToData{}, value));
  return object;
}

}  // namespace

std::string fill_template(const std::string& text, const Gaps& gaps) {
  mustache::mustache page(text);
  if (!page.is_valid()) throw InvalidInput("page template: " + page.error_message());
  return page.render(data_of(gaps));
}

}  // namespace regarment
