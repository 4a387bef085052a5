/// Readers meet any bytes: each either understands them or throws one of the toolkit's own errors.
#include "io/files/error.h"
#include "io/records/record.h"
#include "responses/response_csv.h"
#include "scene/scene.h"
#include "scene/toml_writer.h"
#include <gtest/gtest.h>
#include <random>

namespace {
using namespace rimpact;
using namespace rimpact::scene;

/// Changes, cuts, repeats and inserts a few pieces.
std::string mutate(std::string text, std::mt19937 &random) {
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
  static const std::string zero("\0\xff", 2);
  static const std::string spice[] = {"nan", "inf", "-1",  "1e999", "=",  "[", "]]",         "\"",           ".",
                                      "\n",  zero,  "'''", "{",     "0x", "-", "1979-05-27", "\xEF\xBB\xBF", ",,",
                                      "#",   "+",   "E",   "a.b.c"};
  for (std::size_t n = 1 + below(4); n > 0; --n) {
    const std::size_t at = below(text.size() + 1);
    switch (below(4)) {
    case 0:
      text.insert(at, spice[below(std::size(spice))]);
      break;
    case 1:
      text.erase(at, below(20));
      break;
    case 2:
      text.insert(at, text.substr(below(text.size()), below(40)));
      break;
    default:
      if (at < text.size()) text[at] = static_cast<char>(random());
    }
  }
  return text;
}

template <class Read> void survive(const std::string &seed_text, int n, const Read &read) {
  std::mt19937 random(12345);
  int understood = 0;
  for (int i = 0; i < n; ++i) {
    const std::string text = mutate(seed_text, random);
    try {
      read(text);
      ++understood;
    } catch (const Error &) { // said so
    } catch (const std::exception &error) {
      FAIL() << "not one of our errors: " << error.what() << "\nfor: " << text;
    }
  }
  EXPECT_GT(understood, n / 100) << "the mutations are too wild to test anything";
  EXPECT_LT(understood, n) << "and too tame";
}

TEST(AnyBytes, Scenes) {
  survive(to_toml(load_scene("impact-window")), 3000, [](const std::string &text) { parse_scene(text, "fuzz.toml"); });
}

TEST(AnyBytes, Overrides) {
  survive("bearing.rim.height_mm=60", 2000, [](const std::string &text) { load_scene("ricker-0.78g-1.0s", {text}); });
}

TEST(AnyBytes, At2) {
  std::string text = "a\nb\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 40, DT= .01 SEC\n";
  for (int i = 0; i < 10; ++i) text += " -.1234567E-02 .5 1.0D-3-.25E+0\n";
  survive(text, 20000, [](const std::string &bytes) { parse_at2(bytes, "fuzz.AT2", 9.81); });
}

TEST(AnyBytes, Csv) {
  std::string record = "time_s,acceleration_g\n", response = "time_s,ux_m,uy_m,Fx_N,Fy_N,gap_m\n";
  for (int i = 0; i < 10; ++i) record += std::to_string(i) + ",0.1\n", response += std::to_string(i) + ",1,2,3,4,5\n";
  survive(record, 10000, [](const std::string &bytes) { parse_record_csv(bytes, "fuzz.csv", 9.81); });
  survive(response, 10000, [](const std::string &bytes) { parse_csv(bytes, "fuzz.csv"); });
}

TEST(AnyBytes, DeepNestingIsRefused) {
  std::string dots = "a", brackets = "x = ";
  for (int i = 0; i < 200000; ++i) dots += ".a", brackets += "[";
  EXPECT_THROW(parse_scene(dots + " = 1", "deep.toml"), InputError);
  EXPECT_THROW(parse_scene(brackets, "deep.toml"), InputError);
  std::string long_dots = "a", quoted = "\"a\"", digits = "1";
  for (int i = 0; i < 250000; ++i) long_dots += ".a", quoted += ".\"a\"", digits += ".1";
  EXPECT_THROW(parse_scene(long_dots.substr(0, 1 << 20) + " = 1", "deep.toml"), InputError); // a megabyte of a.a.a
  EXPECT_THROW(parse_scene("[" + long_dots + "]\nx = 1", "deep.toml"), InputError);
  EXPECT_THROW(parse_scene("x = {" + long_dots + " = 1}", "deep.toml"), InputError);
  EXPECT_THROW(parse_scene("name = '''" + std::string("a'''\n") + long_dots + " = 1", "deep.toml"), InputError);
  EXPECT_THROW(parse_scene(quoted + " = 1", "deep.toml"), InputError);
  EXPECT_THROW(parse_scene(digits + " = 1", "deep.toml"), InputError);
  EXPECT_THROW(parse_scene(std::string(3 << 20, ' '), "long.toml"), InputError);
}

} // namespace
