#include "service/metrics.h"

#include <algorithm>

#include "report/text.h"
#include "report/version.h"

namespace regarment {
namespace {

constexpr int kDigits = 6;

std::string number(double value) { return significant_text(value, kDigits); }

void head(std::string& out, const std::string& name, const char* type, const char* help) {
  out += "# HELP " + name + " " + help + "\n# TYPE " + name + " " + type + "\n";
}

void gauge(std::string& out, const std::string& name, const char* help, double value) {
  head(out, name, "gauge", help);
  out += name + " " + fixed_text(value, 0) + "\n";
}

double age_of_oldest(const QueueFacts& facts, JobTime now) {
  if (!facts.oldest_queued) return 0;
  return std::chrono::duration<double>(now - *facts.oldest_queued).count();
}

void add_queue(std::string& out, const Service& service) {
  const QueueFacts facts = service.store.facts();
  head(out, "regarment_jobs", "gauge", "Jobs by state.");
  for (std::size_t i = 0; i < kJobStates.size(); ++i)
    out += "regarment_jobs{state=\"" + std::string(name_of(kJobStates[i])) + "\"} " +
           std::to_string(facts.jobs[i]) + "\n";
  gauge(out, "regarment_oldest_queued_seconds", "How long the first of the queue has waited.",
        age_of_oldest(facts, service.store.time()));
  gauge(out, "regarment_job_bytes", "Bytes of the files of all jobs.",
        static_cast<double>(facts.bytes));
  gauge(out, "regarment_disk_free_bytes", "Bytes free on the disk of the jobs.",
        static_cast<double>(service.folders.free_bytes()));
  const auto lease = std::chrono::duration_cast<std::chrono::milliseconds>(
      std::chrono::duration<double>(service.config.lease_seconds));
  gauge(out, "regarment_workers", "Workers that were heard of within a lease.",
        static_cast<double>(service.store.workers(service.store.time() - lease).size()));
}

}  // namespace

void Metrics::count(const std::string& method, const std::string& route, const Served& served) {
  const auto* bound = std::lower_bound(kBounds.begin(), kBounds.end(), served.seconds);
  const std::lock_guard lock(mutex_);
  ++requests_[{method, route, served.status}];
  ++times_[static_cast<std::size_t>(bound - kBounds.begin())];
  seconds_ += served.seconds;
  bytes_in_ += served.bytes_in;
  bytes_out_ += served.bytes_out;
}

std::string Metrics::text(const Service& service) const {
  std::string out;
  head(out, "regarment_build_info", "gauge", "The version of the program.");
  out += "regarment_build_info{version=\"" + version() + "\"} 1\n";
  add_queue(out, service);
  const std::lock_guard lock(mutex_);
  head(out, "regarment_http_requests_total", "counter", "Requests by method, route and status.");
  for (const auto& [key, count] : requests_) {
    const auto& [method, route, status] = key;
    out.append("regarment_http_requests_total{method=\"").append(method);
    out.append("\",route=\"").append(route);
    out.append("\",status=\"").append(std::to_string(status));
    out.append("\"} ").append(std::to_string(count)) += "\n";
  }
  head(out, "regarment_http_request_seconds", "histogram", "Time from header to answer.");
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < times_.size(); ++i) {
    sum += times_[i];
    out += "regarment_http_request_seconds_bucket{le=\"" +
           (i < kBounds.size() ? number(kBounds[i]) : "+Inf") + "\"} " + std::to_string(sum) + "\n";
  }
  out += "regarment_http_request_seconds_sum " + number(seconds_) + "\n";
  out += "regarment_http_request_seconds_count " + std::to_string(sum) + "\n";
  head(out, "regarment_http_bytes_total", "counter", "Bytes of bodies received and answers sent.");
  out += "regarment_http_bytes_total{direction=\"in\"} " + std::to_string(bytes_in_) + "\n";
  out += "regarment_http_bytes_total{direction=\"out\"} " + std::to_string(bytes_out_) + "\n";
  return out;
}

}  // namespace regarment
