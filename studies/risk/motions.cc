#include "studies/risk/motions.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/loose_csv.h"
#include "io/files/text.h"
#include "studies/risk/far_field_set.h"
#include "studies/risk/record_shelf.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <set>

namespace rimpact::risk {
namespace {

/// One row of the table that names a record at a level.
struct Listed {
  std::string table;
  std::size_t line;
  std::string rsn, component; ///< component: as printed, may be empty
  double factor;              ///< 0: the table has none
  bool is_fitted = true;      ///< its factor makes one component meet the level; PEER's search fits whole spectra
};
using Levels = std::map<double, std::vector<Listed>>; ///< by the column `level`

/// The intensity of a return period, or the other way round: on the hazard's lines.
double intensity_at(const std::vector<reliability::HazardPoint> &points, double years) {
  const reliability::HazardCurve hazard(points);
  double low = points.front().intensity / 100, high = points.back().intensity * 100;
  for (int i = 0; i < 200; ++i) {
    const double middle = std::sqrt(low * high);
    (hazard.rate(middle) * years > 1 ? low : high) = middle;
  }
  for (const auto &point : points) // exactly, where it is one of the points
    if (point.return_period_years == years) return point.intensity;
  return std::sqrt(low * high);
}

bool same_value(const std::string &cell, const std::string &wanted) {
  if (cell == wanted) return true;
  const auto a = to_number(cell), b = to_number(wanted);
  return a && b && *a == *b;
}

Levels read_levels(const MotionSource &source) {
  std::vector<std::string> columns{source.level_column, source.rsn_column};
  for (const auto *name : {&source.component_column, &source.factor_column})
    if (!name->empty()) columns.push_back(*name);
  for (const auto &[name, value] : source.where) columns.push_back(name);
  const LooseTable table(read_file(source.table), source.table, columns);
  Levels levels;
  for (const auto &row : table.rows()) {
    const auto wanted = [&](const auto &entry) { return same_value(table.text(row, entry.first), entry.second); };
    if (!std::all_of(source.where.begin(), source.where.end(), wanted)) continue;
    Listed listed{source.table, row.line, table.text(row, source.rsn_column), "", 0};
    if (!source.component_column.empty()) listed.component = table.text(row, source.component_column);
    if (!source.factor_column.empty()) {
      listed.factor = table.number(row, source.factor_column);
      if (!(listed.factor > 0))
        throw DataError(fmt::format("{}:{}: {} {} of RSN {} must be > 0", source.table, row.line, source.factor_column,
                                    listed.factor, listed.rsn));
    }
    const double level = table.number(row, source.level_column);
    if (!(level > 0))
      throw DataError(fmt::format("{}:{}: {} {} must be > 0", source.table, row.line, source.level_column, level));
    levels[level].push_back(std::move(listed));
  }
  if (levels.empty())
    throw DataError(fmt::format("{}: no row has the values that motions.where asks for", source.table));
  return levels;
}

/// Results of PEER's search, one a level: a block of rows behind remarks, names of columns with blanks.
Levels read_sets(const MotionSource &source) {
  const std::string rsn = "Record Sequence Number", factor = "Scale Factor";
  Levels levels;
  for (const auto &set : source.sets) {
    const LooseTable table(read_file(set.search_results), set.search_results, {rsn, factor});
    for (const auto &row : table.rows()) {
      Listed listed{set.search_results, row.line, table.text(row, rsn), "", table.number(row, factor), false};
      if (!(listed.factor > 0))
        throw DataError(fmt::format("{}:{}: {} {} of RSN {} must be > 0", listed.table, row.line, factor, listed.factor,
                                    listed.rsn));
      levels[set.level].push_back(std::move(listed));
    }
  }
  return levels;
}

/// "IMPVALL.H\H-CAL225.AT2" is RSN163_IMPVALL.H_H-CAL225.AT2.
bool is_named(const std::string &file, const std::string &component) {
  std::string name = upper(component);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '\\' || c == '/'; }, '_');
  if (!name.ends_with(".AT2")) name += ".AT2";
  const std::string own = upper(std::filesystem::path(file).filename().string());
  return own == name || own.ends_with("_" + name);
}

/// Fills one level from the rows that list it.
class LevelFiller {
public:
  LevelFiller(const MotionSource &source, RecordShelf &shelf, Motions &result, MotionLevel &level)
      : source_(source), shelf_(shelf), result_(result), level_(level) {}

  void fill(const std::vector<Listed> &rows) {
    level_.n_listed = static_cast<int>(rows.size());
    std::map<std::string, std::vector<const Listed *>> by_record;
    for (const auto &row : rows) by_record[row.rsn].push_back(&row);
    for (const auto &[rsn, twins] : by_record) add(rsn, twins);
  }

private:
  double misfit(const Listed &row, const std::string &file) {
    return std::abs(std::log(row.factor * shelf_.sa_g(file) / level_.intensity_g));
  }
  bool meets(const Listed &row, const std::string &file) {
    const double off = std::abs(row.factor * shelf_.sa_g(file) / level_.intensity_g - 1);
    return off <= std::max(level_tolerance, factor_rounding / row.factor);
  }
  void miss(const Listed &row, const std::string &why) {
    result_.missing.push_back(fmt::format("{}:{}: RSN {}{}{} at {:.4g} g: {}", row.table, row.line, row.rsn,
                                          row.component.empty() ? "" : " ", row.component, level_.intensity_g, why));
  }

  void add(const std::string &rsn, const std::vector<const Listed *> &twins) {
    if (twins.size() > 2 || (twins.size() == 2 && source_.component == ComponentRule::printed &&
                             twins[0]->component == twins[1]->component))
      throw DataError(fmt::format("{}:{}: RSN {} {} stands more than once at {:.4g} g (also in line {})",
                                  twins.back()->table, twins.back()->line, rsn, twins.back()->component,
                                  level_.intensity_g, twins.front()->line));
    const auto files = shelf_.components(rsn);
    if (files.empty())
      for (const auto *row : twins) miss(*row, "no file at hand");
    else if (source_.component == ComponentRule::printed)
      for (const auto *row : twins) add_printed(*row, files);
    else
      add_nearest(twins, files);
  }

  void add_printed(const Listed &row, const std::vector<std::string> &files) {
    const auto file =
        std::find_if(files.begin(), files.end(), [&](const auto &path) { return is_named(path, row.component); });
    if (file == files.end()) return miss(row, "this component is not at hand");
    take(row, *file);
  }

  void add_nearest(const std::vector<const Listed *> &twins, const std::vector<std::string> &files) {
    const bool known = twins.front()->factor > 0;
    if (!known) { // nothing tells the components apart: the first ones, in the order of their names
      for (std::size_t i = 0; i < twins.size(); ++i)
        i < files.size() ? take(*twins[i], files[i]) : miss(*twins[i], "its other component is not at hand");
      return;
    }
    const bool must_meet = twins.front()->is_fitted && source_.scale == ScaleRule::factor;
    if (files.size() == 1 && !must_meet) {
      take(*twins[0], files[0]);
      if (twins.size() > 1) miss(*twins[1], "its other component is not at hand");
      return;
    }
    if (files.size() == 1) {
      const auto meeting = std::find_if(twins.begin(), twins.end(), [&](const auto *r) { return meets(*r, files[0]); });
      for (auto row = twins.begin(); row != twins.end(); ++row)
        row == meeting ? take(**row, files[0]) : miss(**row, "the component that meets the level is not at hand");
      return;
    }
    const auto nearest = [&](const Listed &row) {
      return *std::min_element(files.begin(), files.end(),
                               [&](const auto &a, const auto &b) { return misfit(row, a) < misfit(row, b); });
    };
    if (twins.size() == 1) return take(*twins[0], nearest(*twins[0]));
    const bool straight = misfit(*twins[0], files[0]) + misfit(*twins[1], files[1]) <=
                          misfit(*twins[0], files[1]) + misfit(*twins[1], files[0]);
    take(*twins[0], files[straight ? 0 : 1]), take(*twins[1], files[straight ? 1 : 0]);
  }

  void take(const Listed &row, const std::string &file) {
    const double sa = shelf_.sa_g(file);
    Motion motion{.file = file, .record = "RSN" + row.rsn, .line = row.line};
    const bool by_factor = source_.scale == ScaleRule::factor && row.factor > 0;
    motion.scale = by_factor ? row.factor : level_.intensity_g / sa;
    motion.over_level = motion.scale * sa / level_.intensity_g;
    if (row.factor > 0 && row.is_fitted && !meets(row, file))
      result_.doubts.push_back(fmt::format(
          "{}:{}: RSN {} times {} has S_a {:.4g} g, {:+.1f} % off its level of {:.4g} g", row.table, row.line, row.rsn,
          row.factor, row.factor * sa, 100 * (row.factor * sa / level_.intensity_g - 1), level_.intensity_g));
    level_.motions.push_back(std::move(motion));
  }

  const MotionSource &source_;
  RecordShelf &shelf_;
  Motions &result_;
  MotionLevel &level_;
};

/// Every record of the folders, scaled to a level. One without the pair that its measure asks for is told.
MotionLevel level_of_folders(double intensity_g, Measure measure, RecordShelf &shelf,
                             std::vector<std::string> &missing) {
  MotionLevel level{.intensity_g = intensity_g};
  for (const auto &file : shelf.all()) {
    ++level.n_listed;
    double unscaled = 0; // [g]
    if (measure == Measure::component) {
      unscaled = shelf.sa_g(file);
    } else if (const auto rotated = shelf.rotated_g(file)) {
      unscaled = measure == Measure::rotd50 ? rotated->rotd50 : rotated->rotd100;
    } else {
      missing.push_back(
          fmt::format("{} at {:.4g} g: it is of no pair, which {} asks for", file, intensity_g, word(measure)));
      continue;
    }
    level.motions.push_back({.file = file,
                             .record = shelf.station(file),
                             .scale = intensity_g / unscaled,
                             .over_level = shelf.sa_g(file) / unscaled});
  }
  return level;
}

/// Bands come from drawing the records anew: of one they have no width, of a few they are too narrow.
void doubt_few_records(Motions &motions) {
  constexpr std::size_t enough = 7; // what codes of practice ask for where a mean is used
  std::set<std::string> records;
  for (const auto &level : motions.levels)
    for (const auto &motion : level.motions) records.insert(motion.record);
  if (records.size() >= enough) return;
  motions.doubts.push_back(
      records.size() == 1
          ? "one record serves every level: the bands, which come from drawing records anew, have no width, and what "
            "another record would give is not known"
          : fmt::format("{} records serve all levels: bands that come from drawing them anew are narrower than the "
                        "truth; take {} or more",
                        records.size(), enough));
}

} // namespace

Motions motions_of(const Study &study, const std::vector<std::string> &folders) {
  std::vector<std::string> all = study.motions.folders;
  all.insert(all.end(), folders.begin(), folders.end());
  RecordShelf shelf(all, study.period_s);
  const reliability::HazardCurve hazard(study.hazard);
  Motions result;
  result.doubts = shelf.questions();
  std::vector<MotionLevel> levels;
  const bool is_listed = study.motions.list == RecordList::p695_far_field;
  for (const double level : study.levels_g)
    levels.push_back(is_listed ? far_field_level(level, shelf, result.missing)
                               : level_of_folders(level, study.measure, shelf, result.missing));
  result.doubts.insert(result.doubts.end(), shelf.copies().begin(), shelf.copies().end());
  if (study.levels_g.empty())
    for (const auto &[value, rows] :
         study.motions.table.empty() ? read_sets(study.motions) : read_levels(study.motions)) {
      const bool years = study.motions.level_is == LevelKind::return_period;
      MotionLevel level{.intensity_g = years ? intensity_at(study.hazard, value) : value};
      LevelFiller(study.motions, shelf, result, level).fill(rows);
      levels.push_back(std::move(level));
    }
  for (auto &level : levels) {
    level.return_period_years = 1 / hazard.rate(level.intensity_g);
    if (level.motions.empty())
      result.doubts.push_back(fmt::format("the level {:.4g} g ({:.0f} years) has none of its {} records at hand: it is "
                                          "left out and the fragility interpolated across it",
                                          level.intensity_g, level.return_period_years, level.n_listed));
    else
      result.levels.push_back(std::move(level));
  }
  if (result.levels.empty())
    throw InputError(fmt::format("{}: no level has a record at hand; motions.folders or --records DIR name the folders "
                                 "of records",
                                 study.origin));
  doubt_few_records(result);
  return result;
}

} // namespace rimpact::risk
