#include "garment/pattern_style.h"

namespace regarment {

namespace {

const char* const kStandaloneStyle = ".rp-pattern{color:#1d2126;background:#fff}\n";
const char* const kAccent = "var(--rp-accent,#c2410c)";
const char* const kPlainAccent = "#c2410c";
const char* const kInlineStyle = ".rp-pattern{max-width:100%;height:auto}\n";
// Sizes in em of the font size that stands on the svg element, so that two drawings of different
// scale on one page agree on every rule.
const char* const kStyle =
    R"(.rp-pattern text{font-family:system-ui,'Helvetica Neue',Arial,sans-serif;fill:currentColor}
.rp-cloth{fill:currentColor;fill-opacity:.045;stroke:none}
.rp-cut,.rp-notch,.rp-seam,.rp-line,.rp-centre,.rp-grain,.rp-rule,.rp-scale{fill:none;stroke:currentColor}
.rp-cut{stroke-width:.17em;stroke-linejoin:round;stroke-linecap:round}
.rp-notch{stroke-width:.12em}
.rp-seam{stroke-width:.1em;stroke-dasharray:.7em .45em}
.rp-line{stroke-width:.05em;stroke-opacity:.6;stroke-dasharray:.3em .3em}
.rp-centre{stroke-width:.05em;stroke-opacity:.6;stroke-dasharray:1.6em .3em .3em .3em}
.rp-grain{stroke-width:.08em}
.rp-grain-head{fill:currentColor}
.rp-rule{stroke-width:.06em;stroke-opacity:.35}
.rp-scale{stroke-width:.07em}
.rp-measure,.rp-extension{fill:none;stroke:var(--rp-accent,#c2410c)}
.rp-measure{stroke-width:.09em}
.rp-extension{stroke-width:.045em;stroke-opacity:.7}
.rp-pattern .rp-label,.rp-pattern .rp-value,.rp-measure-head{fill:var(--rp-accent,#c2410c)}
.rp-label,.rp-code,.rp-title{font-weight:600}
.rp-title{font-size:1.7em}
.rp-small,.rp-head{font-size:.82em;fill-opacity:.72}
.rp-number{font-variant-numeric:tabular-nums}
.rp-badge{fill:var(--rp-accent,#c2410c);stroke:none}
.rp-pattern .rp-letter{fill:#fff;font-weight:700}
.rp-halo{stroke:#fff;stroke-width:.35em;stroke-linejoin:round;paint-order:stroke}
)";

}  // namespace

std::string pattern_style(bool standalone) {
  std::string text = standalone ? kStandaloneStyle : kInlineStyle;
  text += kStyle;
  if (!standalone) return text;
  const std::string accent = kAccent;
  for (std::size_t at = text.find(accent); at != std::string::npos; at = text.find(accent, at))
    text.replace(at, accent.size(), kPlainAccent);
  return text;
}

}  // namespace regarment
