// The words of a command, as the interpreter hands them on.
#pragma once
#include <deque>
#include <string>

inline std::deque<std::string> words;
inline std::string current_word;

inline int OPS_GetNumRemainingInputArgs() {
  return static_cast<int>(words.size());
}
inline const char *OPS_GetString() {
  current_word = words.front();
  words.pop_front();
  return current_word.c_str();
}
inline int OPS_GetDoubleInput(int *n, double *values) {
  for (int i = 0; i < *n; ++i) try {
      values[i] = std::stod(OPS_GetString());
    } catch (const std::exception &) {
      return -1;
    }
  return 0;
}
inline int OPS_GetIntInput(int *n, int *values) {
  for (int i = 0; i < *n; ++i) try {
      values[i] = std::stoi(OPS_GetString());
    } catch (const std::exception &) {
      return -1;
    }
  return 0;
}
