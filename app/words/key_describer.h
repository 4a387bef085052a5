/// Describes the keys that a visit walks over.
#pragma once
#include "app/words/key_catalogue.h"
#include "io/files/path_visitor.h"
#include <map>

namespace rimpact::app {

/// Writes down kind and range of every key; its value comes from presets_of where it does not follow from other keys.
class KeyDescriber final : public PathVisitor {
public:
  explicit KeyDescriber(std::string prefix = "") : PathVisitor(std::move(prefix)) {}
  std::vector<KeyDescription> keys;
  std::vector<std::pair<std::string, std::vector<std::string>>> choices;

  bool wants(bool) const override { return true; }
  void number(const Key &key, double &value, Unit unit, Range range) override;
  void limit(const Key &key, std::optional<double> &value, Unit unit, Range range) override;
  void integer(const Key &key, int &value, int low, int high) override;
  void flag(const Key &key, bool &value) override;
  void text(const Key &key, std::string &value) override;
  void word(const Key &key, std::string &value, const std::vector<std::string> &options) override;
  void pair(const Key &key, Eigen::Vector2d &value, Range range) override;
  void numbers(const Key &key, std::vector<double> &values, Unit unit, Range range) override;
  void rows(const Key &key, Rows &rows, const std::array<Column, 2> &columns) override;
  void switches(const Key &key, const std::vector<std::pair<std::string, bool *>> &flags) override;

private:
  void add(const Key &key, const char *kind, std::string range);
};

/// What a visit's keys hold where the file is silent, as TOML writes it, by path.
std::map<std::string, std::string> presets_of(const std::function<void(KeyVisitor &)> &visit,
                                              const std::string &section = "");

} // namespace rimpact::app
