#include "service/service.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/one_line.h"
#include "garment/find_template.h"
#include "http/problem.h"
#include "jobs/job_options.h"

namespace regarment {
namespace {

constexpr std::uint64_t kMega = 1'000'000;
constexpr std::size_t kMostGarments = 8;

[[noreturn]] void refuse_garments(const std::string& what) {
  std::string names;
  for (const TemplateEntry& entry : list_templates())
    names += (names.empty() ? "" : ", ") + entry.name;
  throw HttpProblem(422, "bad_garments",
                    "garments: " + what + "; give names of templates, outermost first: " + names);
}

std::vector<std::string> split_at_commas(const std::string& text) {
  std::vector<std::string> out;
  for (const std::string_view name : list_members(text)) out.emplace_back(name);
  return out;
}

std::vector<std::string> names_in(const std::string& text) {
  if (!text.starts_with('[')) return split_at_commas(text);
  try {
    return nlohmann::json::parse(text).get<std::vector<std::string>>();
  } catch (const nlohmann::json::exception&) {
    refuse_garments("no JSON array of texts");
  }
}

}  // namespace

Job find_job(const Service& service, const std::string& id) {
  if (is_job_id(id))
    if (std::optional<Job> job = service.store.find(id)) return *job;
  throw HttpProblem(404, "no_such_job", "there is no job of this id; GET /v1/jobs lists them");
}

void check_room(const Service& service, const std::string& owner) {
  const ServiceConfig& config = service.config;
  if (service.folders.free_bytes() < config.min_free_mb * kMega)
    throw HttpProblem(507, "no_space", "the disk of the service is nearly full; try again later");
  if (service.store.queued_jobs(config.max_queue) >= config.max_queue)
    throw HttpProblem(429, "queue_full", "the queue is full; try again later",
                      {{"Retry-After", "30"}});
  if (owner.empty()) return;
  if (service.store.open_jobs_of(owner) >= config.max_jobs_per_key)
    throw HttpProblem(429, "too_many_jobs",
                      "this key has " + std::to_string(config.max_jobs_per_key) +
                          " jobs that have not ended; wait for some of them",
                      {{"Retry-After", "30"}});
  if (config.quota_mb > 0 && service.store.bytes_of(owner) >= config.quota_mb * kMega)
    throw HttpProblem(507, "quota_used_up",
                      "the jobs of this key take up their " + std::to_string(config.quota_mb) +
                          " MB; delete some of them");
}

void check_options(const Service& service, JobKind kind, const std::vector<std::string>& garments,
                   const std::string& options) try {
  service.check_words(kind, garments, option_words(options));
} catch (const UsageError& error) {
  throw HttpProblem(422, "bad_options", error.what());
}

std::vector<std::string> read_garments(const std::string& text) {
  std::vector<std::string> names = names_in(text);
  if (names.empty()) refuse_garments("none given");
  if (names.size() > kMostGarments) refuse_garments("more than 8 given");
  const std::vector<TemplateEntry> known = list_templates();
  for (const std::string& name : names)
    if (std::none_of(known.begin(), known.end(),
                     [&](const TemplateEntry& entry) { return entry.name == name; }))
      refuse_garments("'" + one_line(name, 60) + "' is no template");
  return names;
}

}  // namespace regarment
