#include "responses/script_files.h"

#include "io/files/error.h"
#include "io/files/file.h"
#include <filesystem>
#include <set>

namespace rimpact {
namespace {

namespace fs = std::filesystem;

bool is_script(const fs::path &file) {
  const std::string ending = file.extension().string();
  return ending.size() == 4 && (ending[1] | 32) == 'g' && (ending[2] | 32) == 'e' && (ending[3] | 32) == 'o';
}

std::vector<std::string> strings_in(const std::string &text) {
  std::vector<std::string> strings;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] != '"' && text[at] != '\'') continue;
    const std::size_t end = text.find_first_of(std::string(1, text[at]) + "\n", at + 1);
    if (end == std::string::npos) break;
    if (text[end] == text[at]) strings.push_back(text.substr(at + 1, end - at - 1));
    at = end;
  }
  return strings;
}

void collect(const fs::path &script, std::set<std::string> &files) {
  std::string text;
  try {
    text = read_file(script.string());
  } catch (const Error &) { // whoever reads it says so
    return;
  }
  for (const auto &name : strings_in(text)) {
    if (name.find('\0') != std::string::npos) continue;
    const fs::path file = (script.parent_path() / name).lexically_normal();
    std::error_code none;
    if (!fs::is_regular_file(file, none) || !files.insert(file.string()).second) continue;
    if (is_script(file)) collect(file, files);
  }
}

} // namespace

std::vector<std::string> files_named_in(const std::string &script) {
  const fs::path file = fs::absolute(script).lexically_normal();
  if (!is_script(file)) return {};
  std::set<std::string> files{file.string()};
  collect(file, files);
  files.erase(file.string());
  return {files.begin(), files.end()};
}

} // namespace rimpact
