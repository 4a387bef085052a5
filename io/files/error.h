/// Errors a user can cause or meet, each with the exit code of docs/interface.md (0 done, 1 a bug, ...).
#pragma once
#include <stdexcept>
#include <string>

namespace rimpact {

enum class ExitCode {
  done = 0,
  bug = 1,
  input = 2,        ///< the command line or any TOML
  data = 3,         ///< a data file: AT2, CSV, msh, h5
  stopped = 4,      ///< the solver stopped; partial results and a checkpoint are kept
  gate = 5,         ///< a gate of `calibrate` or `study` was not met
  io = 6,           ///< reading or writing failed
  interrupted = 130 ///< Ctrl-C; resumable
};

/// Base of every error that carries one clear sentence for the user.
class Error : public std::runtime_error {
public:
  Error(ExitCode code, const std::string &sentence) : std::runtime_error(sentence), code_(code) {}
  ExitCode code() const { return code_; }

private:
  ExitCode code_;
};

/// Bad command line or TOML: names file, line, column, value and bound where known.
struct InputError : Error {
  explicit InputError(const std::string &sentence) : Error(ExitCode::input, sentence) {}
};
/// Bad data file (record, response, mesh).
struct DataError : Error {
  explicit DataError(const std::string &sentence) : Error(ExitCode::data, sentence) {}
};
/// The solver gave up after cutting and retrying.
struct SolverStopped : Error {
  explicit SolverStopped(const std::string &sentence) : Error(ExitCode::stopped, sentence) {}
};
struct GateError : Error {
  explicit GateError(const std::string &sentence) : Error(ExitCode::gate, sentence) {}
};
struct IoError : Error {
  explicit IoError(const std::string &sentence) : Error(ExitCode::io, sentence) {}
};
struct Interrupted : Error {
  Interrupted() : Error(ExitCode::interrupted, "interrupted; resume with --resume") {}
};

} // namespace rimpact
