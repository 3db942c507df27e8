#include "report/write_review.h"

#include <algorithm>
#include <cerrno>
#include <set>
#include <string>

#include "base/error.h"
#include "base/sha256.h"
#include "report/files.h"
#include "report/review_page.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostResults = 2000;
constexpr std::size_t kMostJson = 64u << 20;     // bytes of a stored result.json
constexpr std::size_t kMostPicture = 16u << 20;  // and of a stored picture
constexpr int kPictureHeight = 400;              // pixels

bool is_result(const fs::path& folder) {
  std::error_code error;
  return fs::is_regular_file(folder / "result.json", error);
}

std::vector<fs::path> results_in(const fs::path& folder) {
  std::vector<fs::path> out;
  std::error_code error;
  for (fs::directory_iterator i(folder, error), end; !error && i != end; i.increment(error)) {
    const bool unfinished = i->path().filename().string().starts_with(".");
    if (!unfinished && is_result(i->path())) out.push_back(i->path());
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<fs::path> results_of(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    throw UsageError(folder.string() +
                     ": is no folder; give folders of 'regarment fit' or 'regarment evaluate'");
  }
  if (is_result(folder)) return {folder};
  std::vector<fs::path> out = results_in(folder);
  if (out.empty()) out = results_in(folder / "fits");
  if (out.empty()) {
    throw UsageError(folder.string() +
                     ": holds no result; give folders of 'regarment fit' or 'regarment evaluate'");
  }
  return out;
}

// A path as an address: everything but plain letters, digits and a few signs as %XX.
std::string address_of(const fs::path& path) {
  constexpr const char* kDigits = "0123456789ABCDEF";
  std::string out;
  for (const char c : path.generic_string()) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("-_.~/").find(c) != std::string_view::npos;
    const auto byte = static_cast<unsigned char>(c);
    if (plain) {
      out += c;
    } else {
      out.append({'%', kDigits[byte / 16], kDigits[byte % 16]});
    }
  }
  return out;
}

std::string link_to_report(const fs::path& folder, const fs::path& page_folder) {
  std::error_code error;
  if (!fs::is_regular_file(folder / "report.html", error)) return {};
  const fs::path from = fs::weakly_canonical(page_folder);
  const fs::path to = fs::weakly_canonical(fs::absolute(folder)) / "report.html";
  return address_of(to.lexically_relative(from));
}

std::string picture_of(const Result& result, const fs::path& folder, const std::string& view) {
  for (const StoredFigure& figure : result.figures) {
    if (figure.kind == "segmentation" && figure.view == view) {
      return read_file(folder / figure.file, kMostPicture);
    }
  }
  return {};
}

std::string name_for(const fs::path& folder, std::set<std::string>& taken) {
  const std::string wish = fs::weakly_canonical(folder).filename().string();
  std::string name = wish;
  for (int i = 2; !taken.insert(name).second; ++i) name = wish + " (" + std::to_string(i) + ")";
  return name;
}

ReviewItem read_item(const fs::path& folder, const fs::path& page_folder, std::string name) {
  const std::string json = read_file(folder / "result.json", kMostJson);
  ReviewItem out;
  out.name = std::move(name);
  out.digest = sha256_hex(std::as_bytes(std::span(json))).substr(0, 16);
  out.result = parse_result(json, (folder / "result.json").string());
  out.link = link_to_report(folder, page_folder);
  const std::string front = picture_of(out.result, folder, "front");
  const std::string back = picture_of(out.result, folder, "back");
  if (!front.empty() && !back.empty()) {
    out.picture = make_thumbnail(front, back, kPictureHeight, folder.string());
  }
  return out;
}

void check_place(const fs::path& page, bool replace) {
  std::error_code error;
  if (fs::is_directory(page, error)) {
    throw UsageError(page.string() + ": is a folder; give --out a file, such as review.html");
  }
  if (fs::exists(page, error) && !replace) {
    throw UsageError(page.string() + ": is there already; choose another --out or use --force");
  }
}

void put_in_place(const fs::path& page, const std::string& text) {
  std::error_code error;
  const fs::path folder = fs::absolute(page).parent_path();
  fs::create_directories(folder, error);
  if (error) throw_write_error(folder, error.value());
  const fs::path hidden = folder / ("." + page.filename().string() + ".part");
  fs::remove(hidden, error);
  write_file(hidden, text);
  fs::rename(hidden, page, error);
  if (!error) return;
  const int why = error.value();
  fs::remove(hidden, error);
  throw_write_error(page, why);
}

}  // namespace

std::vector<fs::path> find_results(const std::vector<fs::path>& folders) {
  std::vector<fs::path> out;
  std::set<fs::path> seen;
  for (const fs::path& folder : folders) {
    for (const fs::path& result : results_of(folder)) {
      if (seen.insert(fs::weakly_canonical(result)).second) out.push_back(result);
    }
  }
  if (out.size() > kMostResults) {
    throw UsageError(std::to_string(out.size()) + " results are more than 2000; give fewer");
  }
  return out;
}

void write_review(const std::vector<fs::path>& folders, const fs::path& page, bool replace,
                  const Progress& progress) {
  const std::vector<fs::path> results = find_results(folders);
  check_place(page, replace);
  const fs::path page_folder = fs::absolute(page).parent_path();
  std::vector<ReviewItem> items;
  std::set<std::string> taken;
  for (const fs::path& folder : results) {
    progress.report("read",
                    static_cast<double>(items.size()) / static_cast<double>(results.size()));
    items.push_back(read_item(folder, page_folder, name_for(folder, taken)));
  }
  progress.report("read", 1);
  put_in_place(page, review_page(items));
}

}  // namespace regarment
