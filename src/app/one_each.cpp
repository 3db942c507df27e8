#include "app/one_each.h"

#include <CLI/CLI.hpp>

namespace regarment {

CLI::Option* one_each(CLI::Option* option) {
  return option->allow_extra_args(false)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

}  // namespace regarment
