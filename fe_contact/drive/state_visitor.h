/// Walks over what a checkpoint keeps, as KeyVisitor does over the keys of a file: a function `visit` names every field
/// of a type once, and the writer and the reader are visitors. A field is an array of numbers or a text, by its name.
#pragma once
#include "fe_contact/drive/checkpoint.h"
#include "io/files/choice.h"
#include <concepts>
#include <Eigen/Core>
#include <functional>
#include <utility>

namespace rimpact::fe {

class StateVisitor {
public:
  virtual ~StateVisitor() = default;
  /// True: values are taken out of the file, and the reader throws DataError for what they cannot be.
  virtual bool reads() const = 0;
  /// An array as long as it is; the reader takes any length where `any_length`.
  virtual void numbers(const std::string &name, std::vector<double> &values, Limits limits = {},
                       bool any_length = false) = 0;
  virtual void text(const std::string &name, std::string &text) = 0;
  /// Throws DataError that says what is wrong with a field.
  [[noreturn]] virtual void damaged(const std::string &name, const std::string &what) const = 0;

  void number(const std::string &name, double &value, Limits limits = {});
  void flag(const std::string &name, bool &value);
  void vector(const std::string &name, Eigen::VectorXd &values);
  template <std::integral Whole> void integer(const std::string &name, Whole &value, double low, double high) {
    double written = static_cast<double>(value);
    number(name, written, {low, high, true});
    value = static_cast<Whole>(written);
  }
  template <Worded E> void choice(const std::string &name, E &value) {
    std::string written = word(value);
    text(name, written);
    const auto known = parse<E>(written);
    if (!known) damaged(name, "is no word of its list");
    value = *known;
  }
  /// One number or more of each thing of a list, `at(thing)` pointing to the first of `width`.
  template <class T, class At>
  void rows(const std::string &name, std::vector<T> &list, int width, const At &at, Limits limits = {}) {
    std::vector<double> all(list.size() * static_cast<std::size_t>(width));
    auto next = all.begin();
    if (!reads())
      for (T &thing : list) next = std::copy_n(at(thing), width, next);
    numbers(name, all, limits);
    if (!reads()) return;
    for (T &thing : list) {
      std::copy_n(next, width, at(thing));
      next += width;
    }
  }
  template <class T> void column(const std::string &name, std::vector<T> &list, double T::*entry, Limits limits = {}) {
    rows(
        name, list, 1, [entry](T &thing) { return &(thing.*entry); }, limits);
  }
  void points(const std::string &name, std::vector<Eigen::Vector3d> &list);
  void point(const std::string &name, Eigen::Vector3d &value, Limits limits = {});
  /// Whole numbers, or what is kept as such.
  template <class Code> void codes(const std::string &name, std::vector<Code> &list, double low, double high) {
    std::vector<double> all;
    for (const Code code : list) all.push_back(static_cast<double>(code));
    numbers(name, all, {low, high, true});
    for (std::size_t k = 0; k < all.size(); ++k) list[k] = static_cast<Code>(static_cast<int>(all[k]));
  }
  /// As many things as there are, at most `most`; the reader makes them by `fresh`.
  template <class T, class Fresh>
  void length(const std::string &name, std::vector<T> &list, double most, const Fresh &fresh) {
    std::size_t n = list.size();
    integer(name, n, 0, most);
    while (list.size() < n) list.push_back(fresh());
  }
  /// The names of what `body` visits begin with `part_`.
  void part(const std::string &part, const std::function<void()> &body);

protected:
  std::string full(const std::string &name) const { return prefix_ + name; }

private:
  std::string prefix_;
};

class StateWriter : public StateVisitor {
public:
  explicit StateWriter(Checkpoint &file) : file_(file) {}
  bool reads() const override { return false; }
  void numbers(const std::string &name, std::vector<double> &values, Limits limits, bool any_length) override;
  void text(const std::string &name, std::string &text) override;
  [[noreturn]] void damaged(const std::string &name, const std::string &what) const override;

private:
  Checkpoint &file_;
};

class StateReader : public StateVisitor {
public:
  explicit StateReader(const Checkpoint &file) : file_(file) {}
  bool reads() const override { return true; }
  void numbers(const std::string &name, std::vector<double> &values, Limits limits, bool any_length) override;
  void text(const std::string &name, std::string &text) override;
  [[noreturn]] void damaged(const std::string &name, const std::string &what) const override;

private:
  const Checkpoint &file_;
};

} // namespace rimpact::fe
