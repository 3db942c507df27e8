#pragma once

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <vector>

// Reads a page as strictly as a validator where it matters here: elements nest and are closed,
// names of places are unique.

namespace regarment {

struct HtmlOutline {
  std::string mistake;               // the first one, empty when there is none
  std::set<std::string> ids;         // of every element
  std::set<std::string> references;  // what links, labels and descriptions point to in the page
};

class HtmlReader {
 public:
  explicit HtmlReader(const std::string& page) : page_(page) {}

  HtmlOutline read() {
    for (at_ = page_.find('<'); at_ != std::string::npos && out_.mistake.empty();
         at_ = page_.find('<', at_)) {
      const auto end = page_.find('>', at_);
      if (end == std::string::npos) return fail("a tag without an end");
      const std::string tag = page_.substr(at_ + 1, end - at_ - 1);
      at_ = end + 1;
      if (!tag.empty() && tag[0] != '!') take(tag);
    }
    if (!open_.empty()) fail("never closed: " + open_.back());
    return out_;
  }

 private:
  HtmlOutline& fail(const std::string& what) {
    if (out_.mistake.empty()) out_.mistake = what;
    return out_;
  }

  void take(const std::string& tag) {
    static constexpr std::array kVoid = {"meta", "img", "input", "br", "link", "hr"};
    if (tag[0] == '/') {
      if (open_.empty() || open_.back() != tag.substr(1)) fail("closed out of order: " + tag);
      if (!open_.empty()) open_.pop_back();
      return;
    }
    const std::string name = tag.substr(0, tag.find_first_of(" /\n"));
    read_attributes(tag);
    if (tag.back() == '/' || std::find(kVoid.begin(), kVoid.end(), name) != kVoid.end()) return;
    open_.push_back(name);
    if (name == "style" || name == "script") at_ = page_.find("</" + name, at_);
  }

  void read_attributes(const std::string& tag) {
    const std::string id = attribute(tag, "id");
    if (!id.empty() && !out_.ids.insert(id).second) fail("twice the id " + id);
    const std::string href = attribute(tag, "href");
    if (href.starts_with("#")) out_.references.insert(href.substr(1));
    for (const char* name : {"aria-labelledby", "for"}) {
      const std::string value = attribute(tag, name);
      for (std::size_t from = 0; from < value.size();) {
        const auto end = std::min(value.find(' ', from), value.size());
        out_.references.insert(value.substr(from, end - from));
        from = end + 1;
      }
    }
  }

  static std::string attribute(const std::string& tag, const std::string& name) {
    const std::string start = " " + name + "=\"";
    const auto from = tag.find(start);
    if (from == std::string::npos) return {};
    const auto begin = from + start.size();
    return tag.substr(begin, tag.find('"', begin) - begin);
  }

  const std::string& page_;
  std::size_t at_ = 0;
  std::vector<std::string> open_;
  HtmlOutline out_;
};

inline HtmlOutline read_html(const std::string& page) { return HtmlReader(page).read(); }

}  // namespace regarment
