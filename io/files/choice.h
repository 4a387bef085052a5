/// Choices: an enumeration and, beside it, the one table of the words that files write for its values.
///
///   enum class Friction { coulomb, park_wen };
///   constexpr auto choices(Friction) {
///     return choices_of<Friction>({{Friction::coulomb, "coulomb"}, {Friction::park_wen, "park-wen"}});
///   }
///
/// Words are parsed where a file, a table or the command line is read, and written back by `word`; nothing in between
/// compares them. Readers, writers and the list of keys take the table (KeyVisitor::choice).
#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rimpact {

/// One line of the table.
template <class E> struct Choice {
  E value;
  const char *word;
  const char *description = ""; ///< behind the word in lists; empty: the word says it
};

/// The table, in the order in which words are listed.
template <class E, std::size_t n> constexpr std::array<Choice<E>, n> choices_of(const Choice<E> (&lines)[n]) {
  return std::to_array(lines);
}

/// An enumeration whose table `choices(E)` stands beside it.
template <class E>
concept Worded = requires(E value) {
  { choices(value).front() } -> std::convertible_to<Choice<E>>;
};

/// The value's word, as files write it.
template <Worded E> std::string word(E value) {
  for (const auto &choice : choices(value))
    if (choice.value == value) return choice.word;
  return "unknown"; // a bug: every value has a line
}

/// What stands behind the value's word in lists.
template <Worded E> std::string description(E value) {
  for (const auto &choice : choices(value))
    if (choice.value == value) return choice.description;
  return "unknown"; // a bug: every value has a line
}

/// The value that is written so; none: it is no word of the table (see `words` and unknown_word for the error).
template <Worded E> constexpr std::optional<E> parse(std::string_view written) {
  for (const auto &choice : choices(E{}))
    if (written == choice.word) return choice.value;
  return std::nullopt;
}

/// Every word, in the table's order.
template <Worded E> std::vector<std::string> words() {
  std::vector<std::string> list;
  for (const auto &choice : choices(E{})) list.emplace_back(choice.word);
  return list;
}

/// The table in a line: "circle: the slider's whole edge | points: only where the contact points are".
template <Worded E> const char *words_in_line() {
  static const std::string line = [] {
    std::string text;
    for (const auto &choice : choices(E{})) {
      text += (text.empty() ? "" : " | ") + std::string(choice.word);
      if (*choice.description) text += ": " + std::string(choice.description);
    }
    return text;
  }();
  return line.c_str();
}

} // namespace rimpact
