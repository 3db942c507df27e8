#pragma once

#include <algorithm>
#include <array>
#include <random>
#include <string>

namespace regarment::test {

// What parsers get wrong: numbers at the ends of their range, words in the wrong place.
inline constexpr std::array kPieces{"-1",
                                    "4294967295",
                                    "2147483648",
                                    "99999999999999999999",
                                    "1e400",
                                    "nan",
                                    "-",
                                    "/",
                                    "\n",
                                    "\\\n",
                                    " ",
                                    "\r",
                                    "#",
                                    "list",
                                    "property",
                                    "element vertex 3\n",
                                    "end_header\n",
                                    "0",
                                    "64",
                                    "\xff\xff\xff\xff"};

/// `file` with one to four random damages: bytes changed, removed, repeated, replaced, or cut off.
inline std::string mutate(std::string file, std::mt19937& random) {
  const auto below = [&](std::size_t end) { return random() % end; };
  for (std::size_t changes = 1 + below(4); changes > 0 && !file.empty(); --changes) {
    const std::size_t at = below(file.size());
    const std::size_t length = 1 + below(std::min<std::size_t>(file.size() - at, 12));
    switch (below(6)) {
      case 0:
        file[at] = static_cast<char>(random());
        break;
      case 1:
        file[at] = static_cast<char>(file[at] ^ 1 << below(8));
        break;
      case 2:
        file.erase(at, length);
        break;
      case 3:
        file.insert(at, file.substr(below(file.size()), length));
        break;
      case 4:
        file.replace(at, length, kPieces[below(kPieces.size())]);
        break;
      default:
        file.resize(at);
    }
  }
  return file;
}

}  // namespace regarment::test
