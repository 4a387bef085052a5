/// Help in the words of CLI11 2.3 whatever its version is. From 2.4 on it writes `TYPE [default]` for `TYPE=default`.
#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace rimpact::app {

class HelpFormat : public CLI::Formatter {
public:
  std::string make_option_opts(const CLI::Option *option) const override {
    std::string text = CLI::Formatter::make_option_opts(option);
    const std::string later = " [" + option->get_default_str() + "] ";
    if (const auto at = text.find(later); at != std::string::npos)
      text.replace(at, later.size(), "=" + option->get_default_str());
    return text;
  }
};

} // namespace rimpact::app
