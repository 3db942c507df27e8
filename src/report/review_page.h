#pragma once

#include <string>
#include <vector>

#include "report/result.h"
#include "report/thumbnail.h"

namespace regarment {

/// A result that is to be reviewed.
struct ReviewItem {
  std::string name;    // of its own among the items: its folder's
  std::string digest;  // of result.json; a verdict is about these bytes
  std::string link;    // from the page to the report, an address; empty: there is none
  Result result;
  Thumbnail picture;  // its labels from the front and from behind; empty: none was drawn
};

/// One page over many results, to go through by keyboard: a contact sheet of labels, lights and
/// dimensions, each to be accepted or rejected, with notes. The page keeps verdicts in the browser
/// and hands them out as CSV and JSON. It requests nothing; without scripts it is the contact sheet
/// alone. Depends on its arguments alone.
std::string review_page(const std::vector<ReviewItem>& items);

}  // namespace regarment
