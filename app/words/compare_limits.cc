#include "app/words/compare_limits.h"

#include "app/words/assignments.h"
#include "io/files/error.h"
#include "io/files/json_text.h"
#include "io/files/text.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

namespace rimpact::app {
namespace {

constexpr double largest_limit = 1e6; // % or ms

/// "within 5 %".
std::string within(const FigureLimit &limit) {
  return fmt::format("within {:g} {}", limit.most, limit.figure->unit);
}

std::string result_of(const Verdict &verdict) {
  return in_words(*verdict.limit.figure, verdict.value) + (verdict.met ? "" : verdict.value ? " beyond" : " not known");
}

/// For XML: its five signs, a question mark for what XML cannot hold, and the replacement character for bytes that are
/// no text, as names of folders may have them.
std::string escaped(const std::string &bytes) {
  const auto text = nlohmann::json::parse(json_text(nlohmann::json(bytes))).get<std::string>();
  constexpr unsigned char first_printable = 0x20;
  std::string safe;
  for (const char c : text) switch (c) {
    case '&':
      safe += "&amp;";
      break;
    case '<':
      safe += "&lt;";
      break;
    case '>':
      safe += "&gt;";
      break;
    case '"':
      safe += "&quot;";
      break;
    case '\'':
      safe += "&apos;";
      break;
    default:
      safe += static_cast<unsigned char>(c) < first_printable ? '?' : c;
    }
  return safe;
}

std::size_t not_met(const Judged &judged) {
  return std::count_if(judged.verdicts.begin(), judged.verdicts.end(), [](const auto &each) { return !each.met; });
}

std::string failure_of(const Verdict &verdict) {
  if (!verdict.why.empty()) return verdict.why;
  return fmt::format("{} against A, {} is allowed", in_words(*verdict.limit.figure, verdict.value),
                     within(verdict.limit));
}

} // namespace

std::vector<FigureLimit> limits_of(const std::vector<std::string> &words) {
  const auto given = values_of(words, "--max");
  std::vector<std::string> known;
  for (const auto &figure : compared_figures()) known.emplace_back(figure.name);
  std::vector<FigureLimit> limits;
  for (const auto &[name, most] : given) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw InputError("--max " + unknown_word(name, known));
    if (!(most >= 0 && most <= largest_limit))
      throw InputError(fmt::format("--max {}={:g} must be from 0 to {:g}", name, most, largest_limit));
  }
  for (const auto &figure : compared_figures())
    if (const auto found = given.find(figure.name); found != given.end()) limits.push_back({&figure, found->second});
  return limits;
}

Judged judge(const std::vector<FigureLimit> &limits, const calibration::Comparison &metrics, const std::string &doubt) {
  Judged judged;
  for (const auto &limit : limits) {
    Verdict verdict{.limit = limit, .value = value_of(*limit.figure, metrics), .met = false};
    if (!doubt.empty())
      verdict.why = doubt;
    else if (!verdict.value)
      verdict.why = metrics.notes.empty() ? "it is not known" : metrics.notes.front();
    else
      verdict.met = std::abs(*verdict.value) <= limit.most;
    judged.verdicts.push_back(verdict);
  }
  return judged;
}

std::string text_of(const std::vector<Judged> &all) {
  if (all.empty() || all.front().verdicts.empty()) return "";
  std::string text = "limits (--max)\n";
  for (std::size_t k = 0; k < all.front().verdicts.size(); ++k) {
    const auto &limit = all.front().verdicts[k].limit;
    text += fmt::format("{:20s}", limit.figure->title);
    for (const auto &judged : all) {
      const auto &verdict = judged.verdicts[k];
      text += fmt::format(" {:>20s}", verdict.met ? "met" : verdict.value ? "NOT MET" : "NOT KNOWN");
    }
    text += fmt::format("   {}\n", within(limit));
  }
  return text;
}

nlohmann::json to_json(const Judged &judged) {
  auto rows = nlohmann::json::array();
  for (const auto &verdict : judged.verdicts) {
    const auto &figure = *verdict.limit.figure;
    rows.push_back({{"name", figure.name},
                    {"title", figure.title},
                    {"unit", figure.unit},
                    {"limit", verdict.limit.most},
                    {"value", verdict.value ? nlohmann::json(*verdict.value) : nlohmann::json()},
                    {"met", verdict.met},
                    {"why", verdict.met ? "" : failure_of(verdict)}});
  }
  return rows;
}

std::string junit_of(const std::string &reference, const std::vector<Judged> &all) {
  std::size_t n = 0, failed = 0;
  std::string cases;
  for (const auto &judged : all) {
    n += judged.verdicts.size(), failed += not_met(judged);
    for (const auto &verdict : judged.verdicts) {
      cases += fmt::format("    <testcase classname=\"{}\" name=\"{} {}\"", escaped(judged.path),
                           escaped(verdict.limit.figure->title), escaped(within(verdict.limit)));
      cases += verdict.met ? fmt::format("><system-out>{}</system-out></testcase>\n", escaped(result_of(verdict)))
                           : fmt::format("><failure message=\"{}\">{}</failure></testcase>\n",
                                         escaped(result_of(verdict)), escaped(failure_of(verdict)));
    }
  }
  return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
                     "  <testsuite name=\"rimpact compare {}\" tests=\"{}\" failures=\"{}\" errors=\"0\">\n{}"
                     "  </testsuite>\n</testsuites>\n",
                     escaped(reference), n, failed, cases);
}

void require_met(const std::vector<Judged> &all) {
  std::size_t n = 0, failed = 0;
  std::string sentences;
  for (const auto &judged : all) {
    n += judged.verdicts.size(), failed += not_met(judged);
    for (const auto &verdict : judged.verdicts)
      if (!verdict.met)
        sentences += fmt::format("{}{}: {}: {}", sentences.empty() ? "" : "; ", judged.name,
                                 verdict.limit.figure->title, failure_of(verdict));
  }
  if (failed > 0) throw GateError(fmt::format("{} of {} limits are not met: {}", failed, n, sentences));
}

} // namespace rimpact::app
