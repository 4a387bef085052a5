// hard_cases_reduced [--baseline FILE] [--write FILE]: the table of hard cases of the reduced model, on
// standard output. Exit 1: a row that must be right is not, or the table differs from the baseline.
#include "table.h"
#include <fmt/format.h>
#include <fstream>
#include <iterator>

using namespace rimpact::hard_cases;

int main(int argc, char **argv) {
  std::string baseline, written;
  for (int i = 1; i + 1 < argc; i += 2) (std::string(argv[i]) == "--write" ? written : baseline) = argv[i + 1];
  std::string table = "# Hard cases of the reduced model; rows with * must be right. Made by hard_cases_reduced.\n"
                      "# off: against CVODE at 1e-11; energy: imbalance over the largest input.\n" +
                      header();
  fmt::print("{}", table);
  std::vector<std::string> failures;
  for (const auto &hard : cases()) {
    const Outcome outcome = judge(hard);
    fmt::print("{}", row(outcome));
    table += row(outcome);
    for (const auto &what : outcome.failures) failures.push_back(hard.name + ": " + what);
  }
  if (!written.empty()) std::ofstream(written) << table;
  if (!baseline.empty()) {
    std::ifstream file(baseline);
    const std::string stored{std::istreambuf_iterator<char>(file), {}};
    for (const auto &line : differences(table, stored)) failures.push_back(line);
  }
  for (const auto &what : failures) fmt::print("FAILED {}\n", what);
  return failures.empty() ? 0 : 1;
}
