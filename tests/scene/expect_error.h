/// Expects an exception of a type whose sentence holds every one of the given words.
#pragma once
#include "io/files/error.h"
#include <gtest/gtest.h>
#include <initializer_list>
#include <string>

template <class Exception, class Action>
void expect_error(const Action &action, std::initializer_list<const char *> words) {
  try {
    action();
    ADD_FAILURE() << "nothing was thrown";
  } catch (const Exception &error) {
    const std::string sentence = error.what();
    for (const char *word : words)
      EXPECT_NE(sentence.find(word), std::string::npos) << "\"" << word << "\" is not in: " << sentence;
  }
}
