# embed_text(OUTPUT [HEADER header.h FUNCTION name] FILES...): writes a C++ file that holds the text
# of FILES by name, for src/report/embedded.h or another header with such a function. Strings are
# cut below the length every compiler accepts.
function(embed_text output)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "HEADER;FUNCTION" "")
  if(NOT ARG_HEADER)
    set(ARG_HEADER report/embedded.h)
    set(ARG_FUNCTION embedded_text)
  endif()
  set(entries "")
  foreach(file ${ARG_UNPARSED_ARGUMENTS})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    get_filename_component(name ${file} NAME)
    file(READ ${file} hex HEX)
    string(REGEX REPLACE "(................................)" "\\1\n" hex "${hex}")
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" hex "${hex}")
    string(REGEX REPLACE "([^\n]+)\n?" "      \"\\1\"\n" hex "${hex}")
    file(SIZE ${file} size)
    string(APPEND entries "    {\"${name}\", std::string(\n${hex}      , ${size})},\n")
  endforeach()
  file(CONFIGURE OUTPUT ${output} @ONLY CONTENT "// Made by cmake/embed_text.cmake.
#include \"${ARG_HEADER}\"

#include <map>

#include \"base/error.h\"

namespace regarment {

const std::string& ${ARG_FUNCTION}(const std::string& name) {
  static const std::map<std::string, std::string> texts = {
${entries}  };
  const auto found = texts.find(name);
  if (found == texts.end()) throw InvalidInput(\"no text '\" + name + \"' is compiled in\");
  return found->second;
}

}  // namespace regarment
")
endfunction()
