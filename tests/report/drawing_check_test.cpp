#include "report/drawing_check.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace regarment {
namespace {

std::string svg(const std::string& inside) {
  return "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\">" + inside + "</svg>";
}

TEST(DrawingCheck, PassesShapesAndText) {
  EXPECT_NO_THROW(check_drawing(
      svg("<!-- front --><g id=\"a\"><path d=\"M0 0H1\"/><text x=\"1\">A &amp; B</text></g>"
          "<use href=\"#a\" />"),
      "p.svg"));
}

TEST(DrawingCheck, RefusesEverythingThatRunsOrFetches) {
  for (const std::string bad : {"<script>alert(1)</script>",
                                "<SCRIPT>1</SCRIPT>",
                                "<foreignObject/>",
                                "<image/>",
                                "<a href=\"#x\">x</a>",
                                "<path onload=\"x()\"/>",
                                "<use href=\"http://x/\"/>",
                                "<use href=\"javascript:x\"/>",
                                "<path fill=\"url(//x)\"/>",
                                "<animate/>",
                                "<iframe/>",
                                "<!DOCTYPE svg>",
                                "<![CDATA[x]]>",
                                "<path d='M0'/>",
                                "<path d=\"M0",
                                "<path d",
                                "<meta http-equiv=\"refresh\"/>",
                                "<!-- open",
                                "<",
                                "</path x=\"1\">"}) {
    EXPECT_THROW(check_drawing(svg(bad), "p.svg"), ReadError) << bad;
  }
}

TEST(DrawingCheck, RefusesWhatIsNoDrawing) {
  EXPECT_THROW(check_drawing("", "p.svg"), ReadError);
  EXPECT_THROW(check_drawing("<html></html>", "p.svg"), ReadError);
}

}  // namespace
}  // namespace regarment
