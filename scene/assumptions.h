/// Which numbers of a bearing are assumptions: its file says so, by a mark or by leaving them out.
#pragma once
#include "scene/bearing.h"

namespace rimpact {
class TomlFile;
class TomlReader;
} // namespace rimpact

namespace rimpact::scene {

struct Scene;
/// Whether nobody gave the load: neither weight nor mass, or the file marks both. The scene's load_remark says so.
bool load_is_assumed(const Scene &scene);
/// With this the load_remark of such a scene ends.
inline constexpr const char *assumed_load = "an assumption";

/// The built-in bearings' own: what the thesis does not give.
AssumedKeys catalogue_marks();
/// Every number: a bearing file begins with none given.
AssumedKeys every_number();

/// Whether the comment behind a key of the file, or behind its table's header, begins with "assumption" or "assumed".
bool is_marked(const TomlFile &file, const std::string &path);

/// Whether another bearing than a built-in one has the built-in pad, for want of one in its file.
bool has_default_pad(const Bearing &bearing);

/// Takes the marks of a file whose bearing keys stand behind `prefix` ("" or "bearing."). A key that is given is the
/// user's unless its line, or its table's header, has a comment that begins with "assumption" or "assumed"; a key that
/// is not given stays as it was. The list `assumed = ["rim.height_mm"]` adds its keys. Throws InputError for a word in
/// it that is no number's key.
void read_marks(const TomlFile &file, TomlReader &reader, const std::string &prefix, Bearing &bearing);

} // namespace rimpact::scene
