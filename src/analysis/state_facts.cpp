#include "analysis/state_facts.h"

#include <algorithm>

namespace regarment {
namespace {

constexpr std::size_t kDigest = 64, kMostText = 4096, kMostFindings = 1000;
constexpr double kTallest = 100;  // m, what no scanned person's figures reach

bool is_axis(const std::string& name) {
  return name == "free" || (name.size() == 2 && (name[0] == '+' || name[0] == '-') &&
                            name[1] >= 'x' && name[1] <= 'z');
}

void check_facts(const ScanFacts& f, const StateReader& in) {
  const std::vector<std::string> units = {"mm", "cm", "m", "inch"};
  if (std::find(units.begin(), units.end(), f.units) == units.end()) in.refuse("an unknown unit");
  if (!is_axis(f.up) || !is_axis(f.front)) in.refuse("an unknown axis");
  const bool hexadecimal = f.sha256.find_first_not_of("0123456789abcdef") == std::string::npos &&
                           (f.sha256.empty() || f.sha256.size() == kDigest);
  if (!hexadecimal) in.refuse("the digest of the scan is none");
  const bool sensible = f.front_confidence >= 0 && f.front_confidence <= 1 && f.noise >= 0 &&
                        f.noise <= kTallest && f.spacing >= 0 && f.spacing <= kTallest &&
                        f.height > 0 && f.height <= kTallest;
  if (!sensible) in.refuse("its figures are of no person");
}

Finding read_finding(StateReader& in) {
  Finding out;
  out.code = in.text(kMostText);
  const auto severity = in.value<std::uint8_t>();
  if (severity > static_cast<std::uint8_t>(Severity::Problem)) in.refuse("an unknown severity");
  out.severity = static_cast<Severity>(severity);
  for (std::string* text : {&out.found, &out.done, &out.advice}) *text = in.text(kMostText);
  const bool named = out.code.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") == std::string::npos;
  if (out.code.empty() || !named || out.found.empty()) in.refuse("a finding without words");
  return out;
}

}  // namespace

void write_facts(const ScanFacts& f, StateWriter& out) {
  for (const std::string* text : {&f.file, &f.sha256, &f.units, &f.up, &f.front}) out.text(*text);
  for (const bool guessed : {f.units_guessed, f.up_guessed, f.front_guessed})
    out.value(static_cast<std::uint8_t>(guessed));
  for (const double v : {f.front_confidence, f.noise, f.spacing, f.height}) out.value(v);
  out.number(f.outliers);
  out.number(f.holes);
  out.number(f.findings.size());
  for (const Finding& finding : f.findings) {
    out.text(finding.code);
    out.value(static_cast<std::uint8_t>(finding.severity));
    for (const std::string* text : {&finding.found, &finding.done, &finding.advice})
      out.text(*text);
  }
}

ScanFacts read_facts(StateReader& in) {
  ScanFacts f;
  for (std::string* text : {&f.file, &f.sha256, &f.units, &f.up, &f.front})
    *text = in.text(kMostText);
  for (bool* guessed : {&f.units_guessed, &f.up_guessed, &f.front_guessed})
    *guessed = in.value<std::uint8_t>() != 0;
  for (double* v : {&f.front_confidence, &f.noise, &f.spacing, &f.height}) *v = in.value<double>();
  f.outliers = in.number();
  f.holes = in.number();
  const std::size_t findings = in.count(1);
  if (findings > kMostFindings) in.refuse("too many findings");
  for (std::size_t i = 0; i < findings; ++i) f.findings.push_back(read_finding(in));
  check_facts(f, in);
  return f;
}

}  // namespace regarment
