#include "fe_contact/drive/state_visitor.h"

namespace rimpact::fe {

void StateVisitor::number(const std::string &name, double &value, Limits limits) {
  std::vector<double> one{value};
  numbers(name, one, limits);
  value = one.front();
}

void StateVisitor::flag(const std::string &name, bool &value) {
  int written = value ? 1 : 0;
  integer(name, written, 0, 1);
  value = written != 0;
}

void StateVisitor::vector(const std::string &name, Eigen::VectorXd &values) {
  std::vector<double> all(values.data(), values.data() + values.size());
  numbers(name, all);
  if (reads()) values = Eigen::Map<const Eigen::VectorXd>(all.data(), values.size());
}

void StateVisitor::points(const std::string &name, std::vector<Eigen::Vector3d> &list) {
  rows(name, list, 3, [](Eigen::Vector3d &point) { return point.data(); });
}

void StateVisitor::point(const std::string &name, Eigen::Vector3d &value, Limits limits) {
  std::vector<double> all(value.data(), value.data() + 3);
  numbers(name, all, limits);
  std::copy_n(all.begin(), 3, value.data());
}

void StateVisitor::part(const std::string &part, const std::function<void()> &body) {
  const std::string outside = std::exchange(prefix_, prefix_ + part + "_");
  body();
  prefix_ = outside;
}

void StateWriter::numbers(const std::string &name, std::vector<double> &values, Limits, bool) {
  file_.numbers[full(name)] = values;
}

void StateWriter::text(const std::string &name, std::string &text) {
  file_.texts[full(name)] = text;
}

void StateWriter::damaged(const std::string &name, const std::string &what) const {
  throw std::logic_error("field " + full(name) + " " + what); // a bug: the program has written it
}

void StateReader::numbers(const std::string &name, std::vector<double> &values, Limits limits, bool any_length) {
  const std::string whole = full(name);
  values = any_length ? file_.field(whole, limits) : file_.field(whole, values.size(), limits);
}

void StateReader::text(const std::string &name, std::string &text) {
  text = file_.text(full(name));
}

void StateReader::damaged(const std::string &name, const std::string &what) const {
  file_.damaged("field " + full(name) + " " + what);
}

} // namespace rimpact::fe
