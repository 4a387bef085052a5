#include "table.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <sstream>

namespace rimpact::verification {

void Table::gate(const std::string &name, double value, double bound) {
  const bool holds = std::abs(value) <= bound;
  gates_.push_back(fmt::format("gate {}: {:.3g} (bound {:.3g}): {}", name, value, bound, holds ? "met" : "MISSED"));
  if (!holds) failures_.push_back(gates_.back());
}

double Table::last_error(const std::string &quantity) const {
  for (auto row = rows_.rbegin(); row != rows_.rend(); ++row)
    if (row->quantity == quantity) return row->error();
  return std::nan("");
}

std::string Table::text() const {
  std::string text = fmt::format("{:<34} {:>10} {:>13} {:>13} {:>11} {:>6} {:>8} {:>7} {:>8}\n", "# quantity", "size",
                                 "value", "reference", "error", "order", "dofs", "newton", "seconds");
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row &row = rows_[i];
    std::string order = "-";
    for (std::size_t j = i; j-- > 0;)
      if (rows_[j].quantity == row.quantity && rows_[j].size != row.size && row.error() != 0 && rows_[j].error() != 0) {
        order = fmt::format("{:.2f}",
                            std::log(std::abs(rows_[j].error() / row.error())) / std::log(rows_[j].size / row.size));
        break;
      }
    text += fmt::format("{:<34} {:>10.4g} {:>13.6g} {:>13.6g} {:>11.3e} {:>6} {:>8} {:>7} {:>8.2f}\n", row.quantity,
                        row.size, row.value, row.reference, row.error(), order, row.dofs, row.iterations, row.seconds);
  }
  for (const auto &line : gates_) text += line + "\n";
  for (const auto &line : notes_) text += "# " + line + "\n";
  return text;
}

std::vector<std::string> Table::differences(const std::string &stored, double tolerance) const {
  std::vector<std::string> result;
  std::istringstream lines(stored);
  std::size_t i = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#' || line.rfind("gate", 0) == 0) continue;
    if (i >= rows_.size()) {
      result.push_back("the baseline has more rows");
      break;
    }
    const Row &row = rows_[i++];
    std::istringstream fields(line.substr(std::min(std::max<std::size_t>(34, row.quantity.size()), line.size())));
    double size = 0, value = 0;
    fields >> size >> value;
    // Where nothing is expected, what is left is rounding and tolerances: looser.
    const double scale =
        row.reference != 0 ? std::max(std::abs(row.reference), std::abs(value)) : 10 * std::max(std::abs(value), 1e-9);
    if (line.substr(0, row.quantity.size()) != row.quantity || std::abs(value - row.value) > tolerance * scale)
      result.push_back(fmt::format("{}: {:.6g}, the baseline says: {}", row.quantity, row.value, line));
  }
  if (i < rows_.size()) result.push_back("the baseline has fewer rows");
  return result;
}

} // namespace rimpact::verification
