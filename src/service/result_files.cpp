#include "service/result_files.h"

#include <array>

namespace regarment {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::pair<std::string_view, std::string_view>, 14> kTypes{{
    {".html", "text/html; charset=utf-8"},
    {".json", "application/json"},
    {".csv", "text/csv; charset=utf-8"},
    {".svg", "image/svg+xml"},
    {".png", "image/png"},
    {".jpg", "image/jpeg"},
    {".webp", "image/webp"},
    {".glb", "model/gltf-binary"},
    {".ply", "application/octet-stream"},
    {".dxf", "image/vnd.dxf"},
    {".val", "application/xml"},
    {".txt", "text/plain; charset=utf-8"},
    {".css", "text/css; charset=utf-8"},
    {".js", "text/javascript; charset=utf-8"},
}};

[[noreturn]] void refuse() {
  throw HttpProblem(404, "no_such_file",
                    "the result has no such file; 'files' of the job lists what it has");
}

// A page brings its own, stricter policy; the sandbox keeps what is in it away from the API.
constexpr const char* kPagePolicy =
    "frame-ancestors 'self'; sandbox allow-scripts allow-popups allow-downloads allow-modals";
constexpr const char* kPicturePolicy = "default-src 'none'; style-src 'unsafe-inline'; sandbox";

}  // namespace

Response result_file(const Request& request, const fs::path& folder,
                     const std::vector<std::string>& segments) {
  fs::path name;
  for (const std::string& segment : segments) {
    if (segment.starts_with('.')) refuse();
    name /= segment;
  }
  const std::string type = media_type(name.string());
  std::optional<Response> response = file_response(request, folder, name, type);
  if (!response) refuse();
  response->headers.add("Cache-Control", "private, no-cache");
  if (type.starts_with("text/html"))
    response->headers.add("Content-Security-Policy", kPagePolicy);
  else if (type == "image/svg+xml")
    response->headers.add("Content-Security-Policy", kPicturePolicy);
  return std::move(*response);
}

std::string media_type(const std::string& name) {
  for (const auto& [end, type] : kTypes)
    if (name.ends_with(end)) return std::string(type);
  return "application/octet-stream";
}

}  // namespace regarment
