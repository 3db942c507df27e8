# embed_text(OUTPUT FILES...): writes a C++ file that holds the text of FILES by name, for
# src/report/embedded.h. Strings are cut below the length every compiler accepts.
function(embed_text output)
  set(entries "")
  foreach(file ${ARGN})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    get_filename_component(name ${file} NAME)
    file(READ ${file} hex HEX)
    string(REGEX REPLACE "(................................)" "\\1\n" hex "${hex}")
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" hex "${hex}")
    string(REGEX REPLACE "([^\n]+)\n?" "      \"\\1\"\n" hex "${hex}")
    file(SIZE ${file} size)
    string(APPEND entries "    {\"${name}\", std::string(\n${hex}      , ${size})},\n")
  endforeach()
  set(text "// Made by cmake/embed_text.cmake.\n#include \"report/embedded.h\"\n\n#include <map>\n\n"
      "#include \"base/error.h\"\n\nnamespace regarment {\n\n"
      "const std::string& embedded_text(const std::string& name) {\n"
      "  static const std::map<std::string, std::string> texts = {\n${entries}  };\n"
      "  const auto found = texts.find(name);\n"
      "  if (found == texts.end()) throw InvalidInput(\"no text '\" + name + \"' is compiled in\");\n"
      "  return found->second;\n}\n\n}  // namespace regarment\n")
  string(JOIN "" text ${text})
  file(CONFIGURE OUTPUT ${output} CONTENT "${text}" @ONLY ESCAPE_QUOTES)
endfunction()
