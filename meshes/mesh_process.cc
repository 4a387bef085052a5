#include "meshes/mesh_process.h"

#include "io/files/error.h"
#include "meshes/gmsh_session.h"
#include "meshes/mesh_kind.h"
#include "meshes/sandbox.h"
#include "meshes/surface_list.h"
#include <algorithm>
#include <climits>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rimpact::meshes {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SizeOn, shape, centre, radius, size)

namespace {

using nlohmann::json;

json request(const scene::OwnMesh &own, const DrawingUse &use) {
  return {{"file", own.file},
          {"unit", own.unit},
          {"size", own.size},
          {"contact_size", own.contact_size},
          {"groups", own.groups},
          {"sizes", use.sizes},
          {"pad_is_tied", use.pad_is_tied}};
}

scene::OwnMesh own_of(const json &r) {
  scene::OwnMesh own;
  r.at("file").get_to(own.file), r.at("unit").get_to(own.unit), r.at("groups").get_to(own.groups);
  r.at("size").get_to(own.size), r.at("contact_size").get_to(own.contact_size);
  return own;
}

DrawingUse use_of(const json &r) {
  DrawingUse use;
  r.at("sizes").get_to(use.sizes), r.at("pad_is_tied").get_to(use.pad_is_tied);
  return use;
}

/// Arrays of numbers as their bytes: both ends run on one machine.
template <class T> json bytes_of(const std::vector<T> &values) {
  const auto *begin = reinterpret_cast<const std::uint8_t *>(values.data());
  return json::binary({begin, begin + values.size() * sizeof(T)});
}
template <class T> void from_bytes(const json &binary, std::vector<T> &values) {
  const auto &bytes = binary.get_binary();
  values.resize(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
}

std::vector<std::uint8_t> packed(const DrawnMesh &drawn) {
  const HexMesh &m = drawn.mesh;
  return json::to_cbor({{"divided", drawn.divided},
                        {"nodes", bytes_of(m.nodes)},
                        {"cells", bytes_of(m.cells)},
                        {"volumes", bytes_of(m.volumes)},
                        {"faces", bytes_of(m.faces)}});
}
DrawnMesh unpacked(const json &answer) {
  DrawnMesh drawn;
  answer.at("divided").get_to(drawn.divided);
  from_bytes(answer.at("nodes"), drawn.mesh.nodes), from_bytes(answer.at("cells"), drawn.mesh.cells);
  from_bytes(answer.at("volumes"), drawn.mesh.volumes), from_bytes(answer.at("faces"), drawn.mesh.faces);
  return drawn;
}

void write_all(int to, const std::vector<std::uint8_t> &bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = write(to, bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return; // nobody listens: the reader's status tells why
    done += static_cast<std::size_t>(n);
  }
}
std::vector<std::uint8_t> read_all(int from) {
  std::vector<std::uint8_t> bytes, part(1 << 16);
  for (ssize_t n; (n = read(from, part.data(), part.size())) != 0;) {
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) break;
    bytes.insert(bytes.end(), part.begin(), part.begin() + n);
  }
  return bytes;
}

struct Pipe {
  int ends[2];
  Pipe() {
    if (pipe2(ends, O_CLOEXEC) != 0) throw IoError("cannot open a pipe to rimpact-gmsh");
  }
  ~Pipe() { shut(0), shut(1); }
  void shut(int end) {
    if (ends[end] >= 0) close(ends[end]);
    ends[end] = -1;
  }
};

std::string reader_program() {
  char path[PATH_MAX] = {};
  const ssize_t n = readlink("/proc/self/exe", path, sizeof path - 1);
  const auto program = std::filesystem::path(n > 0 ? path : "").parent_path() / "rimpact-gmsh";
  if (access(program.c_str(), X_OK) != 0)
    throw IoError(program.string() + " is missing: it reads meshes; build it (ninja rimpact-gmsh)");
  return program;
}

pid_t spawn(const Pipe &to, const Pipe &from) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, to.ends[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, from.ends[1], STDOUT_FILENO);
  std::string program = reader_program();
  char *words[] = {program.data(), nullptr};
  pid_t process = -1;
  const int error = posix_spawn(&process, program.c_str(), &actions, nullptr, words, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw IoError(program + ": cannot be started: " + std::strerror(error));
  return process;
}

/// The file under a name of its own in a folder of its own: gmsh runs what lies beside a file as FILE.opt.
class Alias {
public:
  explicit Alias(const std::string &file) {
    namespace fs = std::filesystem;
    std::string folder = (fs::temp_directory_path() / "rimpact-mesh-XXXXXX").string();
    if (!mkdtemp(folder.data())) throw IoError(folder + ": cannot be made");
    folder_ = folder;
    std::string ending = fs::path(file).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    fs::create_symlink(fs::absolute(file), folder_ / ("drawn" + ending));
    path_ = folder_ / ("drawn" + ending);
  }
  ~Alias() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Alias(const Alias &) = delete;
  std::string path() const { return path_.string(); }

private:
  std::filesystem::path folder_, path_;
};

std::string ending_of(int status) {
  if (WIFSIGNALED(status)) return fmt::format("ended by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  return fmt::format("ended without an answer (exit code {})", WEXITSTATUS(status));
}

/// What rimpact-gmsh answers of a file; `asked_by` is the key or the option that names it.
json answer_of(const std::string &file, const char *asked_by, json asked) {
  const auto fail = [&](const std::string &what) { throw DataError(fmt::format("{}: {}", file, what)); };
  if (!std::filesystem::exists(file)) fail(fmt::format("no such mesh file ({})", asked_by));
  require_safe(file);
  Pipe to, from;
  const pid_t process = spawn(to, from);
  to.shut(0), from.shut(1);
  const Alias alias(file);
  asked["path"] = alias.path();
  write_all(to.ends[1], json::to_cbor(asked));
  to.shut(1);
  const auto bytes = read_all(from.ends[0]);
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  json answer = json::from_cbor(bytes, true, false);
  if (!answer.is_object()) fail("the mesh reader " + ending_of(status) + ": the file cannot be read or meshed");
  if (answer.contains("error")) throw DataError(answer["error"].get<std::string>());
  return answer;
}

/// Of a file that is only looked at.
json listed(const std::string &path, const std::string &file) {
  const GmshSession session;
  try {
    gmsh::model::add("drawn");
    gmsh::merge(path);
    return {{"bodies", surfaces_of_model()}};
  } catch (const std::string &message) { // what gmsh 4.8 throws
    throw DataError(fmt::format("{}: gmsh cannot read it: {}", file, message));
  }
}

} // namespace

DrawnMesh read_mesh_apart(const scene::OwnMesh &own, const DrawingUse &use) {
  return unpacked(answer_of(own.file, "model.own_mesh.file", request(own, use)));
}

json list_surfaces(const std::string &file) {
  json asked = request({.file = file, .groups = {}}, {});
  asked["list"] = true;
  return answer_of(file, "--surfaces", std::move(asked))["bodies"];
}

int serve_mesh(int input, int output) {
  constexpr unsigned long cpu_seconds = 1800;
  try {
    const json asked = json::from_cbor(read_all(input));
    const scene::OwnMesh own = own_of(asked);
    const bool script = require_safe(own.file) == MeshKind::script;
    const auto memory = 3ul * static_cast<unsigned long>(sysconf(_SC_PHYS_PAGES)) *
                        static_cast<unsigned long>(sysconf(_SC_PAGESIZE)) / 4;
    if (!confine(cpu_seconds, memory) && script)
      throw DataError(own.file + ": this system cannot confine a script (no seccomp); save it as .msh in gmsh");
    if (asked.contains("list"))
      write_all(output, json::to_cbor(listed(asked.at("path"), own.file)));
    else
      write_all(output, packed(read_mesh(own, asked.at("path"), use_of(asked))));
    return 0;
  } catch (const std::exception &error) {
    write_all(output, json::to_cbor({{"error", error.what()}}));
    return 3;
  }
}

} // namespace rimpact::meshes
