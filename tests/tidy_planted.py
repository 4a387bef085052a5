"""Faults that clang-tidy must find by this repository's .clang-tidy, and a source in which it must find nothing."""
import json
import pathlib
import tempfile
from collections.abc import Callable

#: The flags that this repository gives to GCC.
FLAGS = ("-O3 -DNDEBUG -Wall -Wextra -Wpedantic -Wno-psabi -fno-math-errno -Wno-maybe-uninitialized -fno-semantic-interposition"
         " -fmacro-prefix-map=/a/=/b/ -march=native -DEIGEN_MAX_ALIGN_BYTES=16 -isystem /usr/include/eigen3 -std=c++20")
FILES = {
    "module/clean.cc": "#include <Eigen/Dense>\n#include <immintrin.h>\n#include <ranges>\n#include <stddef.h>\n"
                       "double length(const Eigen::Vector3d &v) { return v.norm(); }\n",
    "module/moved.cc": "#include <string>\n#include <utility>\nsize_t twice(std::string text) {\n"
                       "  const std::string taken = std::move(text);\n  return taken.size() + text.size();\n}\n",
    "module/null.cc": "double first(bool there) {\n  double held = 1;\n  double *p = there ? &held : nullptr;\n  if (p) held = 2;\n  return *p;\n}\n",
    "module/shape.h": "struct Shape {\n  virtual ~Shape() = default;\n  virtual double area() const { return 0; }\n};\n"
                      "struct Square : Shape {\n  double area() const { return 1; }\n};\n",
    "module/user.cc": "#include \"module/shape.h\"\ndouble area() { return Square().area(); }\n",
    "module/broken.cc": "#include \"module/missing.h\"\n",
}
#: In which file, which check, found by judging which source.
EXPECTED = (("module/moved.cc", "bugprone-use-after-move", "module/moved.cc"),
            ("module/null.cc", "clang-analyzer-core.NullDereference", "module/null.cc"),
            ("module/shape.h", "modernize-use-override", "module/user.cc"),
            ("module/broken.cc", "clang-diagnostic-error", "module/broken.cc"))


def plant(folder: pathlib.Path) -> None:
    for name, text in FILES.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    entries = [{"directory": str(folder), "file": str(folder / name), "command": f"c++ {FLAGS} -I{folder} -c {folder / name}"}
               for name in FILES if name.endswith(".cc")]
    (folder / "compile_commands.json").write_text(json.dumps(entries), encoding="utf-8")


def missed(judge: Callable[[pathlib.Path, pathlib.Path], set[str] | None]) -> int:
    """`judge` finds the faults of a source by the database of a folder. 1 where it misses one, or finds one in the clean source."""
    faults = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name).resolve()
        plant(folder)
        for file, check, source in EXPECTED:
            found = judge(folder, folder / source) or set()
            hits = [finding for finding in found if finding.startswith(f"{folder / file}:") and check in finding]
            print("\n".join(hits) or f"missed: {check} in {file}; found: {sorted(found)}")
            faults += [] if hits else [check]
        clean = judge(folder, folder / "module/clean.cc") or set()
        print("\n".join(sorted(clean)) or "nothing in module/clean.cc, as it should be")
    print(f"{len(EXPECTED) - len(faults)} of {len(EXPECTED)} planted faults were found")
    return 1 if faults or clean else 0
