"""Faults that clang-tidy must find by this repository's .clang-tidy, and sources in which it must find nothing."""
import json
import pathlib
import tempfile
from collections.abc import Callable

#: The flags that this repository gives to GCC.
FLAGS = ("-O3 -DNDEBUG -Wall -Wextra -Wpedantic -Wno-psabi -fno-math-errno -Wno-maybe-uninitialized -fno-semantic-interposition"
         " -fmacro-prefix-map=/a/=/b/ -march=native -DEIGEN_MAX_ALIGN_BYTES=16 -isystem /usr/include/eigen3 -std=c++20")
SHAPE = ("struct Shape {\n  virtual ~Shape() = default;\n  virtual double area() const { return 0; }\n};\n"
         "struct Square : Shape {\n  double area() const { return 1; }\n};\n")
USER = "double area() { return Square().area(); }\n"
FILES = {
    "library/shape.h": SHAPE,
    "ours/module/clean.cc": "#include <Eigen/Dense>\n#include <immintrin.h>\n#include <ranges>\n#include <stddef.h>\n"
                            "double length(const Eigen::Vector3d &v) { return v.norm(); }\n",
    "ours/module/moved.cc": "#include <string>\n#include <utility>\nsize_t twice(std::string text) {\n"
                            "  const std::string taken = std::move(text);\n  return taken.size() + text.size();\n}\n",
    "ours/module/null.cc": "double first(bool there) {\n  double held = 1;\n  double *p = there ? &held : nullptr;\n  if (p) held = 2;\n  return *p;\n}\n",
    "ours/module/shape.h": SHAPE,
    "ours/module/user.cc": f"#include \"module/shape.h\"\n{USER}",
    "ours/module/borrower.cc": f"#include \"library/shape.h\"\n{USER}",
    "ours/module/symbols.cc": "class Beam {\npublic:\n  double E = 1, R0 = 2;\n  double modulus(double dN) const { return E * dN * K_ * area_; }\n\n"
                              "private:\n  double K_ = 1, area_ = 1;\n};\n",
    "ours/module/member.cc": "class Beam {\n  double area = 1;\n};\n",
    "ours/module/camel.cc": "class Beam {\n  double crossSection_ = 1;\n};\n",
    "ours/module/function.cc": "double ComputeArea() { return 1; }\n",
    "ours/module/local.cc": "double area() {\n  const double Total = 1;\n  return Total;\n}\n",
    "ours/module/broken.cc": "#include \"module/missing.h\"\n",
}
#: What holds no fault, and what holds one that is a library's.
CLEAN = ("ours/module/clean.cc", "ours/module/symbols.cc", "ours/module/borrower.cc")
#: In which file, which check, found by judging which source.
EXPECTED = (("ours/module/moved.cc", "bugprone-use-after-move", "ours/module/moved.cc"),
            ("ours/module/null.cc", "clang-analyzer-core.NullDereference", "ours/module/null.cc"),
            ("ours/module/shape.h", "modernize-use-override", "ours/module/user.cc"),
            *((f"ours/module/{name}.cc", "readability-identifier-naming", f"ours/module/{name}.cc") for name in ("member", "camel", "function", "local")),
            ("ours/module/broken.cc", "clang-diagnostic-error", "ours/module/broken.cc"))


def plant(folder: pathlib.Path) -> None:
    for name, text in FILES.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    entries = [{"directory": str(folder), "file": str(folder / name), "command": f"c++ {FLAGS} -I{folder} -I{folder / 'ours'} -c {folder / name}"}
               for name in FILES if name.endswith(".cc")]
    (folder / "compile_commands.json").write_text(json.dumps(entries), encoding="utf-8")


def missed(judge: Callable[[pathlib.Path, pathlib.Path, pathlib.Path], set[str] | None]) -> int:
    """`judge` finds the faults under a folder, by the database of another, in a source. 1 where it misses one, or finds one in a clean source."""
    faults = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name).resolve()
        plant(folder)
        for file, check, source in EXPECTED:
            found = judge(folder / "ours", folder, folder / source) or set()
            hits = [finding for finding in found if finding.startswith(f"{folder / file}:") and check in finding]
            print("\n".join(hits) or f"missed: {check} in {file}; found: {sorted(found)}")
            faults += [] if hits else [check]
        wrong = [finding for source in CLEAN for finding in sorted(judge(folder / "ours", folder, folder / source) or set())]
        print("\n".join(wrong) or f"nothing in {', '.join(CLEAN)}, as it should be")
    print(f"{len(EXPECTED) - len(faults)} of {len(EXPECTED)} planted faults were found")
    return 1 if faults or wrong else 0
