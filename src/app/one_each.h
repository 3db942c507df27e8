#pragma once

namespace CLI {
class Option;
}

namespace regarment {

/// An option that takes one value each time it is given: "--garment tshirt --garment skirt", never
/// "--garment tshirt skirt". Returns the option.
CLI::Option* one_each(CLI::Option* option);

}  // namespace regarment
