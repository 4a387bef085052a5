/// A verification case's table: value, reference, error and observed order over meshes or steps, kept as a text
/// baseline; and its gates.
#pragma once
#include <chrono>
#include <string>
#include <vector>

namespace rimpact::verification {

struct Row {
  std::string quantity;
  double size; ///< of the cells or the step
  double value, reference;
  std::size_t dofs = 0;
  int iterations = 0; ///< Newton's, all
  double seconds = 0;
  double error() const { return reference != 0 ? value / reference - 1 : value; }
};

class Table {
public:
  void add(const Row &row) { rows_.push_back(row); }
  void note(const std::string &text) { notes_.push_back(text); }
  /// A gate: `name` holds when |value| <= bound.
  void gate(const std::string &name, double value, double bound);
  const std::vector<Row> &rows() const { return rows_; }
  /// Relative error of the last row of a quantity.
  double last_error(const std::string &quantity) const;

  std::string text() const;
  const std::vector<std::string> &failures() const { return failures_; }
  /// Values of a stored text that differ from this table's by more than `tolerance`, a sentence each.
  std::vector<std::string> differences(const std::string &stored, double tolerance) const;

private:
  std::vector<Row> rows_;
  std::vector<std::string> notes_, gates_, failures_;
};

class Timer {
public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// A case: its name on the command line, the VERIFICATION number it answers, and whether it is quick.
struct Case {
  std::string name, title;
  Table (*run)();
};

Table rigid_bar();
Table elastic_bars();
Table signorini_bar();
Table taylor_bar();
Table taylor_bar_rate();
Table hertz_cylinder();
Table hertz_sphere();
Table mindlin_cylinder();
Table mindlin_sphere();
Table contact_patch();
Table incline();
Table ironing();
Table thick_cylinder();
Table cook_membrane();
Table hard_states();
Table hertz_two_bodies();
Table mindlin_two_bodies();
Table patch_two_bodies();
Table ironing_two_bodies();

} // namespace rimpact::verification
