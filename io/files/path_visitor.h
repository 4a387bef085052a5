/// A visitor of keys that knows where it stands.
#pragma once
#include "io/files/key_visitor.h"

namespace rimpact {

class PathVisitor : public KeyVisitor {
public:
  void section(const char *name, const std::function<void()> &body) final {
    const std::string outer = prefix_;
    prefix_ += std::string(name) + ".";
    body();
    prefix_ = outer;
  }

protected:
  /// `prefix`: of the tables around what is visited; ends in a dot where it is not empty.
  explicit PathVisitor(std::string prefix = "") : prefix_(std::move(prefix)) {}
  std::string path(const Key &key) const { return prefix_ + key.name; } ///< dotted, as a file has it

private:
  std::string prefix_;
};

} // namespace rimpact
