#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/analyze.h"

namespace CLI {
class App;
}

namespace regarment {

/// A name and a length as a person gave them.
struct NamedLength {
  std::string name;
  double cm = 0;
};

/// What a person knows of the garments: --fix, --hint and --fabric.
struct KnownArguments {
  std::vector<std::string> fix, hint;  // "length=54", "skirt.waist=70,hip=95"; "waist_edge=103"
  std::string fabric;                  // empty: not said
};

/// Declares the options.
void add_known_options(CLI::App& command, KnownArguments& a);

/// Their form alone, which needs no templates. Throws UsageError.
void check_known(const KnownArguments& a);

/// The lengths of "NAME=CM[,NAME=CM ...]", each text checked. `option` is for messages. Throws
/// UsageError for text of another form, a name given twice, and a length outside of 0 to 1000 cm.
std::vector<NamedLength> named_lengths(const std::string& option,
                                       const std::vector<std::string>& texts);

/// Puts them where the analysis reads them: a dimension or an edge goes to the only garment that
/// has one of its name, or to the one named before a dot. Throws UsageError that lists the names
/// there are, or says how to name one of several.
void apply_known(const KnownArguments& a, const std::vector<GarmentTemplate>& templates,
                 AnalyzeOptions& how);

/// What was known before and what is known now, which counts more where both speak of the same.
KnownArguments more_known(const KnownArguments& before, const KnownArguments& now);

/// Those given, name without dashes and value.
std::vector<std::pair<std::string, std::string>> chosen_known(const KnownArguments& a);

}  // namespace regarment
